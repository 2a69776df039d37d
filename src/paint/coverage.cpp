#include "paint/coverage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace luminist {
namespace {

/// Dabs end where (r / sigma)^2 reaches this: at 4 sigma.
constexpr double kTail = 16.0;

/// Where a dab's centre and sigma are, in pixels.
struct Dab {
  double x = 0.0;
  double y = 0.0;
  double sigma = 0.0;
};

/// The dabs between two, as a function of t from 0 to 1: centre a + t e, sigma a.sigma + t growth.
///
/// The least (r / sigma)^2 = N(t) / sigma(t)^2 over t has a closed form: with w from a to the point, the numerator of
/// its derivative is t D - (a.sigma w.e + growth w.w), D = a.sigma e.e + growth w.e, linear in t. Where D > 0 the zero
/// is the minimum, clamped to [0,1]; elsewhere one end is nearest.
class DabRow {
 public:
  /// Order does not matter; with the larger dab first only the second has no size (unless both have none).
  static DabRow between(const Dab& one, const Dab& other) {
    return one.sigma < other.sigma ? DabRow(other, one) : DabRow(one, other);
  }

  /// Lowers values[i] to the least (r / sigma)^2 of the pixel (x + skip + i, y) where that is less. A dab of no size
  /// gives infinity or NaN, and every comparison here then takes the other side. Rounding depends on x alone.
  void lower(int x, int y, int skip, int count, float* values) const {
    const DabRow s = *this;  // a copy: stores to values cannot change it, so that the loop is vectorized
    const auto first = static_cast<float>(x + 0.5 - a_.x);
    const auto wy = static_cast<float>(y + 0.5 - a_.y);
    const float squared_length = s.ex_ * s.ex_ + s.ey_ * s.ey_;
    for (int i = 0; i < count; ++i) {
      const float wx = first + static_cast<float>(skip + i);
      const float along = wx * s.ex_ + wy * s.ey_;
      const float squared = wx * wx + wy * wy;
      const float to_end = squared - 2.0F * along + squared_length;
      const float slope = s.sigma_ * squared_length + s.growth_ * along;
      float t = (s.sigma_ * along + s.growth_ * squared) / slope;
      t = t > 0.0F ? t : 0.0F;
      t = t < 1.0F ? t : 1.0F;
      const float dx = wx - t * s.ex_;
      const float dy = wy - t * s.ey_;
      const float sigma = s.sigma_ + t * s.growth_;
      const float inside = (dx * dx + dy * dy) / (sigma * sigma);
      const float start = squared * s.inverse_start_;
      const float end = to_end * s.inverse_end_;
      const float ends = end < start ? end : start;
      const float least = slope > 0.0F ? inside : ends;
      values[i] = least < values[i] ? least : values[i];
    }
  }

 private:
  DabRow(const Dab& a, const Dab& b)
      : a_(a),
        ex_(static_cast<float>(b.x - a.x)),
        ey_(static_cast<float>(b.y - a.y)),
        sigma_(static_cast<float>(a.sigma)),
        growth_(static_cast<float>(b.sigma - a.sigma)),
        inverse_start_(static_cast<float>(1.0 / (a.sigma * a.sigma))),
        inverse_end_(static_cast<float>(1.0 / (b.sigma * b.sigma))) {}

  Dab a_;
  float ex_;
  float ey_;
  float sigma_;
  float growth_;
  float inverse_start_;
  float inverse_end_;
};

/// The pixels whose centres may lie in the tails of the dabs from a to b, inside limits.
PixelBox reach(const Dab& a, const Dab& b, const PixelBox& limits) {
  const double tail = std::sqrt(kTail);
  const double left = std::min(a.x - tail * a.sigma, b.x - tail * b.sigma);
  const double right = std::max(a.x + tail * a.sigma, b.x + tail * b.sigma);
  const double top = std::min(a.y - tail * a.sigma, b.y - tail * b.sigma);
  const double bottom = std::max(a.y + tail * a.sigma, b.y + tail * b.sigma);
  const auto clipped = [](double v, int lo, int hi) { return static_cast<int>(std::clamp<double>(v, lo, hi)); };
  PixelBox box{clipped(std::floor(left), limits.x0, limits.x1), clipped(std::floor(top), limits.y0, limits.y1),
               clipped(std::ceil(right), limits.x0, limits.x1), clipped(std::ceil(bottom), limits.y0, limits.y1)};
  return box.empty() ? PixelBox{} : box;
}

std::vector<Dab> dabs_of(std::span<const StrokePoint> points, float diameter, int height) {
  std::vector<Dab> dabs;
  dabs.reserve(points.size() + 1);
  for (const StrokePoint& p : points) {
    const double h = height;
    dabs.push_back({p.x * h, p.y * h, static_cast<double>(diameter) * p.pressure * h / 4.0});
  }
  if (dabs.size() == 1) dabs.push_back(dabs.front());  // a click is a segment of no length
  return dabs;
}

}  // namespace

PixelBox common(const PixelBox& a, const PixelBox& b) {
  const PixelBox box{std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
  return box.empty() ? PixelBox{} : box;
}

PixelBox joined(const PixelBox& a, const PixelBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

Coverage stroke_coverage(std::span<const StrokePoint> points, float diameter, int width, int height) {
  return stroke_coverage(points, diameter, width, height, {0, 0, width, height});
}

Coverage stroke_coverage(std::span<const StrokePoint> points, float diameter, int width, int height,
                         const PixelBox& within) {
  LUM_CHECK(!points.empty(), "check_stroke() refuses strokes without points");
  const std::vector<Dab> dabs = dabs_of(points, diameter, height);
  const PixelBox picture{0, 0, width, height};
  Coverage coverage;
  for (std::size_t i = 0; i + 1 < dabs.size(); ++i) {
    coverage.box = joined(coverage.box, reach(dabs[i], dabs[i + 1], picture));
  }
  coverage.box = common(coverage.box, within);
  const PixelBox& box = coverage.box;
  if (box.empty()) return coverage;
  const auto row = static_cast<std::size_t>(box.width());
  coverage.values.assign(row * static_cast<std::size_t>(box.height()), static_cast<float>(kTail) + 1.0F);
  for (std::size_t i = 0; i + 1 < dabs.size(); ++i) {
    const PixelBox whole = reach(dabs[i], dabs[i + 1], picture);
    const PixelBox part = common(whole, box);
    if (part.empty()) continue;
    const DabRow dab_row = DabRow::between(dabs[i], dabs[i + 1]);
    for (int y = part.y0; y < part.y1; ++y) {
      const std::size_t start = static_cast<std::size_t>(y - box.y0) * row + static_cast<std::size_t>(part.x0 - box.x0);
      dab_row.lower(whole.x0, y, part.x0 - whole.x0, part.width(), &coverage.values[start]);
    }
  }
  for (float& value : coverage.values) value = value <= static_cast<float>(kTail) ? std::exp(-0.5F * value) : 0.0F;
  return coverage;
}

Coverage full_coverage(const PixelBox& box) {
  Coverage coverage{box, {}};
  coverage.values.assign(static_cast<std::size_t>(box.width()) * static_cast<std::size_t>(box.height()), 1.0F);
  return coverage;
}

}  // namespace luminist
