// prep/distortion.cpp -- the parts of chart_map.h that judge a map.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "prep/chart_map.h"

namespace luminist {
namespace {

bool overlap(double a, double b, double c, double d) {
  return std::max(a, b) >= std::min(c, d) && std::max(c, d) >= std::min(a, b);
}

/// Whether each ends on both sides of the other, by more than a billionth of its length: the two sides of a cut may lie
/// on each other, as where a flat ring was cut open.
bool segments_cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  if (!overlap(a.x, b.x, c.x, d.x) || !overlap(a.y, b.y, c.y, d.y)) return false;
  constexpr double kTouch = 1e-9;
  const double first = kTouch * glm::dot(b - a, b - a), second = kTouch * glm::dot(d - c, d - c);
  const double ac = cross(b - a, c - a), ad = cross(b - a, d - a);
  const double ca = cross(d - c, a - c), cb = cross(d - c, b - c);
  return std::min(ac, ad) < -first && std::max(ac, ad) > first && std::min(ca, cb) < -second &&
         std::max(ca, cb) > second;
}

}  // namespace

const char* name_of(ChartMethod method) {
  switch (method) {
    case ChartMethod::kRigid:
      return "rigid";
    case ChartMethod::kAligned:
      return "aligned";
    case ChartMethod::kArap:
      return "arap";
    case ChartMethod::kLscm:
      return "lscm";
    case ChartMethod::kMeanValue:
      return "mean_value";
    case ChartMethod::kTutte:
      return "tutte";
  }
  return "";
}

LinearFactors factors_of(const std::array<glm::dvec3, 3>& surface, const std::array<glm::dvec2, 3>& plane) {
  const glm::dvec3 e = surface[1] - surface[0];
  const glm::dvec3 f = surface[2] - surface[0];
  const double length = glm::length(e);
  const double x = glm::dot(e, f) / length;
  const double y = glm::length(glm::cross(e, f)) / length;
  // The map's derivative in the triangle's frame, whose first axis is e.
  const glm::dvec2 u = (plane[1] - plane[0]) / length;
  const glm::dvec2 v = (plane[2] - plane[0] - x * u) / y;
  const double sum = std::hypot(u.x + v.y, u.y - v.x);
  const double difference = std::hypot(u.x - v.y, u.y + v.x);
  return {0.5 * (sum + difference), 0.5 * (sum - difference)};
}

Distortion distortion_of(const Disc& disc, const std::vector<glm::dvec2>& places, double rounding) {
  constexpr double kMost = 1e6;  // thin triangles are not known better
  Distortion result;
  double total = 0.0, area_sum = 0.0, angle_sum = 0.0, stretch_sum = 0.0;
  for (const auto& [a, b, c] : disc.triangles) {
    const LinearFactors factors =
        factors_of({disc.points[a], disc.points[b], disc.points[c]}, {places[a], places[b], places[c]});
    const glm::dvec2 e = places[b] - places[a];
    const glm::dvec2 f = places[c] - places[a];
    const double slack = rounding * (glm::length(e) + glm::length(f));
    if (!(cross(e, f) > -slack) || (slack == 0.0 && cross(e, f) <= 0.0)) ++result.flipped;
    const double large = std::clamp(factors.largest, 1.0 / kMost, kMost);
    const double small = std::clamp(factors.least, 1.0 / kMost, kMost);
    const double area = 0.5 * glm::length(glm::cross(disc.points[b] - disc.points[a], disc.points[c] - disc.points[a]));
    const double log_area = std::abs(std::log(large * small));
    result.worst_area = std::max(result.worst_area, std::exp(log_area));
    result.worst_angle = std::max(result.worst_angle, large / small);
    // One crushed triangle among thousands does not condemn a chart.
    constexpr double kMostStretch = 10.0;
    const double a1 = std::min(large, kMostStretch), b1 = std::max(small, 1.0 / kMostStretch);
    total += area, area_sum += area * log_area, angle_sum += area * (large / small);
    stretch_sum += 0.25 * area * (a1 * a1 + b1 * b1 + 1.0 / (a1 * a1) + 1.0 / (b1 * b1));
  }
  if (!(total > 0.0)) return result;
  result.area = std::exp(area_sum / total), result.angle = angle_sum / total;
  result.stretch = std::sqrt(stretch_sum / total);
  return result;
}

std::vector<std::size_t> crossing_sides(const std::vector<glm::dvec2>& polygon) {
  const std::size_t count = polygon.size();
  const auto end = [&](std::size_t i) -> const glm::dvec2& { return polygon[(i + 1) % count]; };
  const auto left = [&](std::size_t i) { return std::min(polygon[i].x, end(i).x); };
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, left);
  std::vector<std::size_t> active;  // sides whose right end is not yet passed
  std::vector<std::size_t> crossing;
  for (const std::size_t i : order) {
    std::erase_if(active, [&](std::size_t j) { return std::max(polygon[j].x, end(j).x) < left(i); });
    for (const std::size_t j : active) {
      const bool adjacent = (i + 1) % count == j || (j + 1) % count == i;
      if (!adjacent && segments_cross(polygon[i], end(i), polygon[j], end(j))) crossing.insert(crossing.end(), {i, j});
    }
    active.push_back(i);
  }
  return crossing;
}

}  // namespace luminist
