#pragma once
// app/orbit_eye.h -- an eye that turns around a point.
#include "app/canvas_view.h"
#include "scene/scene.h"

namespace luminist {

struct OrbitEye {
  Vec3 center{0.0F};
  float turn = 0.6F;    ///< radians around the vertical
  float height = 0.5F;  ///< radians above the horizon, within a quarter turn
  float distance = 1.0F;

  /// As a camera with that opening.
  [[nodiscard]] Camera camera(float fov_y) const;
  /// By pixels of a drag.
  void turn_by(const Vec2& pixels);
  /// What lies in the centre follows a drag of so many pixels of a picture so high.
  void pan_by(const Vec2& pixels, float fov_y, int height);
  /// Nearer by notches of a wheel.
  void come_nearer(float notches);
};

/// The eye where a camera stands, around the point of its axis that is nearest to `around`.
OrbitEye orbit_from(const Camera& camera, const Vec3& around);

/// Through a place of the screen, in a picture that fills `rect`: the way (unit) from the eye.
Vec3 way_through(const Camera& camera, const ScreenRect& rect, const Vec2& screen);

}  // namespace luminist
