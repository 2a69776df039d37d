#pragma once
// app/orbit_panel.h -- the shot from anywhere: its surfaces, its lights as objects, its camera.
#include <memory>
#include <optional>
#include <span>

#include "app/desk.h"
#include "app/hand_event.h"
#include "app/lit_view.h"
#include "app/orbit_eye.h"
#include "app/shape_overlay.h"
#include "app/solid_view.h"

namespace luminist {

/// In place of the canvas: dragging turns, middle or Shift drag moves sideways, the wheel comes nearer. A light is
/// chosen by a click; it is moved parallel to the screen, its aim over the surfaces, its barn and cutoffs by the
/// squares that the canvas has too; Shift: a tenth of the way. While the eye moves the scene is drawn plainly; where it
/// rests, and while a light is under the hand, as the style lights it, with its shadows.
class OrbitPanel {
 public:
  void draw(Desk& desk, const ScreenRect& rect, std::span<const HandEvent> events);
  /// In place of draw(), where the canvas is looked at. After a while what new pictures need is given back.
  void closed(Desk& desk);

 private:
  enum class Grip { kNone, kTurn, kPan, kLight, kAim, kShape };
  void begin(Desk& desk);
  void look(const Desk& desk);
  void take(Desk& desk, const ScreenRect& rect, const HandEvent& event, bool hovered);
  void press(Desk& desk, const ScreenRect& rect, const HandEvent& event);
  bool take_handle(Desk& desk, const ScreenRect& rect, const Vec2& screen);
  void move(const Desk& desk, const ScreenRect& rect, const HandEvent& event, const Vec2& step);
  void release(Desk& desk);
  void light_up(Desk& desk, const ScreenRect& rect);
  void draw_surfaces(Desk& desk, const ScreenRect& rect);
  void draw_light(const Desk& desk, const ScreenRect& rect, const Light& light) const;
  void draw_selected(const Desk& desk, const ScreenRect& rect) const;
  void draw_camera(const ScreenRect& rect) const;
  void draw_words(Desk& desk, const ScreenRect& rect);
  [[nodiscard]] bool on_light() const { return grip_ == Grip::kLight || grip_ == Grip::kAim || grip_ == Grip::kShape; }
  [[nodiscard]] float reach() const;
  [[nodiscard]] std::vector<std::string> assignments(const Light& light) const;
  [[nodiscard]] std::optional<Vec2> on_screen(const ScreenRect& rect, const Vec3& point) const;

  std::shared_ptr<const ShotFacts> facts_;  ///< whose scene is looked at
  LitView lit_;
  SolidView solid_;
  std::shared_ptr<const SolidScene> tried_;  ///< what solid_ was to hold last
  bool plain_ = false;                       ///< also where the eye rests
  float floor_ = 0.0F;                       ///< height of the lowest surface
  OrbitEye eye_;
  Camera camera_;
  double moved_ = 0.0;           ///< when the eye did, in seconds of the window's clock
  std::optional<double> drawn_;  ///< when it was last, likewise; none: there is nothing to put away
  Grip grip_ = Grip::kNone;
  Vec2 last_{0.0F};

  // Of the selected light, as it is or as the hand holds it.
  std::string light_;
  std::shared_ptr<const ParamState> seen_;
  std::uint64_t let_go_ = 0;  ///< version of the snapshot when the hand let go; 0: it is as the snapshot says
  std::optional<LightPose> pose_;
  LightShape shape_;
  std::optional<Vec3> aim_;
  LightPose pose_before_;
  LightShape shape_before_;
  std::optional<ShapeHandle> taken_;
  Vec2 wanted_{0.0F};
  Vec2 taken_at_{0.0F};
};

}  // namespace luminist
