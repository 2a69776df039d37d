#pragma once
// app/ink_clock.h -- how long a point of a stroke waits until it is seen.
#include <span>
#include <string>
#include <vector>

#include "app/hand_event.h"

namespace luminist {

/// From the window system's call to the end of the frame in which the ink is drawn, for every point of every stroke.
/// Written to the file that LUMINIST_INK_TIMES names whenever a stroke ends, as {"events", "median", "p95", "max"} in
/// seconds; without that variable nothing is kept.
class InkClock {
 public:
  InkClock();
  /// A frame ended. events: those that it took; drawing: a stroke is under way.
  void note(std::span<const HandEvent> events, bool drawing, double now);

 private:
  void write() const;
  std::string path_;  ///< "": nobody asks
  std::vector<double> seconds_;
  bool drawing_ = false;
};

}  // namespace luminist
