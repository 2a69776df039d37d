#include "app/light_handles.h"

#include <cmath>

#include "app/hand_event.h"

namespace luminist {
namespace {

/// It has a place to be turned from; the sun's direction is its place on the rim.
bool shines_at(const LightPose& pose) {
  return pose.direction && !pose.around;
}

void knob(ImDrawList& list, const Vec2& at, float radius, ImU32 color, bool filled) {
  list.AddCircle(im(at), radius + 1.0F, IM_COL32(0, 0, 0, 180), 24, 3.0F);
  if (filled) {
    list.AddCircleFilled(im(at), radius, color, 24);
  } else {
    list.AddCircle(im(at), radius, color, 24, 1.5F);
  }
}

}  // namespace

/// Reads the selected light, unless the hand holds it.
void LightHandles::look(const Desk& desk) {
  if (held()) return;
  // What was let go stays until a later snapshot, with nothing left to do, shows it.
  const bool under_way = desk.now->version <= let_go_ || !desk.activity.label.empty() || desk.activity.waiting > 0;
  if (let_go_ != 0 && under_way && light_ == desk.selected) return;
  let_go_ = 0;
  const bool known = seen_ == desk.now->shown && light_ == desk.selected;
  if (known) return;
  seen_ = desk.now->shown;
  light_ = desk.selected;
  pose_.reset();
  aim_.reset();
  const auto& waiting = desk.now->waiting;
  if (std::find(waiting.begin(), waiting.end(), light_) != waiting.end()) return;
  const Light* light = desk.now->shown->rig.find(light_);
  if (light == nullptr) return;
  pose_ = pose_of(*light, desk.now->facts->frame);
  shape_ = shape_of(*light);
  if (pose_) aim_ = aim_point(desk.now->facts->surface, *pose_);
}

Vec2 LightHandles::ball_center(const Desk& desk) const {
  const float away = ball_radius(desk) + desk.theme.px(12.0F);
  const ScreenRect& rect = desk.view.rect();
  return {rect.lo.x + away, rect.hi.y - away};
}

std::optional<Vec2> LightHandles::on_screen(const Desk& desk, const Vec3& point) const {
  const Image& picture = desk.now->painted->color;
  const auto at = project(desk.now->facts->camera, point, picture.width, picture.height);
  if (!at) return std::nullopt;
  const Vec2 screen = desk.view.to_screen(*at);
  if (!desk.view.rect().contains(screen)) return std::nullopt;
  return screen;
}

LightHandles::Part LightHandles::part_at(const Desk& desk, const Vec2& screen) const {
  if (!pose_ || light_ != desk.selected) return Part::kNone;
  const float reach = desk.theme.px(10.0F);
  const auto near = [&](const std::optional<Vec2>& handle) { return handle && glm::length(*handle - screen) < reach; };
  const bool ball = aim_ && glm::length(ball_center(desk) - screen) < ball_radius(desk) + desk.theme.px(4.0F);
  if (desk.handles_aside) return ball ? Part::kBall : Part::kNone;
  if (near(on_screen(desk, pose_->position))) return Part::kPlace;
  if (aim_ && shines_at(*pose_) && near(on_screen(desk, *aim_))) return Part::kAim;
  if (ball) return Part::kBall;
  return shape_at(desk, screen) ? Part::kShape : Part::kNone;
}

float LightHandles::reach(const Desk& desk) const {
  return aim_ ? std::max(glm::length(*aim_ - pose_->position), 1e-3F) : 2.0F * desk.now->facts->frame.radius;
}

std::optional<ShapeHandle> LightHandles::shape_at(const Desk& desk, const Vec2& screen) const {
  if (!desk.shape_handles) return std::nullopt;
  return shape_handle_at(
      desk.theme, [&](const Vec3& place) { return on_screen(desk, place); }, shape_handles(*pose_, shape_, reach(desk)),
      screen);
}

bool LightHandles::press(Desk& desk, const Vec2& screen) {
  look(desk);
  part_ = part_at(desk, screen);
  last_ = screen;
  wanted_ = taken_at_ = screen;
  shape_before_ = shape_;
  taken_ = part_ == Part::kShape ? shape_at(desk, screen) : std::nullopt;
  if (part_ == Part::kAim) wanted_ = *on_screen(desk, *aim_);
  if (part_ == Part::kBall) move(desk, screen, false);
  if (held()) desk.handles_aside = false;
  return held();
}

void LightHandles::move_aim(const Desk& desk) {
  const Vec2 at = desk.view.to_picture(wanted_);
  const SurfaceBuffer& surface = desk.now->facts->surface;
  const int x = static_cast<int>(std::floor(at.x));
  const int y = static_cast<int>(std::floor(at.y));
  if (x < 0 || y < 0 || x >= surface.width || y >= surface.height) return;
  const std::size_t pixel = surface.index(x, y);
  if (surface.object[pixel] == 0) return;
  aim_ = surface.position[pixel];
  pose_ = aimed_at(*pose_, *aim_);
}

void LightHandles::move_ball(const Desk& desk) {
  Vec2 flat = (wanted_ - ball_center(desk)) / ball_radius(desk);
  const float length = glm::length(flat);
  // Beyond the rim the dot comes round on the other side: a light behind.
  const bool behind = length > 1.0F;
  if (behind) flat *= std::max(0.0F, 2.0F - length) / length;
  const float deep = std::sqrt(std::max(0.0F, 1.0F - glm::dot(flat, flat)));
  const Vec3 way(flat.x, -flat.y, behind ? -deep : deep);
  pose_ = moved_to(*pose_, place_at(desk.now->facts->camera, *aim_, pose_->position, way), aim_);
}

void LightHandles::move_shape(const Desk& desk) {
  const Image& picture = desk.now->painted->color;
  const Vec2 pixels = (wanted_ - taken_at_) / desk.view.zoom();
  const auto length = slid(desk.now->facts->camera, taken_->at, taken_->way, pixels, picture.width, picture.height);
  if (length) shape_ = dragged_shape(shape_before_, taken_->part, *length, reach(desk));
}

void LightHandles::move(Desk& desk, const Vec2& screen, bool precise) {
  if (!held()) return;
  const Vec2 step = (precise ? kPrecise : 1.0F) * (screen - std::exchange(last_, screen));
  wanted_ += step;
  if (part_ == Part::kAim) {
    move_aim(desk);
  } else if (part_ == Part::kPlace) {
    const Vec3 place =
        dragged(desk.now->facts->camera, pose_->position, step / desk.view.zoom(), desk.now->painted->color.height);
    pose_ = moved_to(*pose_, place, aim_);
  } else if (part_ == Part::kBall) {
    move_ball(desk);
  } else {
    move_shape(desk);
  }
  const Light* light = desk.now->shown->rig.find(light_);
  if (light != nullptr) desk.studio->preview(assignments(*light));
}

std::vector<std::string> LightHandles::assignments(const Light& light) const {
  return part_ == Part::kShape ? shape_assignments(light, shape_, shape_before_) : pose_assignments(light, *pose_);
}

void LightHandles::record(Desk& desk) {
  const Light* light = desk.now->shown->rig.find(light_);
  if (light == nullptr) return;
  const std::vector<std::string> turned = assignments(*light);
  if (turned.empty()) return;
  const char* label = part_ == Part::kShape ? "shape a light" : "move a light";
  desk.studio->change(label, [turned](Session& session) { return session.set(turned); });
  let_go_ = desk.now->version;
}

void LightHandles::release(Desk& desk) {
  if (held()) record(desk);
  part_ = Part::kNone;
  taken_.reset();
}

bool LightHandles::scroll(Desk& desk, const Vec2& screen, float notches) {
  look(desk);
  if (part_at(desk, screen) != Part::kBall) return false;
  if (pose_->around) return true;  // it is infinitely far away
  const float factor = std::pow(1.08F, -notches);
  pose_ = moved_to(*pose_, *aim_ + factor * (pose_->position - *aim_), aim_);
  record(desk);
  return true;
}

void LightHandles::draw_ball(const Desk& desk) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Vec2 center = ball_center(desk);
  const float radius = ball_radius(desk);
  list.AddCircleFilled(im(center), radius, IM_COL32(24, 24, 24, 190), 40);
  list.AddCircle(im(center), radius, paint_colors::kFaint, 40, 1.0F);
  list.AddLine({center.x - radius, center.y}, {center.x + radius, center.y}, IM_COL32(80, 80, 80, 120));
  list.AddLine({center.x, center.y - radius}, {center.x, center.y + radius}, IM_COL32(80, 80, 80, 120));
  const Vec3 way = seen_from(desk.now->facts->camera, *aim_, pose_->position);
  const Vec2 dot = center + radius * Vec2(way.x, -way.y);
  list.AddLine(im(center), im(dot), paint_colors::kAccent, 1.0F);
  knob(list, dot, desk.theme.px(5.0F), paint_colors::kAccent, way.z >= 0.0F);
}

