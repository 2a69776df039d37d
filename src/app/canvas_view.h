#pragma once
// app/canvas_view.h -- where a picture lies on the screen: zoom and pan.
#include "base/math.h"

namespace luminist {

/// A rectangle of the screen, in pixels.
struct ScreenRect {
  Vec2 lo{0.0F};
  Vec2 hi{0.0F};
  [[nodiscard]] Vec2 size() const { return hi - lo; }
  [[nodiscard]] Vec2 center() const { return 0.5F * (lo + hi); }
  [[nodiscard]] bool contains(const Vec2& p) const { return p.x >= lo.x && p.y >= lo.y && p.x < hi.x && p.y < hi.y; }
};

/// Screen and picture both have y down. Picture coordinates are pixels from the upper left corner.
class CanvasView {
 public:
  static constexpr float kLeastZoom = 0.05F;
  static constexpr float kMostZoom = 32.0F;

  /// The place that is drawn on, and the picture's size. As long as nobody zoomed, the picture fills the place.
  void place(const ScreenRect& rect, int width, int height);
  void fit() { fitted_ = true, place(rect_, static_cast<int>(size_.x), static_cast<int>(size_.y)); }
  void zoom_to(float zoom, const Vec2& screen);  ///< what is at that place of the screen stays there
  void zoom_by(float factor, const Vec2& screen) { zoom_to(zoom_ * factor, screen); }
  void pan(const Vec2& screen_delta);

  [[nodiscard]] float zoom() const { return zoom_; }  ///< screen pixels a picture pixel
  [[nodiscard]] const ScreenRect& rect() const { return rect_; }
  [[nodiscard]] Vec2 to_screen(const Vec2& picture) const { return rect_.center() + zoom_ * (picture - center_); }
  [[nodiscard]] Vec2 to_picture(const Vec2& screen) const { return center_ + (screen - rect_.center()) / zoom_; }
  [[nodiscard]] Vec2 picture_size() const { return size_; }

 private:
  ScreenRect rect_;
  Vec2 size_{1.0F};
  Vec2 center_{0.5F};  ///< the picture's point in the middle of the place
  float zoom_ = 1.0F;
  bool fitted_ = true;
};

}  // namespace luminist
