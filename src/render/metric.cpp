#include "render/metric.h"

#include <cmath>

#include <glm/ext/vector_double3.hpp>

#include "base/check.h"

namespace luminist {
namespace {

void check_sizes(const Image& picture, const Image& color, const Image& importance) {
  LUM_CHECK(picture.channels == 3 && color.channels == 3 && importance.channels == 1,
            "a picture and a target have three channels, an importance one");
  LUM_CHECK(picture.same_size(color) && picture.same_size(importance), "all are of one size");
}

/// I |T - R|_2 of one pixel. Where nothing counts the colours are not looked at: they may be anything.
double weighted_distance(const Image& picture, const Image& color, double importance, std::size_t pixel) {
  if (importance == 0.0) return 0.0;
  return importance * glm::distance(glm::dvec3(color.rgb(pixel)), glm::dvec3(picture.rgb(pixel)));
}

}  // namespace

double picture_error(const Image& picture, const Target& target, const StyleMetric& metric) {
  check_sizes(picture, target.color, target.importance);
  RowErrors rows;
  if (metric.blur <= 0.0F) {
    rows.compare(picture, target.color, target.importance);
  } else {
    rows.compare(as_compared(picture, metric), as_compared(target.color, metric), target.importance);
  }
  return rows.error();
}

void RowErrors::compare(const Image& picture, const Image& color, const Image& importance, int y0, int y1) {
  check_sizes(picture, color, importance);
  LUM_CHECK(0 <= y0 && y0 <= y1 && y1 <= picture.height, "rows are of the picture");
  const auto rows = static_cast<std::size_t>(picture.height);
  LUM_CHECK(rows_.size() == rows || (y0 == 0 && y1 == picture.height), "all rows are compared the first time");
  rows_.resize(rows);
  for (int y = y0; y < y1; ++y) {
    Row row;
    const std::size_t end = picture.index(0, y) + static_cast<std::size_t>(picture.width);
    for (std::size_t pixel = picture.index(0, y); pixel < end; ++pixel) {
      const auto weight = static_cast<double>(importance.data[pixel]);
      row.error += weighted_distance(picture, color, weight, pixel);
      row.importance += weight;
    }
    rows_[static_cast<std::size_t>(y)] = row;
  }
}

double RowErrors::error() const {
  Row all;
  for (const Row& row : rows_) {
    all.error += row.error;
    all.importance += row.importance;
  }
  return all.importance > 0.0 ? all.error / all.importance : 0.0;
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
  check_sizes(picture, target.color, target.importance);
  Image map(picture.width, picture.height, 1);
  for (std::size_t pixel = 0; pixel < map.pixels(); ++pixel) {
    const auto weight = static_cast<double>(target.importance.data[pixel]);
    map.data[pixel] = static_cast<float>(weighted_distance(picture, target.color, weight, pixel));
  }
  return map;
}

}  // namespace luminist
