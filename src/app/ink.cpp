#include "app/ink.h"

#include <algorithm>
#include <cmath>

#include "base/image.h"

namespace luminist {
namespace {

ImU32 ink_color(const Brush& brush, float exposure, float alpha) {
  const auto code = [&](float linear) {
    return static_cast<int>(255.0F * srgb_from_linear(linear * std::exp2(exposure)) + 0.5F);
  };
  const int opacity = static_cast<int>(255.0F * std::clamp(alpha, 0.0F, 1.0F));
  switch (brush.tool) {
    case PaintTool::kColor:
      return IM_COL32(code(brush.color.x), code(brush.color.y), code(brush.color.z), opacity);
    case PaintTool::kDarken:
    case PaintTool::kShadow:
      return IM_COL32(0, 0, 0, opacity / 2);
    default:
      return IM_COL32(255, 255, 255, opacity / 4);
  }
}

/// A dab of gaussian fall-off, as rings that lie over one another.
void draw_dab(ImDrawList& list, const ImVec2& center, float radius, const Brush& brush, float exposure) {
  constexpr int kRings = 6;
  for (int ring = 0; ring < kRings; ++ring) {
    const float share = static_cast<float>(ring + 1) / kRings;
    const ImU32 color = ink_color(brush, exposure, 0.12F * brush.opacity);
    list.AddCircleFilled(center, radius * 0.85F * share, color, 24);
  }
}

/// The brush with its colour as the surface under a point takes it.
Brush tinted(const Brush& brush, const SurfaceBuffer& surface, const StrokePoint& point) {
  Brush result = brush;
  const int x = static_cast<int>(point.x * static_cast<float>(surface.height));
  const int y = static_cast<int>(point.y * static_cast<float>(surface.height));
  if (x < 0 || y < 0 || x >= surface.width || y >= surface.height) return result;
  result.color *= glm::mix(Vec3(1.0F), surface.albedo[surface.index(x, y)], brush.texture);
  return result;
}

}  // namespace

void Ink::begin(const Stroke& stroke) {
  strokes_.push_back({stroke.brush, stroke.points, 0, ++number_});
  open_ = true;
}

void Ink::extend(const StrokePoint& point) {
  if (open_ && !strokes_.empty()) strokes_.back().points.push_back(point);
}

void Ink::settle(const StudioSnapshot& snapshot) {
  std::erase_if(strokes_, [&](const Held& held) { return held.number <= snapshot.strokes_taken; });
  if (!strokes_.empty() && strokes_.front().number == snapshot.strokes_taken + 1) {
    strokes_.front().shown = std::max(strokes_.front().shown, snapshot.points_taken);
  }
}

void Ink::draw(ImDrawList& list, const CanvasView& view, const SurfaceBuffer& surface, float exposure) const {
  const float height = view.picture_size().y;
  for (const Held& held : strokes_) {
    const float radius = 0.5F * held.brush.diameter * height * view.zoom();
    const float step = std::max(1.0F, 0.35F * radius);
    Vec2 last(-1e9F);
    for (std::size_t i = held.shown; i < held.points.size(); ++i) {
      const StrokePoint& point = held.points[i];
      const Vec2 at = view.to_screen(height * Vec2(point.x, point.y));
      if (glm::length(at - last) < step) continue;
      draw_dab(list, {at.x, at.y}, radius * point.pressure, tinted(held.brush, surface, point), exposure);
      last = at;
    }
  }
}

}  // namespace luminist
