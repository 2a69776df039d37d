#include "paint/brush.h"

#include <array>

#include <fmt/format.h>

namespace luminist {
namespace {

constexpr std::array kQualities = {
    BrushQuality{"tool", &Brush::tool, 0, 0, "", "What the brush does."},
    BrushQuality{"color", &Brush::color, 0, kBrightest, "", "Linear RGB, may exceed 1; #rrggbb is sRGB."},
    BrushQuality{"diameter", &Brush::diameter, 1e-5F, 100, "picture heights", "The dab is a gaussian of sigma d/4."},
    BrushQuality{"opacity", &Brush::opacity, 0, 1, "", "Multiplied by the gaussian."},
    BrushQuality{"texture", &Brush::texture, 0, 1, "", "How far the diffuse texture modulates the colour."},
    BrushQuality{"gradient", &Brush::gradient, 0, 1, "", "How far the paint fades as the surface turns away."},
    BrushQuality{"peak", &Brush::peak, 0, 0, "", "What the gradient fades away from."},
    BrushQuality{"repeat_peak", &Brush::repeat_peak, 0, 0, "", "Keep the peak of the last stroke with a gradient."},
    BrushQuality{"screen_gradient", &Brush::screen_gradient, 0, 0, "", "Run out along the drag instead."},
    BrushQuality{"add_light", &Brush::add_light, 0, 0, "", "Never darken."},
    BrushQuality{"bucket", &Brush::bucket, 0, 0, "", "Cover the whole clip object, or the whole picture."},
    BrushQuality{"strength", &Brush::strength, 0, 16, "stops", "Of brighten and darken."},
    BrushQuality{"importance", &Brush::importance, 0, 1000, "", "What the importance tool paints; colour paint is 1."},
    BrushQuality{"clip", &Brush::clip, 0, 0, "", "The object to stay on; @ is the one under the first point."},
    BrushQuality{"copy_from", &Brush::copy_from, 0, 0, "", "The image to copy, relative to the stroke file."},
};

bool in_range(float value, const BrushQuality& quality) {
  return value >= quality.least && value <= quality.most;  // false for NaN
}

}  // namespace

std::span<const BrushQuality> brush_qualities() {
  return kQualities;
}

std::span<const std::string> tool_words() {
  static const std::array<std::string, 8> words = {"color",  "brighten",      "darken", "copy",
                                                   "shadow", "shadow_eraser", "erase",  "importance"};
  return words;
}

std::span<const std::string> peak_words() {
  static const std::array<std::string, 2> words = {"diffuse", "specular"};
  return words;
}

std::string quality_range(const BrushQuality& quality) {
  if (std::holds_alternative<PaintTool Brush::*>(quality.member))
    return fmt::format("{}", fmt::join(tool_words(), ", "));
  if (std::holds_alternative<PeakKind Brush::*>(quality.member))
    return fmt::format("{}", fmt::join(peak_words(), ", "));
  if (quality.least == quality.most) return "";
  const std::string unit = *quality.unit == '\0' ? "" : fmt::format(" {}", quality.unit);
  return fmt::format("{} to {}{}", quality.least, quality.most, unit);
}

Result<void> check_quality(const Brush& brush, const BrushQuality& quality) {
  bool good = true;
  if (const auto* number = std::get_if<float Brush::*>(&quality.member)) {
    good = in_range(brush.**number, quality);
  } else if (const auto* color = std::get_if<Vec3 Brush::*>(&quality.member)) {
    const Vec3& c = brush.**color;
    good = in_range(c.x, quality) && in_range(c.y, quality) && in_range(c.z, quality);
  }
  if (good) return {};
  return Error{ErrorKind::kBadContent, "must be from " + quality_range(quality), "", quality.name, ""};
}

}  // namespace luminist
