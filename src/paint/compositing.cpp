#include "paint/compositing.h"

#include <cmath>

namespace luminist {
namespace {

Vec3 exposed(const Vec3& below, float stops) {
  return glm::min(below * std::exp2(stops), glm::max(below, Vec3(kBrightest)));
}

Vec3 without_add_light(const Brush& brush, const Vec3& below, const Vec3& albedo, const Dose& dose) {
  switch (brush.tool) {
    case PaintTool::kColor: {
      const Vec3 textured = (1.0F - brush.texture) * brush.color + brush.texture * (brush.color * albedo);
      return (1.0F - dose.amount) * below + dose.amount * (dose.shading * textured);
    }
    case PaintTool::kBrighten:
      return exposed(below, brush.strength * dose.amount);
    case PaintTool::kDarken:
      return exposed(below, -brush.strength * dose.amount);
    case PaintTool::kCopy:
    case PaintTool::kShadow:
    case PaintTool::kShadowEraser:
    case PaintTool::kErase:
      return (1.0F - dose.amount * dose.source.w) * below + dose.amount * Vec3(dose.source);
    case PaintTool::kImportance:
      break;
  }
  return below;
}

}  // namespace

bool fades_amount(const Brush& brush) {
  return brush.screen_gradient || brush.tool != PaintTool::kColor;
}

Vec3 composited(const Brush& brush, const Vec3& below, const Vec3& albedo, const Dose& dose) {
  const Vec3 color = without_add_light(brush, below, albedo, dose);
  const bool never_darken = brush.add_light && brush.tool != PaintTool::kErase;
  return never_darken ? glm::max(below, color) : color;
}

}  // namespace luminist
