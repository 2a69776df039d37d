#pragma once
// app/ink_clock.h -- how long a point of a stroke waits until it is seen, and what its frames take.
#include <span>
#include <string>
#include <vector>

#include "app/hand_event.h"

namespace luminist {

/// From the window system's call to the end of the frame in which the ink is drawn, for every point of every stroke;
/// and what the frames took in which a stroke was under way, from the first look at what there is to show until the
/// window has it (where swaps wait for the screen, that too). Written to the file that LUMINIST_INK_TIMES names
/// whenever a stroke ends, as {"ink", "frames"} with {"count", "median", "p95", "max"} each, in seconds; without that
/// variable nothing is kept.
class InkClock {
 public:
  InkClock();
  /// A frame began and ended then. events: those that it took; drawing: a stroke is under way.
  void note(std::span<const HandEvent> events, bool drawing, double begin, double end);

 private:
  void write() const;
  std::string path_;  ///< "": nobody asks
  std::vector<double> ink_;
  std::vector<double> frames_;
  bool drawing_ = false;
};

}  // namespace luminist
