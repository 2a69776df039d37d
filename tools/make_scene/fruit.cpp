#include "make_scene/fruit.h"

#include <cmath>

#include "make_scene/curve.h"
#include "make_scene/noise.h"
#include "make_scene/painting.h"

namespace luminist {
namespace {

/// v = 0 is the lowest point, as in the meshes.
Point3 on_sphere(double u, double v) {
  const double around = 2.0 * kPi * u;
  const double down = kPi * v;
  return {std::sin(down) * std::sin(around), -std::cos(down), std::sin(down) * std::cos(around)};
}

Curve apple_profile() {
  return Curve::profile({{0.0000, 0.0090},
                         {0.0040, 0.0072},
                         {0.0085, 0.0030},
                         {0.0150, 0.0000},
                         {0.0230, 0.0040},
                         {0.0320, 0.0170},
                         {0.0380, 0.0350},
                         {0.0375, 0.0490},
                         {0.0310, 0.0610},
                         {0.0220, 0.0665},
                         {0.0130, 0.0655},
                         {0.0060, 0.0600},
                         {0.0020, 0.0545},
                         {0.0000, 0.0530}});
}

Curve pear_profile() {
  return Curve::profile({{0.0000, 0.0050},
                         {0.0040, 0.0040},
                         {0.0100, 0.0000},
                         {0.0180, 0.0020},
                         {0.0275, 0.0130},
                         {0.0325, 0.0290},
                         {0.0310, 0.0430},
                         {0.0250, 0.0560},
                         {0.0185, 0.0670},
                         {0.0150, 0.0770},
                         {0.0125, 0.0850},
                         {0.0085, 0.0895},
                         {0.0040, 0.0895},
                         {0.0000, 0.0875}});
}

/// The pear's axis leans and bends.
Point3 bent(const Point3& p) {
  const double t = p.y / 0.1;
  return {p.x + 0.013 * t * t, p.y - 0.002 * t * t, p.z + 0.003 * t};
}

}  // namespace

Mesh apple_mesh(std::uint64_t seed) {
  Random random(seed);
  const double phase = random.range(0.0, 2.0 * kPi);
  const double lean = random.range(0.05, 0.10);
  const double squash = random.range(0.95, 1.04);
  const Surface round = revolve(apple_profile());
  const Surface apple = [=](double u, double v) {
    Point3 p = round(u, v);
    const double angle = 2.0 * kPi * u + phase;
    const double low = smoothstep(0.045, 0.0, p.y);
    const double lobes = 1.0 + (0.012 + 0.040 * low) * std::cos(5.0 * angle) + 0.018 * std::cos(2.0 * angle + 1.0);
    p.x *= lobes, p.z *= lobes;
    p.y = p.y * squash + lean * p.x + (1.0 - lobes) * 0.02 * low;
    return p;
  };
  return tessellate(apple, 52, 34);
}

Mesh apple_stem_mesh(std::uint64_t seed) {
  Random random(seed);
  const double way = random.range(-1.0, 1.0);
  const Curve path({{0.0, 0.0500, 0.0, 0.0022},
                    {0.001 * way, 0.0590, 0.001, 0.0014},
                    {0.004 * way, 0.0680, 0.002, 0.0013},
                    {0.009 * way, 0.0760, 0.002, 0.0016},
                    {0.010 * way, 0.0772, 0.002, 0.0002}});
  return tessellate(sweep(path, {0.0, 0.0, 1.0}), 12, 20);
}

Image apple_painting(int width, int height, double blush) {
  const Vec3 yellow = swatch(0xD9B64A);
  const Vec3 green = swatch(0xA5B04A);
  const Vec3 red = swatch(0xB0222A);
  const Vec3 deep = swatch(0x7C1220);
  return paint_color(width, height, [=](double u, double v) {
    const Point3 p = on_sphere(u, v);
    const double angle = 2.0 * kPi * u;
    const double warp = 0.06 * noise(p * 4.0);
    const Point3 fibre{std::cos(angle + warp) * 15.0, std::sin(angle + warp) * 15.0, p.y * 1.1};
    const double streak = 0.5 + 0.9 * fbm(fibre, 3);
    const double sun = 0.5 + 0.5 * (0.75 * p.x + 0.35 * p.z) + 0.45 * fbm(p * 1.7 + Point3(4.0), 2);
    const double cover = smoothstep(1.05 - blush, 1.75 - blush, sun + 0.55 * streak);
    Vec3 color =
        mix(yellow, green, smoothstep(0.2, 0.9, 0.5 + 0.8 * p.y * (p.y > 0.0 ? 1.0 : -0.3) + 0.3 * noise(p * 2.2)));
    color = mix(color, mix(red, deep, smoothstep(0.5, 1.0, streak) * 0.8), cover);
    const double cavity = smoothstep(0.90, 0.97, p.y);
    color = mix(color, swatch(0x8A7A3A), 0.75 * cavity);
    const CellSample dot = cells(p * 17.0);
    return mix(color, swatch(0xE6CF96), 0.55 * smoothstep(0.16, 0.06, dot.nearest) * (dot.id % 3U == 0U ? 1.0 : 0.2));
  });
}

Mesh orange_mesh() {
  const Surface orange = [](double u, double v) {
    const Point3 d = on_sphere(u, v);
    const double navel =
        std::exp(-std::pow((1.0 - d.y) / 0.012, 2.0)) + 0.8 * std::exp(-std::pow((1.0 + d.y) / 0.012, 2.0));
    const double radius = 0.038 * (1.0 + 0.014 * fbm(d * 1.6, 2)) - 0.0018 * navel;
    return Point3(d.x * radius, 0.0355 + d.y * radius * 0.94, d.z * radius);
  };
  return tessellate(orange, 52, 32);
}

Image orange_painting(int width, int height) {
  return paint_color(width, height, [](double u, double v) {
    const Point3 p = on_sphere(u, v);
    const double cloud = 0.5 + 0.9 * fbm(p * 2.3, 3);
    Vec3 color = mix(swatch(0xE0801C), swatch(0xEE9C2E), std::clamp(cloud, 0.0, 1.0));
    color = mix(color, swatch(0xC9661A), 0.5 * smoothstep(0.30, 0.12, cells(p * 26.0).nearest));
    return mix(color, swatch(0x6F7B32), 0.85 * smoothstep(0.9935, 0.9975, p.y));
  });
}

Image orange_pores(int width, int height) {
  return paint_normals(width, height,
                       [](double u, double v) {
                         const Point3 p = on_sphere(u, v);
                         return -0.00042 * smoothstep(0.60, 0.08, cells(p * 21.0).nearest) + 0.0011 * noise(p * 5.0);
                       },
                       {2.0 * kPi * 0.038 * 0.75, kPi * 0.038});  // about the circumference between equator and poles
}

Mesh pear_mesh() {
  const Surface round = revolve(pear_profile());
  const Surface pear = [=](double u, double v) {
    Point3 p = round(u, v);
    const double bump = 1.0 + 0.05 * fbm(p * 38.0 + Point3(3.0), 2);
    p.x *= bump, p.z *= bump;
    return bent(p);
  };
  return tessellate(pear, 52, 40);
}

Mesh pear_stem_mesh() {
  const Point3 foot = bent({0.0, 0.086, 0.0});
  const Curve path({{foot.x, foot.y, foot.z, 0.0026},
                    {foot.x + 0.002, foot.y + 0.008, foot.z, 0.0017},
                    {foot.x + 0.001, foot.y + 0.017, foot.z + 0.001, 0.0015},
                    {foot.x - 0.004, foot.y + 0.025, foot.z + 0.002, 0.0021},
                    {foot.x - 0.0046, foot.y + 0.0262, foot.z + 0.002, 0.0003}});
  return tessellate(sweep(path, {0.0, 0.0, 1.0}), 12, 24);
}

Image pear_painting(int width, int height) {
  return paint_color(width, height, [](double u, double v) {
    const Point3 p = on_sphere(u, v) * Point3(1.0, 1.6, 1.0);
    Vec3 color = mix(swatch(0xC3B443), swatch(0x97A23C), std::clamp(0.5 + 1.1 * fbm(p * 1.8, 3), 0.0, 1.0));
    const double sun = smoothstep(0.15, 0.95, 0.8 * p.z - 0.3 * p.x - 0.15 * p.y + 0.5 * fbm(p * 2.4 + Point3(7.0), 3));
    color = mix(color, swatch(0xB4552C), 0.72 * sun);
    const double russet =
        smoothstep(1.15, 1.55, p.y + 0.25 * noise(p * 9.0)) + smoothstep(-1.35, -1.58, p.y + 0.1 * noise(p * 9.0));
    color = mix(color, swatch(0x8C6A34), 0.75 * std::min(russet, 1.0));
    const CellSample dot = cells(p * 21.0);
    return mix(color, swatch(0x6F5A28), 0.6 * smoothstep(0.20, 0.08, dot.nearest) * (dot.id % 2U == 0U ? 1.0 : 0.3));
  });
}

}  // namespace luminist
