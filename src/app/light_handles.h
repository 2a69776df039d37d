#pragma once
// app/light_handles.h -- the selected light, taken by the hand: where it shines, where it stands, how far away.
#include <memory>
#include <optional>

#include "app/desk.h"
#include "app/light_pose.h"
#include "app/shape_overlay.h"

namespace luminist {

/// On the picture: a ring at what the light shines at, to be dragged over the surfaces; a disc where the light is, if
/// it is in sight; for the sun, which has only a direction, a disc at the rim of the scene. In the corner: a ball
/// around the aim, seen by the camera, on which a dot says where the light comes from; the dot is dragged around, also
/// for a light outside of the picture, and the wheel over the ball moves the light nearer and farther. While
/// Desk::shape_handles is set: the edge of the light with a square on each of its four sides, and squares on its axis
/// for the near and the far cutoff. Shift: a tenth of the way. Shown at once, one command when the hand lets go.
/// A brush puts all but the ball aside (Desk::handles_aside): the next stroke may begin where the light shines.
class LightHandles {
 public:
  /// returns whether the hand took a handle.
  bool press(Desk& desk, const Vec2& screen);
  void move(Desk& desk, const Vec2& screen, bool precise);
  void release(Desk& desk);
  /// returns whether the wheel was over the ball.
  bool scroll(Desk& desk, const Vec2& screen, float notches);
  void draw(Desk& desk);
  [[nodiscard]] bool held() const { return part_ != Part::kNone; }
  [[nodiscard]] bool over(const Desk& desk, const Vec2& screen) const { return part_at(desk, screen) != Part::kNone; }

 private:
  enum class Part { kNone, kAim, kPlace, kBall, kShape };
  void look(const Desk& desk);
  [[nodiscard]] Part part_at(const Desk& desk, const Vec2& screen) const;
  [[nodiscard]] Vec2 ball_center(const Desk& desk) const;
  [[nodiscard]] float ball_radius(const Desk& desk) const { return desk.theme.px(40.0F); }
  [[nodiscard]] std::optional<Vec2> on_screen(const Desk& desk, const Vec3& point) const;
  [[nodiscard]] std::optional<ShapeHandle> shape_at(const Desk& desk, const Vec2& screen) const;
  [[nodiscard]] float reach(const Desk& desk) const;
  void move_aim(const Desk& desk);
  void move_ball(const Desk& desk);
  void move_shape(const Desk& desk);
  void draw_on_picture(const Desk& desk) const;
  void draw_ball(const Desk& desk) const;
  [[nodiscard]] std::vector<std::string> assignments(const Light& light) const;
  void record(Desk& desk);

  Part part_ = Part::kNone;
  Vec2 last_{0.0F};                         ///< of the pointer
  Vec2 wanted_{0.0F};                       ///< where the handle would be without rounding
  std::shared_ptr<const ParamState> seen_;  ///< what pose_ was read from
  std::string light_;
  std::uint64_t let_go_ = 0;  ///< version of the snapshot when the hand let go
  std::optional<LightPose> pose_;
  LightShape shape_;
  LightShape shape_before_;           ///< when the hand took it
  std::optional<ShapeHandle> taken_;  ///< the handle of the shape under the hand
  Vec2 taken_at_{0.0F};
  std::optional<Vec3> aim_;
};

}  // namespace luminist
