#include "paint/stroke.h"

#include <cmath>

#include <fmt/format.h>

namespace luminist {
namespace {

/// Points further out than this, in picture heights, are mistakes.
constexpr float kFarthest = 100.0F;

Error bad_stroke(std::string what, std::string field, std::string hint) {
  return {ErrorKind::kBadContent, std::move(what), "", std::move(field), std::move(hint)};
}

}  // namespace

Result<void> check_stroke(const Stroke& stroke) {
  const Brush& brush = stroke.brush;
  for (const BrushQuality& quality : brush_qualities()) LUM_TRY_VOID(check_quality(brush, quality));
  for (std::size_t i = 0; i < stroke.points.size(); ++i) {
    const StrokePoint& p = stroke.points[i];
    // Comparisons are written so that a NaN fails them.
    const bool near = std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest;
    if (!near) {
      return bad_stroke(fmt::format("the point ({}, {}) is nowhere near the picture", p.x, p.y),
                        fmt::format("points[{}]", i), "x runs from 0 to the aspect, y from 0 on top to 1");
    }
    if (!(p.pressure >= 0.0F && p.pressure <= 1.0F)) {
      return bad_stroke("a pressure must lie in [0,1]", fmt::format("points[{}]", i), "");
    }
  }
  const bool needs_start = !brush.bucket || brush.clip == "@" || brush.gradient > 0.0F;
  if (stroke.points.empty() && needs_start)
    return bad_stroke("the stroke has no points", "points", "give [[x, y], ...]");
  if (brush.tool == PaintTool::kCopy && brush.copy_from.empty()) {
    return bad_stroke("the copy tool needs an image", "copy_from", "name a file beside the stroke file");
  }
  return {};
}

}  // namespace luminist
