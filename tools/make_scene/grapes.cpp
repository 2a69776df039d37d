#include <cmath>
#include <vector>

#include "make_scene/curve.h"
#include "make_scene/fruit.h"
#include "make_scene/noise.h"
#include "make_scene/painting.h"

namespace luminist {
namespace {

constexpr double kBerry = 0.0098;  // radius

struct Berry {
  Point3 place;
  double radius;
};

/// Berries start in a cone and are pushed apart and down until they rest in a heap.
std::vector<Berry> heap(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Berry> berries;
  for (int i = 0; i < count; ++i) {
    const double t = std::sqrt(random.next());
    const double spread = 0.036 * (1.05 - t) + 0.004;
    const double angle = random.range(0.0, 2.0 * kPi);
    const double away = spread * std::sqrt(random.next());
    const double radius = kBerry * random.range(0.88, 1.10);
    berries.push_back({{0.008 + 0.080 * t, 0.020 + std::abs(std::sin(angle)) * away, std::cos(angle) * away}, radius});
  }
  for (int round = 0; round < 300; ++round) {
    for (Berry& berry : berries) {
      berry.place.y -= 0.00012;
      berry.place.z *= 0.993;
    }
    for (std::size_t i = 0; i < berries.size(); ++i) {
      for (std::size_t j = i + 1; j < berries.size(); ++j) {
        const Point3 apart = berries[j].place - berries[i].place;
        const double distance = glm::length(apart);
        const double wanted = 0.96 * (berries[i].radius + berries[j].radius);
        if (distance >= wanted || distance < 1e-9) continue;
        const Point3 push = apart * (0.5 * (wanted - distance) / distance);
        berries[i].place -= push;
        berries[j].place += push;
      }
    }
    for (Berry& berry : berries) berry.place.y = std::max(berry.place.y, berry.radius);
  }
  return berries;
}

Mesh berry_mesh(const Berry& berry, Random& random) {
  const double turn = random.range(0.0, 2.0 * kPi);
  const double tilt = random.range(-0.9, 0.9);
  const double patch = random.next();  // every berry has its own part of the texture
  const Surface round = [&](double u, double v) {
    const double around = 2.0 * kPi * u;
    const double down = kPi * (1.0 - v);
    const Point3 d{std::sin(down) * std::sin(around), 1.10 * std::cos(down), std::sin(down) * std::cos(around)};
    const Point3 tilted{d.x, d.y * std::cos(tilt) - d.z * std::sin(tilt), d.y * std::sin(tilt) + d.z * std::cos(tilt)};
    const Point3 turned{tilted.x * std::cos(turn) + tilted.z * std::sin(turn), tilted.y,
                        tilted.z * std::cos(turn) - tilted.x * std::sin(turn)};
    return berry.place + turned * (berry.radius * 0.97);
  };
  Mesh mesh = tessellate(round, 18, 11);
  for (Vec2& uv : mesh.uvs) uv.x = 0.25F * uv.x + static_cast<float>(patch);
  return mesh;
}

}  // namespace

Mesh grapes_mesh(int count, std::uint64_t seed) {
  Random random(seed + 1);
  Mesh bunch;
  for (const Berry& berry : heap(count, seed)) append(bunch, berry_mesh(berry, random));
  return bunch;
}

Mesh grape_stems_mesh() {
  const Curve main({{-0.030, 0.026, 0.006, 0.0024},
                    {-0.022, 0.031, 0.004, 0.0018},
                    {-0.008, 0.030, 0.001, 0.0018},
                    {0.012, 0.026, 0.000, 0.0017},
                    {0.040, 0.020, 0.002, 0.0014},
                    {0.080, 0.014, 0.001, 0.0009}});
  const Curve bar({{-0.034, 0.021, -0.012, 0.0020}, {-0.030, 0.026, 0.004, 0.0025}, {-0.028, 0.024, 0.020, 0.0018}});
  Mesh stems = tessellate(sweep(main), 10, 40);
  append(stems, tessellate(sweep(bar), 10, 24));
  return stems;
}

Image grape_painting(int width, int height) {
  return paint_color(width, height, [](double u, double v) {
    const double around = 2.0 * kPi * u;
    const Point3 p{std::cos(around), std::sin(around), 2.0 * v};
    const double bloom = smoothstep(-0.15, 0.45, fbm(p * 2.6, 4));
    const Vec3 skin = mix(swatch(0x3A1430), swatch(0x5A1A34), std::clamp(0.5 + 0.9 * noise(p * 1.7), 0.0, 1.0));
    return mix(skin, swatch(0x8A7F9E), 0.5 * bloom);
  });
}

}  // namespace luminist
