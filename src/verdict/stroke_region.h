#pragma once
// verdict/stroke_region.h -- where each stroke is and how far from its wish a picture is there.
#include <cstdint>
#include <string>
#include <vector>

#include "render/renderer.h"

namespace luminist {

/// The pixels that show one stroke's paint, or (stroke 0) none.
struct StrokeRegion {
  std::uint32_t stroke = 0;           ///< id in Target::stroke
  std::vector<std::uint32_t> pixels;  ///< that show a surface and count, in row order
  std::size_t empty_pixels = 0;       ///< that count and show nothing
  std::string object;                 ///< that the paint changes most
};

/// Every stroke that paints a pixel that counts, by id, and stroke 0 first if any unpainted pixel counts.
/// target as sanitize() leaves it. cost O(pixels).
std::vector<StrokeRegion> stroke_regions(const SurfaceBuffer& surface, const Target& target);

/// How a region's wish and its fulfilment compare, in linear RGB, means over its pixels by importance.
struct Shortfall {
  double wished = 0.0;  ///< |T - before|
  double missed = 0.0;  ///< |T - R|
  double light = 0.0;   ///< of the missed: where light is lacking, sum over channels of max(0, T - R)
  double dark = 0.0;    ///< where there is too much, sum over channels of max(0, R - T)
  double scale = 0.0;   ///< |T|: what the eye compares with
  // By importance times |T - before|: where paint changes a part of what it covers, the rest must not hide it.
  double missed_where_wished = 0.0;  ///< |T - R|
  double scale_where_wished = 0.0;   ///< |T|

  /// Missed so little that nobody minds: 35 % of what was wished, which is about what strokes of a round brush differ
  /// from a light's own gradients, or a change that is hard to see.
  [[nodiscard]] bool met() const {
    const bool hard_to_see = missed <= seen_at(scale) && missed_where_wished <= seen_at(scale_where_wished);
    return missed <= 0.35 * wished || hard_to_see;
  }
  /// The share of the wish that came true, at most 1; 0 too where the picture went the other way.
  [[nodiscard]] double attained() const;

 private:
  static double seen_at(double scale) { return 0.005 + 0.04 * scale; }
};

Shortfall shortfall(const StrokeRegion& region, const Target& target, const Image& picture);

/// Points of the picture that a search compares.
struct SampledWish {
  SampleSet samples;
  std::vector<Vec3> target;
  std::vector<double> weight;  ///< >= 0, as they add up in epsilon
  std::vector<int> region;     ///< index of the region that each is from

  /// sum of weight |target - colors|. colors [samples.pixels.size()]
  [[nodiscard]] double error(std::span<const Vec3> colors) const;
};

/// At most `per_region` pixels of each region, evenly over it, away from silhouettes and creases where that can be had;
/// if paint changes less than half of it, half of them where it does. A region keeps its share of all importance; the
/// weights sum to 1.
SampledWish sample_regions(const std::vector<StrokeRegion>& regions, const SurfaceBuffer& surface, const Target& target,
                           std::size_t per_region);

/// Of the same samples those of one region; the weights sum to 1.
SampledWish only_region(const SampledWish& wish, int region);

}  // namespace luminist
