#include "raster/line_spec.h"

#include <algorithm>
#include <cmath>

namespace luminist {
namespace {

constexpr float kWidest = 0.25F;  // picture heights or scene radii

float value(const ParamBlock& style, std::string_view role, float fallback) {
  const auto param = style.schema().by_role(role);
  if (!param) return fallback;
  const auto number = static_cast<float>(style.get(*param));
  return std::isfinite(number) ? number : fallback;
}

bool flag(const ParamBlock& style, std::string_view role) {
  return value(style, role, 0.0F) != 0.0F;
}

}  // namespace

LineSpec line_spec(const ParamBlock& style) {
  LineSpec spec;
  spec.width = std::clamp(value(style, "line_width", 0.0F), 0.0F, kWidest);
  spec.in_scene_radii = flag(style, "line_unit");
  spec.distance = std::clamp(value(style, "line_distance", 0.0F), -4.0F, 4.0F);
  spec.inner = std::clamp(value(style, "line_inner", 1.0F), 0.0F, 4.0F);
  spec.silhouette = flag(style, "line_silhouette");
  spec.crease = flag(style, "line_crease");
  spec.intersection = flag(style, "line_intersection");
  spec.border = flag(style, "line_border");
  spec.crease_angle = std::clamp(value(style, "line_crease_angle", 0.7F), 0.01F, 3.14F);
  return spec;
}

}  // namespace luminist
