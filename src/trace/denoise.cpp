#include "trace/denoise.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/check.h"

namespace luminist {
namespace {

constexpr int kRounds = 4;             // holes of 1, 2, 4 and 8 pixels
constexpr float kNormalPower = 32.0F;  // of the cosine between normals
constexpr float kPlane = 0.01F;        // how far off the plane, of the distance to the eye
constexpr float kContrast = 1.0F;      // natural logarithm of brightness, half as much each round
constexpr float kDarkest = 0.05F;      // of the mean brightness: below that all is alike
constexpr float kMirror = 0.1F;        // roughness: what is seen in it is elsewhere

/// What the light is multiplied by; never so little that the quotient is mostly noise.
Vec3 reflectance(const SurfaceBuffer& surface, std::size_t i) {
  return glm::max(surface.albedo[i] + surface.specular[i], Vec3(0.02F));
}

float brightness(const Vec3& color) {
  return glm::dot(color, Vec3(0.2126F, 0.7152F, 0.0722F));
}

float likeness(const SurfaceBuffer& surface, std::size_t a, std::size_t b) {
  if (surface.object[a] != surface.object[b]) return 0.0F;
  const float cosine = std::max(glm::dot(surface.normal[a], surface.normal[b]), 0.0F);
  const Vec3 way = surface.position[b] - surface.position[a];
  const float reach = kPlane * glm::distance(surface.position[a], surface.eye);
  const float off = std::abs(glm::dot(way, surface.normal[a])) / std::max(reach, 1e-12F);
  return std::pow(cosine, kNormalPower) * std::exp(-off * off);
}

/// A rare bright path is a single pixel: none stays brighter than the brightest of its neighbours on the same object.
std::vector<Vec3> without_specks(const std::vector<Vec3>& light, const SurfaceBuffer& surface) {
  std::vector<Vec3> result = light;
  tbb::parallel_for(0, surface.height, [&](int y) {
    for (int x = 0; x < surface.width; ++x) {
      const std::size_t here = surface.index(x, y);
      float most = -1.0F;
      for (int row = std::max(y - 1, 0); row <= std::min(y + 1, surface.height - 1); ++row) {
        for (int column = std::max(x - 1, 0); column <= std::min(x + 1, surface.width - 1); ++column) {
          const std::size_t there = surface.index(column, row);
          if (there != here && surface.object[there] == surface.object[here]) {
            most = std::max(most, brightness(light[there]));
          }
        }
      }
      const float own = brightness(light[here]);
      if (most >= 0.0F && own > most) result[here] *= most / own;
    }
  });
  return result;
}

/// Logarithms, as eyes compare brightness: a lamp does not bleed into the wall beside it.
std::vector<float> levels_of(const std::vector<Vec3>& light) {
  double sum = 0.0;
  for (const Vec3& each : light) sum += static_cast<double>(brightness(each));
  const float least = std::max(kDarkest * static_cast<float>(sum / static_cast<double>(light.size())), 1e-6F);
  std::vector<float> levels;
  for (const Vec3& each : light) levels.push_back(std::log(std::max(brightness(each), 0.0F) + least));
  return levels;
}

Vec3 smoothed(const std::vector<Vec3>& light, const std::vector<float>& levels, const SurfaceBuffer& surface, int x,
              int y, int hole, float tolerance) {
  constexpr std::array<float, 3> kSpline{0.375F, 0.25F, 0.0625F};
  const std::size_t here = surface.index(x, y);
  Vec3 sum(0.0F);
  float weights = 0.0F;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const int column = x + dx * hole;
      const int row = y + dy * hole;
      if (column < 0 || row < 0 || column >= surface.width || row >= surface.height) continue;
      const std::size_t there = surface.index(column, row);
      const float step = (levels[there] - levels[here]) / tolerance;
      const float weight = kSpline[static_cast<std::size_t>(std::abs(dx))] *
                           kSpline[static_cast<std::size_t>(std::abs(dy))] * likeness(surface, here, there) *
                           std::exp(-step * step);
      sum += weight * light[there];
      weights += weight;
    }
  }
  return weights > 0.0F ? sum / weights : light[here];
}

}  // namespace

Image denoised(const Image& picture, const SurfaceBuffer& surface) {
  LUM_CHECK(picture.pixels() == surface.pixels() && picture.channels == 3, "picture and surface are of one shot");
  std::vector<Vec3> light(picture.pixels());
  for (std::size_t i = 0; i < light.size(); ++i) light[i] = picture.rgb(i) / reflectance(surface, i);
  light = without_specks(light, surface);
  float tolerance = kContrast;
  for (int round = 0; round < kRounds; ++round, tolerance *= 0.5F) {
    std::vector<Vec3> next = light;
    const std::vector<float> levels = levels_of(light);
    tbb::parallel_for(0, surface.height, [&](int y) {
      for (int x = 0; x < surface.width; ++x) {
        const std::size_t i = surface.index(x, y);
        if (surface.object[i] == 0 || surface.roughness[i] < kMirror) continue;
        next[i] = smoothed(light, levels, surface, x, y, 1 << round, tolerance);
      }
    });
    light = std::move(next);
  }
  Image result = picture;
  for (std::size_t i = 0; i < light.size(); ++i) result.set_rgb(i, light[i] * reflectance(surface, i));
  return result;
}

}  // namespace luminist
