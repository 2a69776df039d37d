#pragma once
// paint/coverage.h -- how much of a stroke each pixel gets.
#include <cstddef>
#include <span>
#include <vector>

#include "paint/stroke.h"

namespace luminist {

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct PixelBox {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
  [[nodiscard]] bool empty() const { return x0 >= x1 || y0 >= y1; }
  [[nodiscard]] int width() const { return x1 - x0; }
  [[nodiscard]] int height() const { return y1 - y0; }
};

/// The pixels that are in both.
PixelBox common(const PixelBox& a, const PixelBox& b);
/// The least box around both; an empty one adds nothing.
PixelBox joined(const PixelBox& a, const PixelBox& b);

/// The gaussian's edge: coverage at half a diameter from the dab's centre, e^-2. A pixel counts as painted from here
/// on: it lies inside the circle that the artist sees as the brush.
inline constexpr float kPaintEdge = 0.13533528F;

struct Coverage {
  PixelBox box;               ///< clipped to the picture; coverage outside is 0
  std::vector<float> values;  ///< [box.width() x box.height()], in [0,1]
  [[nodiscard]] float at(int x, int y) const {
    return values[static_cast<std::size_t>(y - box.y0) * static_cast<std::size_t>(box.width()) +
                  static_cast<std::size_t>(x - box.x0)];
  }
};

/// The maximum over all dabs along the polyline, exactly, as if they were infinitely dense: a dab is
/// exp(-r^2 / (2 sigma^2)), sigma = diameter x pressure / 4, pressure linear between points, cut to 0 beyond r = 4
/// sigma (coverage 3e-4). Pixels are sampled at their centres. points [>= 1], diameter in picture heights. cost O(sum
/// over segments of the pixels in their boxes).
Coverage stroke_coverage(std::span<const StrokePoint> points, float diameter, int width, int height);
/// The same bits inside a box of the picture, and nothing outside of it.
Coverage stroke_coverage(std::span<const StrokePoint> points, float diameter, int width, int height,
                         const PixelBox& within);

/// A bucket's: 1 on every pixel of the box.
Coverage full_coverage(const PixelBox& box);

}  // namespace luminist
