#pragma once
// app/link_picker.h -- objects that a light shall light, chosen by clicks on the picture.
#include <span>
#include <vector>

#include "app/desk.h"
#include "app/hand_event.h"

namespace luminist {

/// While Desk::linking names a light, a click on the picture takes an object in or out.
class LinkPicker {
 public:
  /// returns the events that are not for it.
  std::vector<HandEvent> take(Desk& desk, std::span<const HandEvent> events);
  /// Marks what the light lights, and says how to end.
  void draw(Desk& desk) const;

 private:
  void toggle(Desk& desk, const Vec2& screen);
  bool pressed_ = false;  ///< the release belongs to a press that was taken
};

}  // namespace luminist
