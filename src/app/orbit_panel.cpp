#include "app/orbit_panel.h"

#include <cmath>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace luminist {
namespace {

constexpr std::size_t kDots = 9000;  // as many as an ordinary frame draws without being felt

ImVec2 im(const Vec2& v) {
  return {v.x, v.y};
}

ImU32 shown(const Vec3& linear, int alpha) {
  const auto code = [](float x) { return static_cast<int>(255.0F * srgb_from_linear(x) + 0.5F); };
  return IM_COL32(code(linear.x), code(linear.y), code(linear.z), alpha);
}

Vec3 light_color(const Light& light) {
  const auto param = light.params.schema().by_role("color");
  const Vec3 color = param ? light.params.vec3(*param) : Vec3(1.0F);
  return color / std::max({color.x, color.y, color.z, 1e-3F});
}

}  // namespace

Camera OrbitEye::camera(float fov_y) const {
  const Vec3 back(std::sin(turn) * std::cos(height), std::sin(height), std::cos(turn) * std::cos(height));
  const Vec3 right(std::cos(turn), 0.0F, -std::sin(turn));
  Camera camera;
  camera.fov_y = fov_y;
  camera.near_plane = 0.001F * distance;
  camera.world_from_camera = Mat4(Vec4(right, 0.0F), Vec4(glm::cross(back, right), 0.0F), Vec4(back, 0.0F),
                                  Vec4(center + distance * back, 1.0F));
  return camera;
}

void OrbitPanel::begin(const Desk& desk) {
  if (facts_ == desk.now->facts) return;
  const bool same_scene = facts_ && facts_->shot.scene == desk.now->facts->shot.scene;
  facts_ = desk.now->facts;
  if (same_scene) return;
  const SceneFrame& frame = facts_->frame;
  const Vec3 back = facts_->camera.position() - frame.center;
  eye_ = {frame.center, std::atan2(back.x, back.z) + 0.7F, 0.45F, 7.0F * frame.radius};
}

std::optional<Vec2> OrbitPanel::on_screen(const ScreenRect& rect, const Vec3& point) const {
  const auto at = project(camera_, point, static_cast<int>(rect.size().x), static_cast<int>(rect.size().y));
  if (!at) return std::nullopt;
  return rect.lo + *at;
}

void OrbitPanel::draw_surfaces(const Desk& desk, const ScreenRect& rect) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const SurfaceBuffer& surface = facts_->surface;
  const Image& picture = *desk.now->picture;
  const bool lit = picture.width == surface.width && picture.height == surface.height;
  const std::size_t step = 1 + surface.pixels() / kDots;
  const float dot = desk.theme.px(1.5F);
  for (std::size_t i = 0; i < surface.pixels(); i += step) {
    if (surface.object[i] == 0) continue;
    const auto at = on_screen(rect, surface.position[i]);
    if (!at || !rect.contains(*at)) continue;
    const Vec3 color = glm::max(lit ? picture.rgb(i) : Vec3(0.0F), 0.08F * surface.albedo[i] + Vec3(0.01F));
    list.AddRectFilled({at->x - dot, at->y - dot}, {at->x + dot, at->y + dot}, shown(color, 255));
  }
}

void OrbitPanel::draw_camera(const Desk& desk, const ScreenRect& rect) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Camera& shot = facts_->camera;
  const Shot& size = facts_->shot;
  const float deep = 0.5F * facts_->frame.radius;
  const float up = deep * std::tan(0.5F * shot.fov_y);
  const float side = up * static_cast<float>(size.width) / static_cast<float>(size.height);
  const auto eye = on_screen(rect, shot.position());
  std::optional<Vec2> before;
  for (int corner = 0; corner <= 4; ++corner) {
    const float x = corner % 4 == 0 || corner % 4 == 3 ? -side : side;
    const float y = corner % 4 < 2 ? up : -up;
    const auto at = on_screen(rect, Vec3(shot.world_from_camera * Vec4(x, y, -deep, 1.0F)));
    if (eye && at) list.AddLine(im(*eye), im(*at), paint_colors::kFaint, 1.0F);
    if (before && at) list.AddLine(im(*before), im(*at), paint_colors::kFaint, 1.0F);
    before = at;
  }
  if (eye) list.AddText({eye->x + desk.theme.px(6.0F), eye->y}, paint_colors::kDim, "camera");
}

