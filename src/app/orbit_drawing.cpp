// The part of the free view that draws.
#include <cmath>

#include "app/icons.h"
#include "app/orbit_panel.h"

namespace luminist {
namespace {

ImU32 faint(ImU32 color, ImU32 alpha) {
  return (color & 0x00FFFFFFU) | (alpha << 24U);
}

ImU32 color_of(const Light& light) {
  if (light.muted) return paint_colors::kFaint;
  const auto param = light.params.schema().by_role("color");
  const Vec3 linear = param ? light.params.vec3(*param) : Vec3(1.0F);
  const Vec3 color = linear / std::max({linear.x, linear.y, linear.z, 1e-3F});
  const auto code = [](float x) { return static_cast<int>(255.0F * srgb_from_linear(x) + 0.5F); };
  return IM_COL32(code(color.x), code(color.y), code(color.z), 255);
}

}  // namespace

void OrbitPanel::draw_surfaces(Desk& desk, const ScreenRect& rect) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (solid_.empty()) {
    const char* words = "Reading the scene ...";
    const ImVec2 size = ImGui::CalcTextSize(words);
    list.AddText({rect.center().x - 0.5F * size.x, rect.center().y}, paint_colors::kDim, words);
    return;
  }
  if (!plain_ && lit_.shows(camera_)) {
    list.AddImage(lit_.id(), im(rect.lo), im(rect.hi));
    return;
  }
  const bool moves = grip_ == Grip::kTurn || grip_ == Grip::kPan;
  const float scale = desk.software && moves ? 0.6F : 1.0F;
  solid_.draw(camera_, static_cast<int>(scale * rect.size().x), static_cast<int>(scale * rect.size().y));
  list.AddImage(solid_.id(), im(rect.lo), im(rect.hi), {0.0F, 1.0F}, {1.0F, 0.0F});
}

void OrbitPanel::draw_camera(const ScreenRect& rect) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Camera& shot = facts_->camera;
  const auto to_screen = [&](const Vec3& place) { return on_screen(rect, place); };
  const float aspect = static_cast<float>(facts_->shot.width) / static_cast<float>(facts_->shot.height);
  const auto corners = [&](float deep) {
    const float up = deep * std::tan(0.5F * shot.fov_y);
    const auto corner = [&](float x, float y) {
      return Vec3(shot.world_from_camera * Vec4(x * aspect * up, y * up, -deep, 1.0F));
    };
    return std::array{corner(-1, 1), corner(1, 1), corner(1, -1), corner(-1, -1), corner(-1, 1)};
  };
  // The body, and as faint lines what it sees, as deep as the scene's middle.
  const float away = glm::dot(facts_->frame.center - shot.position(), -glm::normalize(Vec3(shot.world_from_camera[2])));
  const auto body = corners(0.35F * facts_->frame.radius);
  const auto seen = corners(std::max(away, 0.4F * facts_->frame.radius));
  for (int i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    draw_path(list, to_screen, std::array{shot.position(), seen[k]}, faint(paint_colors::kText, 0x38U), 1.0F);
    draw_path(list, to_screen, std::array{shot.position(), body[k]}, paint_colors::kText, 1.2F);
  }
  draw_path(list, to_screen, seen, faint(paint_colors::kText, 0x50U), 1.0F);
  draw_path(list, to_screen, body, paint_colors::kText, 1.2F);
  if (const auto at = to_screen(shot.position())) {
    list.AddCircleFilled(im(*at), 3.0F, paint_colors::kText);
    list.AddText({at->x + 8.0F, at->y - 6.0F}, paint_colors::kText, "camera");
  }
}

void OrbitPanel::draw_selected(const Desk& desk, const ScreenRect& rect) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto to_screen = [&](const Vec3& place) { return on_screen(rect, place); };
  if (pose_->around) return;
  // A plumb line says how high it hangs, and over what.
  const Vec3 down(0.0F, -1.0F, 0.0F);
  const auto below = lit_.solid() ? first_hit(*lit_.solid(), pose_->position, down) : std::nullopt;
  const float deep = below.value_or(std::max(0.0F, pose_->position.y - floor_));
  const Vec3 foot = pose_->position + deep * down;
  draw_path(list, to_screen, std::array{pose_->position, foot}, faint(paint_colors::kAccent, 0x90U), 1.0F);
  if (const auto at = to_screen(foot)) list.AddCircle(im(*at), desk.theme.px(4.0F), paint_colors::kAccent, 16, 1.0F);
  if (aim_ && pose_->direction) {
    draw_path(list, to_screen, std::array{pose_->position, *aim_}, paint_colors::kAccent, 1.0F);
    if (const auto at = to_screen(*aim_)) {
      list.AddCircle(im(*at), desk.theme.px(8.0F) + 1.0F, IM_COL32(0, 0, 0, 180), 24, 3.0F);
      list.AddCircle(im(*at), desk.theme.px(8.0F), paint_colors::kAccent, 24, 1.5F);
      list.AddCircleFilled(im(*at), desk.theme.px(2.0F), paint_colors::kAccent);
    }
  }
  if (!desk.shape_handles) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto pointed =
      taken_ ? taken_
             : shape_handle_at(desk.theme, to_screen, shape_handles(*pose_, shape_, reach()), {mouse.x, mouse.y});
  draw_shape(desk.theme, list, to_screen, *pose_, shape_, reach(),
             pointed ? std::optional(pointed->part) : std::nullopt);
}

