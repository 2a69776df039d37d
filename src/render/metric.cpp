#include "render/metric.h"

#include <cmath>

#include <glm/ext/vector_double3.hpp>

#include "base/check.h"

namespace luminist {
namespace {

void check_sizes(const Image& picture, const Target& target) {
  LUM_CHECK(picture.channels == 3 && target.color.channels == 3 && target.importance.channels == 1,
            "a picture and a target have three channels, an importance one");
  LUM_CHECK(picture.same_size(target.color) && picture.same_size(target.importance), "all are of one size");
}

/// I |T - R|_2 of one pixel. Where nothing counts the colours are not looked at: they may be anything.
double weighted_distance(const Image& picture, const Image& color, double importance, std::size_t pixel) {
  if (importance == 0.0) return 0.0;
  return importance * glm::distance(glm::dvec3(color.rgb(pixel)), glm::dvec3(picture.rgb(pixel)));
}

double error_of(const Image& picture, const Image& color, const Image& importance) {
  double error = 0.0;
  double total = 0.0;
  for (std::size_t pixel = 0; pixel < importance.pixels(); ++pixel) {
    const auto weight = static_cast<double>(importance.data[pixel]);
    error += weighted_distance(picture, color, weight, pixel);
    total += weight;
  }
  return total > 0.0 ? error / total : 0.0;
}

}  // namespace

double picture_error(const Image& picture, const Target& target, const StyleMetric& metric) {
  check_sizes(picture, target);
  if (metric.blur <= 0.0F) return error_of(picture, target.color, target.importance);
  return error_of(as_compared(picture, metric), as_compared(target.color, metric), target.importance);
}

Image as_compared(const Image& picture, const StyleMetric& metric) {
  return blurred(picture, metric.blur * static_cast<float>(picture.height));
}

Target as_compared(const Target& target, const StyleMetric& metric) {
  Target seen = target;
  if (metric.blur <= 0.0F) return seen;
  seen.color = as_compared(target.color, metric);
  seen.before = as_compared(target.before, metric);
  return seen;
}

Image residual_map(const Image& picture, const Target& target) {
  check_sizes(picture, target);
  Image map(picture.width, picture.height, 1);
  for (std::size_t pixel = 0; pixel < map.pixels(); ++pixel) {
    const auto weight = static_cast<double>(target.importance.data[pixel]);
    map.data[pixel] = static_cast<float>(weighted_distance(picture, target.color, weight, pixel));
  }
  return map;
}

}  // namespace luminist
