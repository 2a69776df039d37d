#include "paint/gradient.h"

#include <algorithm>
#include <cmath>

namespace luminist {
namespace {

/// The normal, or the view vector (towards the eye) mirrored about it; zero on the background.
Vec3 facing(const SurfaceBuffer& surface, std::size_t pixel, PeakKind kind) {
  const Vec3& n = surface.normal[pixel];
  if (kind == PeakKind::kDiffuse || surface.object[pixel] == 0) return n;
  const Vec3 v = glm::normalize(surface.eye - surface.position[pixel]);
  return 2.0F * glm::dot(n, v) * n - v;
}

/// The first pixel along the polyline with a surface that the stroke may touch.
std::optional<std::size_t> first_surface(const Stroke& stroke, const SurfaceBuffer& surface, const ObjectMask& mask) {
  const auto height = static_cast<float>(surface.height);
  const std::vector<StrokePoint>& points = stroke.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const StrokePoint& a = points[i];
    const StrokePoint& b = points[std::min(i + 1, points.size() - 1)];
    const float length = std::hypot(b.x - a.x, b.y - a.y) * height;
    const int steps = 1 + static_cast<int>(2.0F * length);  // half a pixel each
    for (int s = 0; s < steps; ++s) {
      const float t = static_cast<float>(s) / static_cast<float>(steps);
      const auto x = static_cast<int>(std::floor((a.x + t * (b.x - a.x)) * height));
      const auto y = static_cast<int>(std::floor((a.y + t * (b.y - a.y)) * height));
      if (x < 0 || y < 0 || x >= surface.width || y >= surface.height) continue;
      const std::size_t pixel = surface.index(x, y);
      const std::uint32_t object = surface.object[pixel];
      if (object != 0 && (mask.empty() || mask[object])) return pixel;
    }
  }
  return std::nullopt;
}

}  // namespace

bool repeats_peak(const Brush& brush) {
  return brush.repeat_peak && brush.gradient > 0.0F && !brush.screen_gradient;
}

Result<Gradient> Gradient::create(const Stroke& stroke, const SurfaceBuffer& surface, const ObjectMask& mask,
                                  const std::optional<Peak>& last_peak) {
  Gradient gradient;
  const Brush& brush = stroke.brush;
  gradient.gamma_ = brush.gradient;
  if (brush.gradient == 0.0F) return gradient;
  if (brush.screen_gradient) {
    const auto height = static_cast<float>(surface.height);
    const StrokePoint& first = stroke.points.front();
    const StrokePoint& last = stroke.points.back();
    const Vec2 drag = height * Vec2(last.x - first.x, last.y - first.y);
    gradient.screen_ = true;
    gradient.start_ = height * Vec2(first.x, first.y);
    if (glm::dot(drag, drag) > 0.0F) gradient.drag_ = drag / glm::dot(drag, drag);  // a click does not run out
    return gradient;
  }
  if (repeats_peak(brush) && last_peak) {
    gradient.peak_ = last_peak;
    return gradient;
  }
  const std::optional<std::size_t> start = first_surface(stroke, surface, mask);
  if (!start) {
    return Error{ErrorKind::kBadContent, "the stroke meets no surface for its gradient to start on", "", "gradient",
                 "start it on an object, or set gradient to 0"};
  }
  gradient.peak_ = Peak{brush.peak, facing(surface, *start, brush.peak)};
  return gradient;
}

float Gradient::factor(const SurfaceBuffer& surface, int x, int y) const {
  if (gamma_ == 0.0F) return 1.0F;
  float fade = 0.0F;
  if (screen_) {
    const Vec2 from_start = Vec2(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F) - start_;
    fade = 1.0F - std::clamp(glm::dot(from_start, drag_), 0.0F, 1.0F);
  } else {
    fade = std::max(0.0F, glm::dot(facing(surface, surface.index(x, y), peak_->kind), peak_->direction));
  }
  return (1.0F - gamma_) + gamma_ * fade;
}

}  // namespace luminist