void LightHandles::draw_on_picture(const Desk& desk) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto place = on_screen(desk, pose_->position);
  std::optional<Vec2> aim;
  if (aim_ && shines_at(*pose_)) aim = on_screen(desk, *aim_);
  if (pose_->around) {
    for (const auto& ray : rim_rays(*pose_)) {
      draw_path(
          list, [&](const Vec3& at) { return on_screen(desk, at); }, ray, IM_COL32(224, 164, 88, 140), 1.0F);
    }
  }
  if (place && aim) list.AddLine(im(*place), im(*aim), IM_COL32(224, 164, 88, 140), 1.0F);
  if (place) knob(list, *place, desk.theme.px(6.0F), paint_colors::kAccent, true);
  if (aim) {
    knob(list, *aim, desk.theme.px(8.0F), paint_colors::kAccent, false);
    list.AddCircleFilled(im(*aim), desk.theme.px(2.0F), paint_colors::kAccent);
  }
  if (desk.shape_handles) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto pointed = taken_ && held() ? taken_ : shape_at(desk, {mouse.x, mouse.y});
    draw_shape(
        desk.theme, list, [&](const Vec3& at) { return on_screen(desk, at); }, *pose_, shape_, reach(desk),
        pointed ? std::optional(pointed->part) : std::nullopt);
  }
}

void LightHandles::draw(Desk& desk) {
  look(desk);
  if (!pose_ || light_ != desk.selected) return;
  if (!desk.handles_aside) draw_on_picture(desk);
  if (aim_) draw_ball(desk);
}

}  // namespace luminist
