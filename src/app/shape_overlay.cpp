#include "app/shape_overlay.h"

namespace luminist {
namespace {

constexpr ImU32 kLine = (paint_colors::kAccent & 0x00FFFFFFU) | 0xC0000000U;
constexpr ImU32 kFaintLine = (paint_colors::kAccent & 0x00FFFFFFU) | 0x60000000U;

void words_at(const Theme& theme, ImDrawList& list, const Vec2& at, const std::string& words) {
  const float pad = theme.px(4.0F);
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  const ImVec2 lo(at.x + theme.px(12.0F), at.y - size.y - theme.px(8.0F));
  list.AddRectFilled({lo.x - pad, lo.y - pad}, {lo.x + size.x + pad, lo.y + size.y + pad}, IM_COL32(20, 20, 20, 220),
                     pad);
  list.AddText(lo, paint_colors::kText, words.c_str());
}

void draw_cutoff(ImDrawList& list, const ToScreen& screen, const LightPose& pose, const LightShape& shape,
                 const Vec2& cutoff, float reach, bool pointed) {
  for (const float distance : {cutoff.x, cutoff.x + cutoff.y}) {
    const bool there = distance > 0.02F * reach && distance < 2.0F * kFarthest * reach;
    if (!there) continue;
    draw_path(list, screen, cutoff_ring(pose, shape, distance),
              distance == cutoff.x && pointed ? paint_colors::kAccent : kFaintLine, 1.0F);
  }
}

}  // namespace

void draw_path(ImDrawList& list, const ToScreen& screen, std::span<const Vec3> places, ImU32 color, float width) {
  std::optional<Vec2> before;
  for (const Vec3& place : places) {
    const auto at = screen(place);
    if (at && before) list.AddLine(im(*before), im(*at), color, width);
    before = at;
  }
}

std::optional<ShapeHandle> shape_handle_at(const Theme& theme, const ToScreen& screen,
                                           std::span<const ShapeHandle> handles, const Vec2& pointer) {
  const float reach = theme.px(8.0F);
  for (const ShapeHandle& handle : handles) {
    const auto at = screen(handle.at);
    if (at && glm::length(*at - pointer) < reach) return handle;
  }
  return std::nullopt;
}

void draw_shape(const Theme& theme, ImDrawList& list, const ToScreen& screen, const LightPose& pose,
                const LightShape& shape, float reach, std::optional<ShapePart> pointed) {
  draw_path(list, screen, barn_ring(pose, shape, reach), kLine, theme.px(1.2F));
  LightShape full = shape;  // where the soft edge begins
  if (full.barn) full.barn->z = 0.0F;
  draw_path(list, screen, barn_ring(pose, full, reach), kFaintLine, 1.0F);
  if (shape.near_cutoff) {
    draw_cutoff(list, screen, pose, shape, *shape.near_cutoff, reach, pointed == ShapePart::kNear);
  }
  if (shape.far_cutoff) {
    draw_cutoff(list, screen, pose, shape, *shape.far_cutoff, reach, pointed == ShapePart::kFar);
  }
  for (const ShapeHandle& handle : shape_handles(pose, shape, reach)) {
    const auto at = screen(handle.at);
    if (!at) continue;
    const bool cutoff = handle.part == ShapePart::kNear || handle.part == ShapePart::kFar;
    const float half = theme.px(pointed == handle.part ? 5.0F : 4.0F);
    list.AddRectFilled({at->x - half - 1.0F, at->y - half - 1.0F}, {at->x + half + 1.0F, at->y + half + 1.0F},
                       IM_COL32(0, 0, 0, 180));
    list.AddRectFilled({at->x - half, at->y - half}, {at->x + half, at->y + half},
                       cutoff ? IM_COL32(150, 190, 224, 255) : paint_colors::kAccent);
    if (pointed == handle.part) words_at(theme, list, *at, shape_words(shape, handle.part));
  }
}

}  // namespace luminist
