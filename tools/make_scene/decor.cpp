#include "make_scene/decor.h"

#include <cmath>

#include "make_scene/curve.h"
#include "make_scene/noise.h"
#include "make_scene/painting.h"
#include "make_scene/slab.h"

namespace luminist {

Mesh mirror_glass(double a, double b) {
  return tessellate(
      [=](double u, double v) {
        const double turn = 2.0 * kPi * u;
        return Point3(a * v * std::sin(turn), b * v * std::cos(turn), 0.0);
      },
      64, 1);
}

Mesh mirror_frame(double a, double b) {
  const Curve profile = Curve::profile({{-0.004, -0.012},
                                        {-0.006, 0.004},
                                        {0.002, 0.012},
                                        {0.010, 0.010},
                                        {0.016, 0.018},
                                        {0.030, 0.034},
                                        {0.044, 0.036},
                                        {0.054, 0.026},
                                        {0.060, 0.022},
                                        {0.066, 0.014},
                                        {0.066, -0.012}});
  return tessellate(
      [=](double u, double v) {
        const double turn = 2.0 * kPi * u;
        const Point4 p = profile.at(v);
        const double bead = 0.0035 * std::sin(turn * 60.0) * std::exp(-std::pow((p.x - 0.006) / 0.006, 2.0));
        return Point3((a + p.x) * std::sin(turn), (b + p.x) * std::cos(turn), p.y + bead);
      },
      200, 18);
}

Mesh books_on_board(float half, float height, int color, int colors, std::uint64_t seed) {
  Random random(seed);
  Mesh books;
  float x = -half + 0.01F;
  while (true) {
    const auto thick = static_cast<float>(random.range(0.012, 0.032));
    const auto tall = height * static_cast<float>(random.range(0.62, 0.93));
    const auto deep = static_cast<float>(random.range(0.075, 0.098));
    const auto inset = static_cast<float>(random.range(0.0, 0.015));
    const bool leans = random.next() < 0.10;
    const bool gap = random.next() < 0.05;
    const int binding = static_cast<int>(random.next() * colors);
    const float lean = leans ? 0.16F : 0.0F;
    if (x + thick + lean * tall > half - 0.01F) break;
    if (binding == color) {
      const float bevel = 0.0025F;
      Mesh book = slab({0.5F * thick, 0.5F * tall, deep}, bevel, 0.2F, 1);
      Placement place;
      place.angles.z = lean;
      place.position = {x + 0.5F * thick + 0.5F * lean * tall, 0.5F * tall, -deep - inset};
      if (leans) place.position.y += 0.5F * lean * thick;
      transform(book, place.matrix());
      append(books, book);
    }
    x += thick + 0.0015F + lean * tall + (gap ? 0.05F : 0.0F);
  }
  return books;
}

Mesh pot_mesh() {
  const Curve profile = Curve::profile({{0.00, 0.000},
                                        {0.09, 0.000},
                                        {0.105, 0.006},
                                        {0.115, 0.05},
                                        {0.135, 0.15},
                                        {0.150, 0.235},
                                        {0.165, 0.240},
                                        {0.170, 0.262},
                                        {0.166, 0.285},
                                        {0.155, 0.286},
                                        {0.148, 0.26},
                                        {0.140, 0.245},
                                        {0.00, 0.240}});
  return tessellate(revolve(profile), 56, 50);
}

namespace {

struct Leaf {
  Point3 root;
  double turn;
  double rise;
  double length;
};

std::vector<Leaf> leaf_places(int leaves, std::uint64_t seed) {
  Random random(seed);
  std::vector<Leaf> places;
  for (int i = 0; i < leaves; ++i) {
    const double t = (i + 0.5) / leaves;
    const double turn = 2.39996 * i + random.range(-0.3, 0.3);
    const double lean = random.range(0.02, 0.07);
    const Point3 root{lean * std::sin(turn), 0.34 + 0.78 * t, lean * std::cos(turn)};
    places.push_back(
        {root, turn, 0.35 + 0.75 * t + random.range(-0.15, 0.15), random.range(0.24, 0.34) * (1.0 - 0.25 * t)});
  }
  return places;
}

}  // namespace

Mesh leaves_mesh(int leaves, std::uint64_t seed) {
  Mesh mesh;
  for (const Leaf& leaf : leaf_places(leaves, seed)) {
    const Point3 out{std::sin(leaf.turn), 0.0, std::cos(leaf.turn)};
    const Point3 side{out.z, 0.0, -out.x};
    const Surface blade = [=](double u, double v) {
      const double across = 2.0 * u - 1.0;
      const double width = 0.30 * leaf.length * std::pow(std::sin(kPi * std::pow(v, 0.8) * 0.98 + 0.03), 0.8);
      const double stalk = 0.06 + v * leaf.length;
      const double up = stalk * std::sin(leaf.rise) - 0.9 * v * v * leaf.length * 0.55;
      const double fold =
          0.22 * width * std::abs(across) * std::abs(across) + 0.006 * std::sin(v * 22.0) * std::abs(across);
      return leaf.root + out * (stalk * std::cos(leaf.rise) * 0.95) + side * (across * width) +
             Point3(0.0, up + fold, 0.0);
    };
    append(mesh, tessellate(blade, 8, 14));
  }
  return mesh;
}

Mesh plant_stems(int leaves, std::uint64_t seed) {
  Mesh stems = tessellate(
      sweep(
          Curve(
              {{0.0, 0.22, 0.0, 0.013}, {0.01, 0.55, 0.01, 0.011}, {-0.01, 0.90, 0.0, 0.008}, {0.0, 1.18, 0.0, 0.003}}),
          {0.0, 0.0, 1.0}),
      12, 30);
  for (const Leaf& leaf : leaf_places(leaves, seed)) {
    const Point3 out{std::sin(leaf.turn), std::tan(std::min(leaf.rise, 1.2)), std::cos(leaf.turn)};
    const Point3 end = leaf.root + glm::normalize(out) * 0.085;
    const Point3 foot{0.0, leaf.root.y - 0.05, 0.0};
    append(stems, tessellate(sweep(Curve({{foot.x, foot.y, foot.z, 0.005},
                                          {leaf.root.x, leaf.root.y, leaf.root.z, 0.0045},
                                          {end.x, end.y, end.z, 0.004}}),
                                   {0.31, 0.2, 0.93}),
                             8, 8));
  }
  return stems;
}

Image leaf_painting(int width, int height) {
  return paint_color(width, height, [](double u, double v) {
    const double across = std::abs(2.0 * u - 1.0);
    const double rib = std::abs(std::remainder(v * 11.0 - across * 2.2, 1.0));
    Vec3 color = mix(swatch(0x1F4A26), swatch(0x3F7A3A), 0.5 + 0.6 * fbm({u * 5.0, v * 8.0, 1.0}, 3));
    color = mix(color, swatch(0x7FA85A), 0.45 * smoothstep(0.10, 0.02, rib));
    return mix(color, swatch(0xA8BE72), 0.8 * smoothstep(0.07, 0.02, across));
  });
}

Image landscape_painting(int width, int height) {
  return paint_color(width, height, [](double u, double v) {
    const double brush = 0.03 * noise({u * 26.0, v * 40.0, 1.0});
    const double y = v + brush * 0.5;
    const double far = 0.50 + 0.06 * fbm({u * 3.0, 0.0, 2.0}, 4);
    const double hill = 0.62 + 0.10 * std::sin(u * 4.0 + 0.6) + 0.05 * fbm({u * 6.0, 0.0, 5.0}, 3);
    const double cloud = smoothstep(0.05, 0.4, fbm({u * 3.0, v * 7.0, 9.0}, 4));
    Vec3 color = mix(mix(swatch(0x7FA2BE), swatch(0xEBCB9A), smoothstep(0.05, 0.5, y)), swatch(0xF3E6D0), 0.7 * cloud);
    if (y > far) color = mix(swatch(0x7D8CA0), swatch(0x93A08C), smoothstep(far, far + 0.15, y));
    if (y > hill)
      color = mix(mix(swatch(0x5F7A3C), swatch(0xA89A48), 0.5 + 0.9 * fbm({u * 8.0, v * 12.0, 4.0}, 3)),
                  swatch(0x37482A), smoothstep(0.75, 1.05, y));
    const double tree = std::hypot((u - 0.24) * 1.3, (v - 0.50) * 0.9) + 0.05 * noise({u * 14.0, v * 14.0, 3.0});
    if (tree < 0.15) color = mix(swatch(0x24371E), swatch(0x5C6E2C), smoothstep(0.15, 0.0, tree + 0.3 * (u - 0.2)));
    if (std::abs(u - 0.24) < 0.012 && v > 0.6 && v < 0.80) color = swatch(0x3A2A1C);
    return color * static_cast<float>(1.0 + 2.0 * brush);
  });
}

Image rug_painting(int width, int height) {
  return paint_color(width, height, [](double u, double v) {
    const double x = std::abs(2.0 * u - 1.0);
    const double y = std::abs(2.0 * v - 1.0);
    const double edge = std::max(x + 0.0, 1.0 - (1.0 - y) * 0.68);  // both borders equally wide on a rug of 3 to 2
    const double wool = 1.0 + 0.22 * noise({u * 140.0, v * 95.0, 1.0}) + 0.12 * noise({u * 9.0, v * 6.0, 4.0});
    Vec3 color = swatch(0x7A1F22);
    const double diamond = std::remainder((x * 1.5 + y) * 5.0, 1.0);
    const double cross = std::remainder((x * 1.5 - y) * 5.0, 1.0);
    if (std::abs(diamond) < 0.09 || std::abs(cross) < 0.09) color = swatch(0xB58A4A);
    if (std::abs(diamond) + std::abs(cross) < 0.24) color = swatch(0x1E2E4A);
    const double medal = std::hypot(x * 1.5, y);
    const double lobes = 0.46 + 0.06 * std::cos(8.0 * std::atan2(y, x * 1.5));
    if (medal < lobes) color = swatch(0x1E2E4A);
    if (std::abs(medal - lobes) < 0.022 || medal < 0.10) color = swatch(0xD8C08A);
    if (medal > 0.18 && medal < 0.27 && std::cos(8.0 * std::atan2(y, x * 1.5)) > 0.0) color = swatch(0xA03A2A);
    if (edge > 0.80) color = swatch(0x1E2E4A);
    if (edge > 0.80 && edge < 0.94) {
      const double motif = std::remainder(x > 1.0 - (1.0 - y) * 0.68 ? v * 14.0 : u * 21.0, 1.0);
      if (std::abs(motif) + std::abs(edge - 0.87) * 6.0 < 0.36) color = swatch(0xC9963F);
    }
    if (std::abs(edge - 0.80) < 0.012 || std::abs(edge - 0.945) < 0.012) color = swatch(0xD8C08A);
    return color * static_cast<float>(wool);
  });
}

Mesh rug_mesh(float half_x, float half_z) {
  return tessellate(
      [=](double u, double v) {
        const double x = (2.0 * u - 1.0) * half_x;
        const double z = (1.0 - 2.0 * v) * half_z;
        const double rim = smoothstep(0.0, 0.03, std::min({u, 1.0 - u, v, 1.0 - v}));
        return Point3(x + 0.006 * noise({z * 4.0, 1.0, 0.0}),
                      0.001 + 0.007 * rim + 0.0025 * rim * noise({x * 5.0, z * 5.0, 2.0}), z);
      },
      48, 32);
}

}  // namespace luminist
