#pragma once
// app/orbit_panel.h -- the shot from anywhere: its surfaces as dots, the lights as objects, the camera as a wedge.
#include <span>

#include "app/desk.h"
#include "app/hand_event.h"
#include "app/light_pose.h"

namespace luminist {

/// An eye that turns around a point.
struct OrbitEye {
  Vec3 center{0.0F};
  float turn = 0.6F;    ///< radians around the vertical
  float height = 0.5F;  ///< radians above the horizon, within a quarter turn
  float distance = 1.0F;

  /// As a camera with the shot's opening.
  [[nodiscard]] Camera camera(float fov_y) const;
};

/// In place of the canvas: dragging turns, middle or Shift drag moves sideways, the wheel comes nearer. A light is
/// chosen by a click and moved by dragging it, parallel to the screen; what it shines at stays.
class OrbitPanel {
 public:
  void draw(Desk& desk, const ScreenRect& rect, std::span<const HandEvent> events);

 private:
  enum class Grip { kNone, kTurn, kPan, kLight };
  void begin(const Desk& desk);
  void take(Desk& desk, const ScreenRect& rect, const HandEvent& event, bool hovered);
  void move(Desk& desk, const ScreenRect& rect, const Vec2& step);
  void choose(Desk& desk, const ScreenRect& rect, const Vec2& screen);
  void draw_surfaces(const Desk& desk, const ScreenRect& rect) const;
  void draw_light(const Desk& desk, const ScreenRect& rect, const Light& light) const;
  void draw_camera(const Desk& desk, const ScreenRect& rect) const;
  [[nodiscard]] std::optional<Vec2> on_screen(const ScreenRect& rect, const Vec3& point) const;

  std::shared_ptr<const ShotFacts> facts_;  ///< whose scene is looked at
  OrbitEye eye_;
  Camera camera_;
  Grip grip_ = Grip::kNone;
  Vec2 last_{0.0F};
  std::optional<LightPose> held_;
  std::optional<Vec3> aim_;
};

}  // namespace luminist