void OrbitPanel::draw_light(const Desk& desk, const ScreenRect& rect, const Light& light) const {
  const bool selected = light.name == desk.selected && light.name == light_ && pose_;
  const auto pose = selected ? pose_ : pose_of(light, facts_->frame);
  const auto at = pose ? on_screen(rect, pose->position) : std::nullopt;
  if (!pose) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 color = color_of(light);
  const LightShape shape = selected ? shape_ : shape_of(light);
  // The beam: a faint body up to what it shines at.
  const auto aim = selected ? aim_ : aim_point(facts_->surface, *pose);
  const float deep = aim ? glm::length(*aim - pose->position) : 2.0F * facts_->frame.radius;
  const std::vector<Vec3> ring = barn_ring(*pose, shape, deep);
  std::optional<Vec2> before;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto on = on_screen(rect, ring[i]);
    if (at && on && before)
      list.AddTriangleFilled(im(*at), im(*before), im(*on), faint(color, selected ? 0x12U : 0x0AU));
    if (on && before) list.AddLine(im(*before), im(*on), faint(color, 0x90U), 1.0F);
    if (at && on && i % 6 == 0 && i + 1 < ring.size()) list.AddLine(im(*at), im(*on), faint(color, 0x50U), 1.0F);
    before = on;
  }
  if (pose->around) {
    for (const auto& ray : rim_rays(*pose)) {
      draw_path(
          list, [&](const Vec3& place) { return on_screen(rect, place); }, ray, faint(color, 0xB0U), 1.5F);
    }
  }
  if (selected) draw_selected(desk, rect);
  if (!at) return;
  const float radius = desk.theme.px(selected ? 8.0F : 6.0F);
  list.AddCircleFilled(im(*at), radius, color, 24);
  list.AddCircle(im(*at), radius + 1.0F, selected ? paint_colors::kAccent : IM_COL32(0, 0, 0, 220), 24, 2.0F);
  const ImVec2 name(at->x + 1.7F * radius, at->y - radius);
  list.AddText({name.x + 1.0F, name.y + 1.0F}, IM_COL32(0, 0, 0, 200), light.name.c_str());
  list.AddText(name, selected ? paint_colors::kAccent : paint_colors::kText, light.name.c_str());
}

void OrbitPanel::draw_words(Desk& desk, const ScreenRect& rect) {
  const Theme& theme = desk.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float pad = theme.px(10.0F);
  const auto to = [&](OrbitEye eye) {
    eye_ = eye;
    moved_ = desk.time - 1.0;
  };
  const auto seen = [&](float turn, float height) {
    OrbitEye eye = eye_;
    eye.turn = turn;
    eye.height = height;
    to(eye);
  };
  ImGui::SetCursorScreenPos({rect.lo.x + pad, rect.lo.y + pad});
  if (ImGui::SmallButton("Camera")) to(orbit_from(facts_->camera, facts_->frame.center));
  tip(theme, "Stand where the shot's camera stands.");
  ImGui::SameLine();
  if (ImGui::SmallButton("Front")) seen(0.0F, 0.0F);
  tip(theme, "Look from the front, along -Z.");
  ImGui::SameLine();
  if (ImGui::SmallButton("Side")) seen(1.570796F, 0.0F);
  tip(theme, "Look from the right, along -X.");
  ImGui::SameLine();
  if (ImGui::SmallButton("Top")) seen(0.0F, 1.5F);
  tip(theme, "Look from above.");
  ImGui::SameLine(0.0F, theme.px(20.0F));
  if (ImGui::SmallButton(plain_ ? "Lit" : "Plain")) plain_ = !plain_;
  tip(theme, plain_ ? "Show what the lights do where the view rests, as the style draws it."
                    : "Show only the surfaces: quick, and as bright in the dark.");
  const char* words =
      "Drag: turn.  Shift+drag: move.  Wheel: nearer.  Lights, aims and squares can be dragged (Shift: finely).";
  const float width = std::min(ImGui::CalcTextSize(words).x, rect.size().x - 2.0F * pad);
  // Below the buttons: the foot of the view is the tour's.
  list.AddText(theme.small, theme.small->FontSize, {rect.lo.x + pad, rect.lo.y + pad + ImGui::GetFrameHeight()},
               paint_colors::kDim, words, nullptr, width);
}

}  // namespace luminist
