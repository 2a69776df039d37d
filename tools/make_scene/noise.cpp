#include "make_scene/noise.h"

#include <algorithm>
#include <cmath>

namespace luminist {
namespace {

std::uint32_t scramble(std::uint32_t h) {
  h ^= h >> 16;
  h *= 0x7feb352dU;
  h ^= h >> 15;
  h *= 0x846ca68bU;
  return h ^ (h >> 16);
}

std::uint32_t hash_cell(int x, int y, int z) {
  std::uint32_t h = scramble(static_cast<std::uint32_t>(x) + 0x9e3779b9U);
  h = scramble(h ^ (static_cast<std::uint32_t>(y) * 0x85ebca6bU + 0x165667b1U));
  return scramble(h ^ (static_cast<std::uint32_t>(z) * 0xc2b2ae35U + 0x27d4eb2fU));
}

double unit_from(std::uint32_t h) {
  return static_cast<double>(h) / 4294967296.0;
}

int wrapped(int i, int period) {
  return period <= 0 ? i : ((i % period) + period) % period;
}

/// Dot product of the offset with one of twelve directions to the edges of a cube (Perlin 2002).
double gradient_dot(std::uint32_t h, const Point3& d) {
  const std::uint32_t k = h % 12U;
  const double a = k < 8U ? d.x : d.y;
  const double b = k < 4U ? d.y : d.z;
  return ((h >> 8U) & 1U ? -a : a) + ((h >> 9U) & 1U ? -b : b);
}

double fade(double t) {
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

}  // namespace

double noise(const Point3& p, int period) {
  const Point3 base = glm::floor(p);
  const Point3 f = p - base;
  const int x = static_cast<int>(base.x);
  const int y = static_cast<int>(base.y);
  const int z = static_cast<int>(base.z);
  double corner[8];
  for (int i = 0; i < 8; ++i) {
    const int dx = i & 1;
    const int dy = (i >> 1) & 1;
    const int dz = i >> 2;
    const std::uint32_t h = hash_cell(wrapped(x + dx, period), wrapped(y + dy, period), wrapped(z + dz, period));
    corner[i] = gradient_dot(h, f - Point3(dx, dy, dz));
  }
  const double u = fade(f.x);
  const double v = fade(f.y);
  const double low = mix(mix(corner[0], corner[1], u), mix(corner[2], corner[3], u), v);
  const double high = mix(mix(corner[4], corner[5], u), mix(corner[6], corner[7], u), v);
  return mix(low, high, fade(f.z));
}

double fbm(const Point3& p, int octaves, int period) {
  double sum = 0.0;
  double weight = 0.5;
  double frequency = 1.0;
  for (int i = 0; i < octaves; ++i) {
    sum += weight * noise(p * frequency + Point3(17.0 * i, 31.0 * i, 7.0 * i), period << i);
    weight *= 0.5;
    frequency *= 2.0;
  }
  return sum;
}

CellSample cells(const Point3& p, int period) {
  const Point3 base = glm::floor(p);
  CellSample sample{1e9, 1e9, 0};
  for (int i = 0; i < 27; ++i) {
    const Point3 cell = base + Point3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const std::uint32_t h =
        hash_cell(wrapped(static_cast<int>(cell.x), period), wrapped(static_cast<int>(cell.y), period),
                  wrapped(static_cast<int>(cell.z), period));
    const Point3 jitter{unit_from(h), unit_from(scramble(h + 1U)), unit_from(scramble(h + 2U))};
    const double distance = glm::length(cell + jitter - p);
    if (distance < sample.nearest) {
      sample = {distance, sample.nearest, scramble(h + 3U)};
    } else {
      sample.second = std::min(sample.second, distance);
    }
  }
  return sample;
}

double hash01(int x, int y, int z) {
  return unit_from(hash_cell(x, y, z));
}

double Random::next() {
  state_ += 0x9e3779b97f4a7c15ULL;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
}

double smoothstep(double lo, double hi, double x) {
  const double t = std::clamp((x - lo) / (hi - lo), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double mix(double a, double b, double t) {
  return a + (b - a) * t;
}

}  // namespace luminist
