#pragma once
// app/layout.h -- where everything is: tools and brush on the left, lights on the right, the picture between.
#include <span>

#include "app/canvas_panel.h"
#include "app/goal_picker.h"
#include "app/lights_panel.h"
#include "app/link_picker.h"
#include "app/orbit_panel.h"
#include "app/panels.h"
#include "app/shots_panel.h"
#include "app/style_panel.h"
#include "app/tour.h"

namespace luminist {

class Layout {
 public:
  void draw(Desk& desk, CanvasPanel& canvas, std::span<const HandEvent> events);

 private:
  void left_side(Desk& desk, const ScreenRect& rect);
  void right_side(Desk& desk, const ScreenRect& rect);
  /// The frames below the picture, where they are wanted. returns how high they are.
  float shots(Desk& desk, const ScreenRect& middle);

  float left_ = 232.0F;  ///< widths of the panels, in points
  float right_ = 336.0F;
  ParamWidgets widgets_;
  LightsPanel lights_;
  StylePanel style_;
  LinkPicker link_picker_;
  GoalPicker goal_picker_;
  ExplorePanel explore_;
  StrokePanel strokes_;
  OrbitPanel orbit_;
  ShotsPanel shots_;
  Tour tour_;
};

}  // namespace luminist
