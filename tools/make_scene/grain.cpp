#include "make_scene/grain.h"

#include <cmath>

#include "make_scene/noise.h"

namespace luminist {
namespace {

/// A grain value in about [0,1] that repeats with u and v: rings cut lengthwise, fibres, pores.
struct Grain {
  double ring;
  double fibre;
  double pore;
};

Grain grain_at(double u, double v) {
  const double warp = 0.55 * noise({u * 2.0, v * 2.0, 1.3}, 2) + 0.20 * noise({u * 4.0, v * 8.0, 4.1}, 4);
  const double across = v * 9.0 + warp * 1.6;
  const double ring = 0.5 + 0.5 * std::sin(2.0 * kPi * across);
  const double fibre = 0.5 + 0.9 * fbm({u * 4.0, v * 64.0, 2.0}, 3, 4 * 16);
  const double pore = noise({u * 16.0, v * 128.0, 7.7}, 16);
  return {std::pow(ring, 2.2), fibre, smoothstep(0.30, 0.55, pore)};
}

}  // namespace

Image wood_painting(int width, int height, const Vec3& light, const Vec3& dark) {
  return paint_color(width, height, [&](double u, double v) {
    const Grain g = grain_at(u, v);
    const double t = std::clamp(0.55 * g.ring + 0.45 * g.fibre, 0.0, 1.0);
    return mix(light, dark, t) * static_cast<float>(1.0 - 0.35 * g.pore);
  });
}

Image wood_relief(int width, int height, const Point2& extent) {
  return paint_normals(
      width, height,
      [](double u, double v) {
        const Grain g = grain_at(u, v);
        return 0.00018 * g.fibre - 0.00035 * g.pore - 0.00010 * g.ring;
      },
      extent);
}

Image wood_roughness(int width, int height) {
  return paint_roughness(width, height, [](double u, double v) {
    const Grain g = grain_at(u, v);
    return std::clamp(0.42 + 0.16 * g.fibre + 0.25 * g.pore, 0.2, 0.9);
  });
}

Image plaster_painting(int size, const Vec3& tint, double unevenness) {
  return paint_color(size, size, [&](double u, double v) {
    const double cloud = fbm({u * 3.0, v * 3.0, 0.5}, 4, 3);
    const double stain = smoothstep(0.10, 0.45, fbm({u * 2.0, v * 2.0, 5.5}, 3, 2));
    const double value = 1.0 + unevenness * (1.1 * cloud - 0.5 * stain);
    return tint * static_cast<float>(value) * mix(Vec3(1.0F), Vec3(1.0F, 0.96F, 0.90F), stain);
  });
}

Image plaster_relief(int size, double extent) {
  return paint_normals(
      size, size,
      [](double u, double v) {
        const double wave = fbm({u * 5.0, v * 5.0, 3.0}, 3, 5);
        const double ridge = 1.0 - std::abs(noise({u * 9.0 + wave, v * 9.0 - wave, 1.0}, 9));
        return 0.0032 * wave + 0.0009 * ridge * ridge + 0.00035 * fbm({u * 48.0, v * 48.0, 9.0}, 2, 48);
      },
      {extent, extent});
}

Image weave_relief(int size, int threads, double extent) {
  const double depth = 0.22 * extent / threads;
  return paint_normals(size, size,
                       [=](double u, double v) {
                         const double x = u * threads;
                         const double y = v * threads;
                         const double warp = std::abs(std::sin(kPi * x)) *
                                             (0.5 + 0.5 * std::cos(kPi * y) * std::cos(kPi * std::floor(x)));
                         const double weft = std::abs(std::sin(kPi * y)) *
                                             (0.5 - 0.5 * std::cos(kPi * x) * std::cos(kPi * std::floor(y)));
                         const double uneven = 1.0 + 0.35 * noise({u * 8.0, v * 8.0, 2.0}, 8);
                         return depth * uneven * std::max(warp, weft);
                       },
                       {extent, extent});
}

}  // namespace luminist
