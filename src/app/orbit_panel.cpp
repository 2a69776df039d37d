#include "app/orbit_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "rig/constraint.h"
#include "rig/light_list.h"

namespace luminist {
namespace {

constexpr double kRest = 0.2;        // seconds after which the eye rests
constexpr double kAway = 5.0;        // seconds after which nobody is thought to look again soon
constexpr float kQuickScale = 0.5F;  // of a picture that must come soon

int scaled(float size, float scale) {
  return std::max(16, static_cast<int>(size * scale));
}

/// The lights that are seen: those of the snapshot, but the muted and those that a solo leaves out.
ParamState seen_lights(const Desk& desk, const std::vector<std::string>& turned) {
  ParamState state = *desk.now->shown;
  for (const std::string& assignment : turned) static_cast<void>(set_path(state, assignment));
  if (!turned.empty()) keep_constraints(state.rig);
  solo_lights(state.rig, {desk.solo.begin(), desk.solo.end()});
  return state;
}

}  // namespace

void OrbitPanel::begin(Desk& desk) {
  lit_.take(desk);
  if (lit_.solid() && lit_.solid() != tried_) {
    tried_ = lit_.solid();
    if (auto loaded = solid_.load(desk.roots, lit_.solid()); !loaded) {
      desk.tell(StudioMessage::Kind::kError, loaded.error().message());
    }
    floor_ = std::numeric_limits<float>::infinity();
    for (const Vec3& place : lit_.solid()->positions) floor_ = std::min(floor_, place.y);
    moved_ = desk.time;
  }
  if (facts_ != desk.now->facts) {
    const bool same_scene = facts_ && facts_->shot.scene == desk.now->facts->shot.scene;
    facts_ = desk.now->facts;
    lit_.forget();
    if (!same_scene) {
      const SceneFrame& frame = facts_->frame;
      eye_ = orbit_from(facts_->camera, frame.center);
      eye_.turn += 0.7F;
      eye_.height = 0.45F;
      eye_.distance = 10.0F * frame.radius;
      eye_.center = frame.center;
    }
  }
  if (!lit_.solid()) lit_.ask_solid(desk);
}

/// Reads the selected light, unless the hand holds it.
void OrbitPanel::look(const Desk& desk) {
  if (on_light()) return;
  const bool under_way = desk.now->version <= let_go_ || !desk.activity.label.empty() || desk.activity.waiting > 0;
  if (let_go_ != 0 && under_way && light_ == desk.selected) return;
  let_go_ = 0;
  if (seen_ == desk.now->shown && light_ == desk.selected) return;
  seen_ = desk.now->shown;
  light_ = desk.selected;
  const Light* light = desk.now->shown->rig.find(light_);
  const auto pose = light != nullptr ? pose_of(*light, facts_->frame) : std::nullopt;
  const bool moved = !pose || !pose_ || pose->position != pose_->position || pose->direction != pose_->direction;
  pose_ = pose;
  shape_ = light != nullptr ? shape_of(*light) : LightShape{};
  if (moved) aim_ = pose_ ? aim_point(facts_->surface, *pose_) : std::nullopt;
}

float OrbitPanel::reach() const {
  return aim_ ? std::max(glm::length(*aim_ - pose_->position), 1e-3F) : 2.0F * facts_->frame.radius;
}

std::optional<Vec2> OrbitPanel::on_screen(const ScreenRect& rect, const Vec3& point) const {
  const auto at = project(camera_, point, static_cast<int>(rect.size().x), static_cast<int>(rect.size().y));
  if (!at) return std::nullopt;
  return rect.lo + *at;
}

/// The handles of the selected light, then any light.
bool OrbitPanel::take_handle(Desk& desk, const ScreenRect& rect, const Vec2& screen) {
  const auto near = [&](const std::optional<Vec2>& at, float points) {
    return at && glm::length(*at - screen) < desk.theme.px(points);
  };
  const auto to_screen = [&](const Vec3& place) { return on_screen(rect, place); };
  taken_.reset();
  if (pose_ && light_ == desk.selected && !near(on_screen(rect, pose_->position), 10.0F)) {
    const bool aims = aim_ && pose_->direction && !pose_->around;
    if (aims && near(on_screen(rect, *aim_), 10.0F)) return grip_ = Grip::kAim, true;
    if (desk.shape_handles)
      taken_ = shape_handle_at(desk.theme, to_screen, shape_handles(*pose_, shape_, reach()), screen);
    if (taken_) return grip_ = Grip::kShape, true;
  }
  for (const Light& light : desk.now->shown->rig.lights) {
    const bool held = light.name == light_ && pose_;
    const auto pose = held ? pose_ : pose_of(light, facts_->frame);
    if (!pose || !near(on_screen(rect, pose->position), 12.0F)) continue;
    desk.selected = light.name;
    desk.handles_aside = false;
    look(desk);
    return grip_ = Grip::kLight, true;
  }
  return false;
}

void OrbitPanel::press(Desk& desk, const ScreenRect& rect, const HandEvent& event) {
  wanted_ = taken_at_ = event.at;
  if (event.button == GLFW_MOUSE_BUTTON_LEFT && take_handle(desk, rect, event.at)) {
    pose_before_ = *pose_;
    shape_before_ = shape_;
    if (grip_ == Grip::kAim) wanted_ = *on_screen(rect, *aim_);
    return;
  }
  const bool pans = event.button == GLFW_MOUSE_BUTTON_MIDDLE || event.mods == GLFW_MOD_SHIFT || desk.space_down;
  grip_ = pans ? Grip::kPan : Grip::kTurn;
}

void OrbitPanel::move(const Desk& desk, const ScreenRect& rect, const HandEvent& event, const Vec2& step) {
  const int width = static_cast<int>(rect.size().x);
  const int height = static_cast<int>(rect.size().y);
  if (grip_ == Grip::kTurn || grip_ == Grip::kPan) {
    moved_ = desk.time;
    if (grip_ == Grip::kTurn) eye_.turn_by(step);
    if (grip_ == Grip::kPan) eye_.pan_by(step, facts_->camera.fov_y, height);
    return;
  }
  if (!on_light() || !pose_) return;
  const Vec2 taken = (event.mods == GLFW_MOD_SHIFT ? kPrecise : 1.0F) * step;
  wanted_ += taken;
  if (grip_ == Grip::kLight) {
    pose_ = moved_to(*pose_, dragged(camera_, pose_->position, taken, height), aim_);
  } else if (grip_ == Grip::kAim && lit_.solid()) {
    const Vec3 way = way_through(camera_, rect, wanted_);
    const auto distance = first_hit(*lit_.solid(), camera_.position(), way);
    if (distance) aim_ = camera_.position() + *distance * way, pose_ = aimed_at(*pose_, *aim_);
  } else if (taken_) {
    const auto length = slid(camera_, taken_->at, taken_->way, wanted_ - taken_at_, width, height);
    if (length) shape_ = dragged_shape(shape_before_, taken_->part, *length, reach());
  }
}

std::vector<std::string> OrbitPanel::assignments(const Light& light) const {
  if (grip_ == Grip::kShape) return shape_assignments(light, shape_, shape_before_);
  const bool moved = pose_->position != pose_before_.position || pose_->direction != pose_before_.direction;
  return moved ? pose_assignments(light, *pose_) : std::vector<std::string>{};
}

void OrbitPanel::release(Desk& desk) {
  const Light* light = desk.now->shown->rig.find(light_);
  if (on_light() && light != nullptr && pose_) {
    const std::vector<std::string> turned = assignments(*light);
    const char* label = grip_ == Grip::kShape ? "shape a light" : "move a light";
    if (!turned.empty()) {
      desk.studio->change(label, [turned](Session& session) { return session.set(turned); });
      let_go_ = desk.now->version;
    }
  }
  taken_.reset();
  grip_ = Grip::kNone;
}

void OrbitPanel::take(Desk& desk, const ScreenRect& rect, const HandEvent& event, bool hovered) {
  const bool inside = hovered && rect.contains(event.at);
  const Vec2 step = event.at - std::exchange(last_, event.at);
  switch (event.kind) {
    case HandEvent::Kind::kMove:
      return move(desk, rect, event, step);
    case HandEvent::Kind::kPress:
      if (inside && grip_ == Grip::kNone) press(desk, rect, event);
      return;
    case HandEvent::Kind::kRelease:
      return release(desk);
    case HandEvent::Kind::kScroll:
      if (!inside) return;
      eye_.come_nearer(event.scroll);
      moved_ = desk.time;
      return;
  }
}

/// Asks for the picture that is wanted now: small ones while a light is under the hand, first a small one and then a
/// large one where the processor draws.
void OrbitPanel::light_up(Desk& desk, const ScreenRect& rect) {
  const bool rests = desk.time - moved_ > kRest && grip_ != Grip::kTurn && grip_ != Grip::kPan;
  if (!rests || plain_ || solid_.empty() || lit_.waits()) return;
  const Light* light = on_light() || let_go_ != 0 ? desk.now->shown->rig.find(light_) : nullptr;
  const std::vector<std::string> turned = light != nullptr && pose_ ? assignments(*light) : std::vector<std::string>{};
  const bool quick = on_light() || (desk.software && !lit_.shows(camera_));
  const float scale = quick ? kQuickScale : 1.0F;
  LitView::Wish wish;
  wish.camera = camera_;
  wish.width = scaled(rect.size().x, scale);
  wish.height = scaled(rect.size().y, scale);
  wish.lights = std::make_shared<const ParamState>(seen_lights(desk, turned));
  lit_.ask(desk, std::move(wish));
}

void OrbitPanel::closed(Desk& desk) {
  if (!drawn_ || desk.time - *drawn_ < kAway) return;
  drawn_.reset();
  LitView::put_away(desk);
}

void OrbitPanel::draw(Desk& desk, const ScreenRect& rect, std::span<const HandEvent> events) {
  begin(desk);
  drawn_ = desk.time;
  ImGui::SetNextWindowPos(im(rect.lo));
  ImGui::SetNextWindowSize(im(rect.size()));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, paint_colors::kDesk);
  ImGui::Begin("orbit", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  const ImVec2 corner = ImGui::GetCursorPos();
  ImGui::InvisibleButton("hand", im(rect.size()));
  ImGui::SetItemAllowOverlap();
  const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
  ImGui::SetCursorPos(corner);
  look(desk);
  camera_ = eye_.camera(facts_->camera.fov_y);
  for (const HandEvent& event : events) {
    take(desk, rect, event, hovered);
    camera_ = eye_.camera(facts_->camera.fov_y);
  }
  light_up(desk, rect);
  draw_surfaces(desk, rect);
  draw_camera(rect);
  for (const Light& light : desk.now->shown->rig.lights) draw_light(desk, rect, light);
  draw_words(desk, rect);
  ImGui::End();
}

}  // namespace luminist
