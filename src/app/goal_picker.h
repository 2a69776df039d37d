#pragma once
// app/goal_picker.h -- a highlight, or a shadow's edge, dragged over the picture as a goal for the solver.
#include <optional>
#include <span>
#include <vector>

#include "app/desk.h"
#include "app/hand_event.h"

namespace luminist {

/// While Desk::goal is set, a drag on the picture becomes paint and a solve (studio/drag_goal.h).
class GoalPicker {
 public:
  /// returns the events that are not for it.
  std::vector<HandEvent> take(Desk& desk, std::span<const HandEvent> events);
  /// Draws the drag, and says what to do.
  void draw(Desk& desk) const;

 private:
  void begin_goal(Desk& desk, const Vec2& to);
  std::optional<Vec2> from_;  ///< screen; none: nothing is dragged
  Vec2 at_{0.0F};
};

}  // namespace luminist
