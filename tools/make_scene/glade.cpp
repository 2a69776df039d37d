#include "make_scene/glade.h"

#include <cmath>

#include "make_scene/curve.h"
#include "make_scene/noise.h"
#include "make_scene/painting.h"

namespace luminist {

double ground_height(double x, double z) {
  const double away = std::hypot(x, z - 0.1);
  const double flat = smoothstep(0.8, 2.2, away);
  return flat * (0.22 * fbm({x * 0.7, 1.0, z * 0.7}, 4) + 0.02 * away) - 0.012 +
         0.03 * flat * noise({x * 4.0, 3.0, z * 4.0});
}

Mesh ground_mesh() {
  const Surface ground = [](double u, double v) {
    const double x = -6.2 + 12.4 * u;
    const double z = 4.4 - 8.0 * v;
    return Point3(x, ground_height(x, z), z);
  };
  Mesh mesh = tessellate(ground, 80, 64);
  scale_uvs(mesh, {2.6F, 2.0F});
  return mesh;
}

Image ground_painting(int size) {
  return paint_color(size, size, [](double u, double v) {
    const double patch = smoothstep(-0.12, 0.25, fbm({u * 4.0, v * 4.0, 0.7}, 4, 4));
    const double tuft = 0.5 + 0.8 * fbm({u * 24.0, v * 24.0, 3.0}, 3, 24);
    const Vec3 soil = mix(swatch(0x4A3A2A), swatch(0x776044), tuft);
    const Vec3 moss = mix(swatch(0x2E3F1E), swatch(0x6C7A34), tuft);
    const CellSample pebble = cells({u * 22.0, v * 22.0, 0.5}, 22);
    const Vec3 color = mix(soil, moss, patch);
    const double stone = smoothstep(0.24, 0.16, pebble.nearest) * (pebble.id % 4U == 0U ? 1.0 : 0.0) * (1.0 - patch);
    return mix(color, swatch(0x8F8470), stone);
  });
}

Image ground_relief(int size) {
  return paint_normals(size, size,
                       [](double u, double v) {
                         const CellSample pebble = cells({u * 22.0, v * 22.0, 0.5}, 22);
                         const double stone =
                             std::max(0.0, 0.24 - pebble.nearest) * (pebble.id % 4U == 0U ? 0.35 : 0.05);
                         return 0.10 * fbm({u * 24.0, v * 24.0, 3.0}, 3, 24) + stone;
                       },
                       {4.0, 4.0});
}

Mesh hollow_mesh() {
  const Surface rock = [](double u, double v) {
    const double angle = kPi * (1.12 - 1.24 * u);  // from the left around behind to the right
    const double y = -0.4 + 8.4 * v;
    const Point3 out{std::cos(angle), 0.0, -std::sin(angle)};
    const Point3 sample = out * 3.4 + Point3(0.0, y, 0.0);
    const double ledge = std::abs(noise(sample * Point3(0.35, 1.3, 0.35)));
    const double relief = 0.75 * fbm(sample * 0.55, 4) + 0.30 * ledge;
    const double radius = 3.5 + relief - 0.035 * (y - 1.0) * (y - 1.0) - 0.5 * smoothstep(0.8, -0.4, y);
    return Point3(out.x * radius * 1.65, y, out.z * radius * 0.80 + 0.3);
  };
  Mesh mesh = tessellate(rock, 100, 66);
  scale_uvs(mesh, {3.0F, 2.0F});
  return mesh;
}

namespace {

/// How deep the joints between beds of rock are at a place of the texture, 0 to 1.
double bed_depth(double u, double v) {
  const double bend = 0.9 * fbm({u * 3.0, v * 3.0, 1.0}, 4, 3);
  const double joint = std::abs(std::remainder(v * 4.0 + bend, 1.0));
  return smoothstep(0.14, 0.0, joint) * smoothstep(-0.25, 0.20, noise({u * 5.0, v * 5.0, 6.0}, 5));
}

}  // namespace

Image rock_painting(int size) {
  return paint_color(size, size, [](double u, double v) {
    const double cloud = 0.5 + 0.9 * fbm({u * 4.0, v * 4.0, 2.0}, 5, 4);
    Vec3 color = mix(swatch(0x6E665C), swatch(0x9A8E7C), std::clamp(cloud, 0.0, 1.0));
    color = mix(color, swatch(0x4A4A34), 0.6 * smoothstep(0.15, 0.5, fbm({u * 3.0, v * 3.0, 6.0}, 4, 3)));
    return mix(color, swatch(0x3A342E), 0.55 * smoothstep(0.05, 0.45, bed_depth(u, v)));
  });
}

Image rock_relief(int size) {
  return paint_normals(size, size,
                       [](double u, double v) {
                         return 0.15 * fbm({u * 8.0, v * 8.0, 4.0}, 5, 8) - 0.07 * bed_depth(u, v);
                       },
                       {3.6, 3.6});
}

namespace {

/// The stalk's axis: it leans and straightens.
Point3 stalk_at(double height, double lean, double t) {
  return {lean * (t - 0.35 * t * t), height * t, 0.25 * lean * t};
}

}  // namespace

Mesh toadstool_stalk(double height, double lean) {
  std::vector<Point4> knots;
  for (int i = 0; i <= 6; ++i) {
    const double t = i / 6.0;
    const double radius = height * (0.105 - 0.045 * t + 0.05 * std::pow(1.0 - t, 4.0) +
                                    0.05 * std::exp(-std::pow((t - 0.72) / 0.05, 2.0)));
    knots.emplace_back(stalk_at(height, lean, t), radius);
  }
  return tessellate(sweep(Curve(knots), {0.0, 0.0, 1.0}), 20, 30);
}

Mesh toadstool_cap(double height, double lean, double radius) {
  const Curve profile = Curve::profile({{0.00, -0.02},
                                        {0.20, -0.02},
                                        {0.60, -0.06},
                                        {0.90, -0.10},
                                        {1.00, -0.07},
                                        {0.99, 0.03},
                                        {0.86, 0.24},
                                        {0.62, 0.42},
                                        {0.32, 0.52},
                                        {0.00, 0.55}});
  const Surface round = revolve(profile);
  const Point3 top = stalk_at(height, lean, 1.0);
  return tessellate(
      [=](double u, double v) {
        Point3 p = round(u, v) * radius;
        const Point3 d = glm::normalize(p + Point3(0.0, 0.01, 0.0));
        const CellSample wart = cells(d * 4.2);
        if (v > 0.5) p += d * (0.045 * radius * smoothstep(0.34, 0.22, wart.nearest));
        return Point3(p.x, p.y + 0.12 * p.x * (lean > 0.0 ? -1.0 : 1.0), p.z) + top;
      },
      36, 24);
}

Image cap_painting(int width, int height) {
  const Curve profile = Curve::profile({{0.00, -0.02},
                                        {0.20, -0.02},
                                        {0.60, -0.06},
                                        {0.90, -0.10},
                                        {1.00, -0.07},
                                        {0.99, 0.03},
                                        {0.86, 0.24},
                                        {0.62, 0.42},
                                        {0.32, 0.52},
                                        {0.00, 0.55}});
  const Surface round = revolve(profile);
  return paint_color(width, height, [&](double u, double v) {
    const Point3 p = round(u, v);
    const double gill = 0.5 + 0.5 * std::sin(u * 2.0 * kPi * 60.0);
    if (v < 0.42) return mix(swatch(0xC9B48E), swatch(0xF0E4CA), gill);
    const Point3 d = glm::normalize(p + Point3(0.0, 0.01, 0.0));
    const Vec3 red = mix(swatch(0xA81E16), swatch(0xD9481E), smoothstep(0.1, 0.5, p.y + 0.15 * fbm(p * 3.0, 3)));
    return mix(red, swatch(0xF2E8D0), smoothstep(0.34, 0.28, cells(d * 4.2).nearest));
  });
}

Mesh grass_mesh(int blades, std::uint64_t seed) {
  Random random(seed);
  const Point2 spots[] = {{-2.1, -0.6}, {2.2, -1.2}, {-1.6, 1.5}, {2.3, 1.0}, {-2.8, 0.6}, {0.9, -1.9}};
  Mesh grass;
  for (int i = 0; i < blades; ++i) {
    const Point2 spot = spots[i % 6];
    const double turn = random.range(0.0, 2.0 * kPi);
    const double away = 0.55 * std::sqrt(random.next());
    const double height = random.range(0.35, 0.95);
    const double droop = random.range(0.15, 0.55);
    const double x = spot.x + away * std::cos(turn);
    const double z = spot.y + away * std::sin(turn);
    const double y = ground_height(x, z) - 0.03;
    const Point3 way{std::cos(turn * 3.0), 0.0, std::sin(turn * 3.0)};
    const Point3 side{-way.z, 0.0, way.x};
    const Surface blade = [=](double u, double v) {
      const Point3 spine =
          Point3(x, y, z) + Point3(0.0, height * (v - 0.25 * droop * v * v), 0.0) + way * (droop * height * v * v);
      const double width = 0.035 * (1.0 - std::pow(v, 2.2)) + 0.001;
      return spine + side * ((u - 0.5) * width) + way * (0.01 * std::abs(u - 0.5));
    };
    append(grass, tessellate(blade, 2, 7));
  }
  for (Vec2& uv : grass.uvs) uv.x = 0.5F;
  return grass;
}

Mesh fern_mesh(const Point3& foot, double height, double way) {
  std::vector<Point4> knots;
  for (int i = 0; i <= 5; ++i) {
    const double t = i / 5.0;
    knots.emplace_back(foot.x + way * 0.18 * height * t * t, foot.y + height * t * 0.8, foot.z, 0.05 * (1.0 - 0.4 * t));
  }
  const Point3 top(knots.back());
  for (int i = 1; i <= 14; ++i) {  // the crozier: a spiral that closes
    const double turn = 0.52 * i;
    const double radius = 0.20 * height * std::pow(0.86, i);
    const Point2 hub{way * 0.20 * height, 0.02 * height};
    knots.emplace_back(top.x + hub.x - way * radius * std::cos(turn), top.y + hub.y + radius * std::sin(turn), top.z,
                       0.032 * (1.0 - 0.04 * i));
  }
  return tessellate(sweep(Curve(knots), {0.0, 0.0, 1.0}), 10, 90);
}

Mesh staff_mesh() {
  std::vector<Point4> knots{{1.28, -0.02, 0.78, 0.070}, {1.22, 0.80, 0.86, 0.062}, {1.19, 1.60, 0.82, 0.066},
                            {1.17, 2.30, 0.84, 0.060},  {1.20, 3.00, 0.80, 0.058}, {1.13, 3.55, 0.78, 0.056},
                            {1.16, 3.95, 0.76, 0.054}};
  for (int i = 1; i <= 13; ++i) {
    const double turn = 0.50 * i;
    const double radius = 0.36 * std::pow(0.90, i);
    knots.emplace_back(1.50 - radius * std::cos(turn), 4.02 + radius * std::sin(turn), 0.75, 0.052 - 0.0025 * i);
  }
  const Section gnarled = [](double angle, double t) {
    const double bump = 1.0 + 0.22 * noise({std::cos(angle) * 1.2, std::sin(angle) * 1.2, t * 22.0}) +
                        0.10 * noise({std::cos(angle) * 3.0, std::sin(angle) * 3.0, t * 60.0});
    return Point2(bump * std::cos(angle), bump * std::sin(angle));
  };
  Mesh staff = tessellate(sweep(Curve(knots), {0.0, 0.0, 1.0}, gnarled), 14, 140);
  scale_uvs(staff, {0.25F, 3.0F});
  for (Vec2& uv : staff.uvs) uv = {uv.y, uv.x};  // the grain runs along
  return staff;
}

}  // namespace luminist
