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

/// (r / sigma)^2 of a point relative to a dab; infinite for a dab of no size.
double squared_sigmas(double dx, double dy, double sigma) {
  return sigma > 0.0 ? (dx * dx + dy * dy) / (sigma * sigma) : std::numeric_limits<double>::infinity();
}

/// The least (r / sigma)^2 over the dabs between a and b. With t from a to b, centre and sigma are linear, and the
/// derivative of N(t) / sigma(t)^2 has a numerator that is linear in t: the one inner extremum has a closed form.
double least_squared_sigmas(double x, double y, const Dab& a, const Dab& b) {
  const double wx = x - a.x;
  const double wy = y - a.y;
  const double ex = b.x - a.x;
  const double ey = b.y - a.y;
  double least = std::min(squared_sigmas(wx, wy, a.sigma), squared_sigmas(x - b.x, y - b.y, b.sigma));
  const double growth = b.sigma - a.sigma;
  const double along = wx * ex + wy * ey;
  const double denominator = a.sigma * (ex * ex + ey * ey) + growth * along;
  if (denominator > 0.0) {  // otherwise the extremum is a maximum and an end is nearest
    const double t = (a.sigma * along + growth * (wx * wx + wy * wy)) / denominator;
    if (t > 0.0 && t < 1.0) {
      least = std::min(least, squared_sigmas(wx - t * ex, wy - t * ey, a.sigma + t * growth));
    }
  }
  return least;
}

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

PixelBox joined(const PixelBox& a, const PixelBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
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

Coverage stroke_coverage(std::span<const StrokePoint> points, float diameter, int width, int height) {
  LUM_CHECK(!points.empty(), "check_stroke() refuses strokes without points");
  const std::vector<Dab> dabs = dabs_of(points, diameter, height);
  const PixelBox picture{0, 0, width, height};
  Coverage coverage;
  for (std::size_t i = 0; i + 1 < dabs.size(); ++i) {
    coverage.box = joined(coverage.box, reach(dabs[i], dabs[i + 1], picture));
  }
  const PixelBox& box = coverage.box;
  if (box.empty()) return coverage;
  const auto row = static_cast<std::size_t>(box.width());
  coverage.values.assign(row * static_cast<std::size_t>(box.height()), static_cast<float>(kTail) + 1.0F);
  for (std::size_t i = 0; i + 1 < dabs.size(); ++i) {
    const PixelBox part = reach(dabs[i], dabs[i + 1], picture);
    for (int y = part.y0; y < part.y1; ++y) {
      float* values = &coverage.values[static_cast<std::size_t>(y - box.y0) * row];
      for (int x = part.x0; x < part.x1; ++x) {
        const auto q = static_cast<float>(least_squared_sigmas(x + 0.5, y + 0.5, dabs[i], dabs[i + 1]));
        values[x - box.x0] = std::min(values[x - box.x0], q);
      }
    }
  }
  for (float& value : coverage.values) value = value <= static_cast<float>(kTail) ? std::exp(-0.5F * value) : 0.0F;
  return coverage;
}

Coverage full_coverage(int width, int height) {
  Coverage coverage{{0, 0, width, height}, {}};
  coverage.values.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 1.0F);
  return coverage;
}

}  // namespace luminist
