// Several new lights from one painting: k-means over the lightened pixels, one light a group.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "solve/start_light.h"

namespace luminist {
namespace {

constexpr int kFeatures = 9;
using Feature = std::array<float, kFeatures>;

constexpr std::size_t kMostPixels = 20000;  // of a painting that groups are found from: enough for a place and a colour

/// Place in scene radii, normal, colour of what paint adds to a white surface.
Feature feature_of(const SurfaceBuffer& surface, const Target& target, std::size_t i, const SceneFrame& frame) {
  const Vec3 place = (surface.position[i] - frame.center) / frame.radius;
  const Vec3 normal = 0.3F * surface.normal[i];
  Vec3 ratio = target.color.rgb(i) - target.before.rgb(i);
  ratio /= glm::max(surface.albedo[i], Vec3(0.05F));
  const float sum = std::max(1e-6F, std::abs(ratio.x) + std::abs(ratio.y) + std::abs(ratio.z));
  const Vec3 hue = 2.0F * ratio / sum;
  return {place.x, place.y, place.z, normal.x, normal.y, normal.z, hue.x, hue.y, hue.z};
}

float distance_squared(const Feature& a, const Feature& b) {
  float sum = 0.0F;
  for (std::size_t k = 0; k < kFeatures; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

std::size_t nearest(const Feature& feature, const std::vector<Feature>& centers) {
  std::size_t best = 0;
  for (std::size_t c = 1; c < centers.size(); ++c) {
    if (distance_squared(feature, centers[c]) < distance_squared(feature, centers[best])) best = c;
  }
  return best;
}

/// Weighted k-means, begun at the mean and then always at the point farthest from the centres there are.
std::vector<Feature> find_centers(const std::vector<Feature>& points, const std::vector<float>& weights, int count) {
  std::vector<Feature> centers(1);
  const auto improve = [&] {
    std::vector<Feature> sums(centers.size(), Feature{});
    std::vector<float> totals(centers.size(), 0.0F);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t c = nearest(points[i], centers);
      for (std::size_t k = 0; k < kFeatures; ++k) sums[c][k] += weights[i] * points[i][k];
      totals[c] += weights[i];
    }
    for (std::size_t c = 0; c < centers.size(); ++c) {
      if (!(totals[c] > 0.0F)) continue;
      for (std::size_t k = 0; k < kFeatures; ++k) centers[c][k] = sums[c][k] / totals[c];
    }
  };
  improve();
  while (static_cast<int>(centers.size()) < count) {
    std::size_t farthest = 0;
    float distance = 0.0F;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float d = distance_squared(points[i], centers[nearest(points[i], centers)]);
      if (d > distance) {
        distance = d;
        farthest = i;
      }
    }
    if (!(distance > 0.0F)) break;
    centers.push_back(points[farthest]);
    for (int round = 0; round < 10; ++round) improve();
  }
  return centers;
}

}  // namespace

Result<std::vector<StartLight>> estimate_start_lights(int count, const SurfaceBuffer& surface, const Target& target,
                                                      const SceneFrame& frame) {
  if (count < 1) return Error{ErrorKind::kUsage, "at least one light is wanted", "", "add-light", ""};
  const std::vector<float> added = lightening(surface, target);
  std::vector<std::size_t> lightened;
  for (std::size_t i = 0; i < added.size(); ++i) {
    if (added[i] > 0.0F) lightened.push_back(i);
  }
  if (count == 1 || lightened.empty()) {
    LUM_TRY(const StartLight start, estimate_start_light(surface, target, frame));
    return std::vector<StartLight>{start};
  }
  const std::size_t stride = 1 + lightened.size() / kMostPixels;
  std::vector<Feature> points;
  std::vector<float> weights;
  for (std::size_t i = 0; i < lightened.size(); i += stride) {
    points.push_back(feature_of(surface, target, lightened[i], frame));
    weights.push_back(added[lightened[i]]);
  }
  const std::vector<Feature> centers = find_centers(points, weights, count);
  std::vector<double> strength(centers.size(), 0.0);
  std::vector<std::vector<unsigned char>> masks(centers.size(), std::vector<unsigned char>(added.size(), 0));
  for (const std::size_t i : lightened) {
    const std::size_t group = nearest(feature_of(surface, target, i, frame), centers);
    masks[group][i] = 1;
    strength[group] += added[i];
  }
  std::vector<std::size_t> order(centers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return strength[a] > strength[b]; });
  std::vector<StartLight> starts;
  for (const std::size_t group : order) {
    if (!(strength[group] > 0.0)) continue;
    LUM_TRY(const StartLight start, estimate_start_light(surface, target, frame, masks[group]));
    starts.push_back(start);
  }
  return starts;
}

Result<void> place_lights(std::span<const std::string> names, const SurfaceBuffer& surface, const Target& target,
                          const SceneFrame& frame, LightRig& rig) {
  LUM_TRY(const std::vector<StartLight> starts,
          estimate_start_lights(static_cast<int>(names.size()), surface, target, frame));
  if (starts.size() < names.size()) {
    return Error{ErrorKind::kNothingToDo, "the paint is of fewer kinds than there are new lights", "", "", ""};
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (Light* light = rig.find(names[i])) apply_start_light(starts[i], *light);
  }
  return {};
}

}  // namespace luminist
