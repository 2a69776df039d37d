#pragma once
// app/theme.h -- how the studio looks: greys that bias no colour, one accent, one typeface.
#include <imgui.h>

#include <string>

#include "base/math.h"

namespace luminist {

/// A place of the screen, as ImGui takes it.
inline ImVec2 im(const Vec2& v) {
  return {v.x, v.y};
}

struct Theme {
  float scale = 1.0F;  ///< of the display: 1 at 96 dots an inch
  ImFont* text = nullptr;
  ImFont* strong = nullptr;
  ImFont* small = nullptr;

  [[nodiscard]] float px(float points) const { return points * scale; }
};

/// Colours of what is drawn by hand.
namespace paint_colors {
inline constexpr ImU32 kAccent = IM_COL32(224, 164, 88, 255);
inline constexpr ImU32 kText = IM_COL32(214, 214, 214, 255);
inline constexpr ImU32 kDim = IM_COL32(140, 140, 140, 255);
inline constexpr ImU32 kFaint = IM_COL32(92, 92, 92, 255);
inline constexpr ImU32 kGood = IM_COL32(134, 182, 136, 255);
inline constexpr ImU32 kWarn = IM_COL32(224, 184, 96, 255);
inline constexpr ImU32 kBad = IM_COL32(222, 110, 96, 255);
inline constexpr ImU32 kDesk = IM_COL32(38, 38, 38, 255);  ///< around the picture
}  // namespace paint_colors

/// Loads the typeface (Inter, else DejaVu Sans, else ImGui's own) and sets colours and sizes. Once, after
/// ImGui::CreateContext().
Theme make_theme(float scale);

}  // namespace luminist