void OrbitPanel::draw_light(const Desk& desk, const ScreenRect& rect, const Light& light) const {
  const bool selected = light.name == desk.selected;
  const auto pose = selected && held_ ? held_ : pose_of(light);
  const auto at = pose ? on_screen(rect, pose->position) : std::nullopt;
  if (!at) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 color = light.muted ? paint_colors::kFaint : shown(light_color(light), 255);
  if (pose->direction) {
    // The opening at the light's distance from what it shines at, as an ellipse of the barn.
    const auto shape = light.params.schema().by_role("shape");
    const auto aim = aim_point(facts_->surface, *pose);
    const float reach = aim ? glm::length(*aim - pose->position) : 2.0F * facts_->frame.radius;
    Vec3 across;
    Vec3 along;
    tangent_frame(*pose->direction, across, along);
    const float wide = shape ? reach * std::max(0.02F, light.params.vec3(*shape).x) : 0.1F * reach;
    const float high = shape ? reach * std::max(0.02F, light.params.vec3(*shape).y) : 0.1F * reach;
    std::optional<Vec2> before;
    for (int i = 0; i <= 24; ++i) {
      const float a = 0.261799F * static_cast<float>(i);
      const Vec3 rim =
          pose->position + reach * *pose->direction + wide * std::cos(a) * across + high * std::sin(a) * along;
      const auto on = on_screen(rect, rim);
      if (on && i % 6 == 0) list.AddLine(im(*at), im(*on), (color & 0x00FFFFFFU) | 0x60000000U, 1.0F);
      if (on && before) list.AddLine(im(*before), im(*on), (color & 0x00FFFFFFU) | 0xA0000000U, 1.0F);
      before = on;
    }
  }
  const float radius = desk.theme.px(selected ? 8.0F : 6.0F);
  list.AddCircleFilled(im(*at), radius, color, 24);
  list.AddCircle(im(*at), radius + 1.0F, selected ? paint_colors::kAccent : IM_COL32(0, 0, 0, 200), 24, 2.0F);
  list.AddText({at->x + 1.6F * radius, at->y - radius}, selected ? paint_colors::kAccent : paint_colors::kText,
               light.name.c_str());
}

void OrbitPanel::choose(Desk& desk, const ScreenRect& rect, const Vec2& screen) {
  const float reach = desk.theme.px(12.0F);
  for (const Light& light : desk.now->shown->rig.lights) {
    const auto pose = pose_of(light);
    const auto at = pose ? on_screen(rect, pose->position) : std::nullopt;
    if (!at || glm::length(*at - screen) > reach) continue;
    desk.selected = light.name;
    held_ = pose;
    aim_ = aim_point(facts_->surface, *pose);
    grip_ = Grip::kLight;
    return;
  }
  grip_ = Grip::kTurn;
}

void OrbitPanel::move(Desk& desk, const ScreenRect& rect, const Vec2& step) {
  if (grip_ == Grip::kTurn) {
    constexpr float kTurnPerPixel = 0.008F;
    eye_.turn -= kTurnPerPixel * step.x;
    eye_.height = std::clamp(eye_.height + kTurnPerPixel * step.y, -1.5F, 1.5F);
  } else if (grip_ == Grip::kPan) {
    eye_.center = dragged(camera_, eye_.center, -step, static_cast<int>(rect.size().y));
  } else if (grip_ == Grip::kLight && held_) {
    const Light* light = desk.now->shown->rig.find(desk.selected);
    if (light == nullptr) return;
    held_ = moved_to(*held_, dragged(camera_, held_->position, step, static_cast<int>(rect.size().y)), aim_);
    desk.studio->preview(pose_assignments(*light, *held_));
  }
}

void OrbitPanel::take(Desk& desk, const ScreenRect& rect, const HandEvent& event, bool hovered) {
  const bool inside = hovered && rect.contains(event.at);
  const Vec2 step = event.at - std::exchange(last_, event.at);
  switch (event.kind) {
    case HandEvent::Kind::kMove:
      return move(desk, rect, step);
    case HandEvent::Kind::kPress:
      if (!inside) return;
      if (event.button == GLFW_MOUSE_BUTTON_MIDDLE || event.mods == GLFW_MOD_SHIFT) {
        grip_ = Grip::kPan;
      } else {
        choose(desk, rect, event.at);
      }
      return;
    case HandEvent::Kind::kRelease: {
      const Light* light = desk.now->shown->rig.find(desk.selected);
      const auto pose = light != nullptr ? pose_of(*light) : std::nullopt;
      if (grip_ == Grip::kLight && held_ && pose && pose->position != held_->position) {
        desk.studio->change("move a light", [assignments = pose_assignments(*light, *held_)](Session& session) {
          return session.set(assignments);
        });
      }
      held_.reset();
      grip_ = Grip::kNone;
      return;
    }
    case HandEvent::Kind::kScroll:
      if (inside) eye_.distance *= std::pow(1.1F, -event.scroll);
      return;
  }
}

void OrbitPanel::draw(Desk& desk, const ScreenRect& rect, std::span<const HandEvent> events) {
  begin(desk);
  ImGui::SetNextWindowPos(im(rect.lo));
  ImGui::SetNextWindowSize(im(rect.size()));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, paint_colors::kDesk);
  ImGui::Begin("orbit", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ImGui::InvisibleButton("hand", im(rect.size()));
  const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
  camera_ = eye_.camera(facts_->camera.fov_y);
  for (const HandEvent& event : events) take(desk, rect, event, hovered);
  camera_ = eye_.camera(facts_->camera.fov_y);
  draw_surfaces(desk, rect);
  draw_camera(desk, rect);
  for (const Light& light : desk.now->shown->rig.lights) draw_light(desk, rect, light);
  ImGui::GetWindowDrawList()->AddText({rect.lo.x + desk.theme.px(12.0F), rect.lo.y + desk.theme.px(10.0F)},
                                      paint_colors::kDim,
                                      "Drag: turn.  Shift+drag: move.  Wheel: nearer.  Drag a light to move it.");
  ImGui::End();
}

}  // namespace luminist
