#include <cmath>

#include "make_scene/curve.h"
#include "make_scene/imp.h"
#include "make_scene/noise.h"
#include "make_scene/painting.h"

namespace luminist {
namespace {

/// Outer ends of a wing's three fingers, and where they leave the wrist; right-hand side.
constexpr double kWingTips[3][3] = {{2.35, 3.45, -1.15}, {2.30, 2.45, -1.30}, {1.55, 1.75, -1.10}};
const Point3 kWingRoot{0.20, 2.25, -0.30};
const Point3 kWingWrist{1.05, 3.15, -0.85};
const Point3 kWingHeel{0.22, 1.75, -0.42};  // where the skin meets the back

Point3 mirrored(const Point3& p, int side) {
  return {p.x * side, p.y, p.z};
}

Curve bone(const Point3& from, const Point3& to, double bend, double radius_from, double radius_to, int side) {
  const Point3 middle = 0.5 * (from + to) + Point3(0.0, bend, -0.06);
  const Point3 a = mirrored(from, side);
  const Point3 m = mirrored(middle, side);
  const Point3 b = mirrored(to, side);
  return Curve(
      {{a.x, a.y, a.z, radius_from}, {m.x, m.y, m.z, 0.5 * (radius_from + radius_to)}, {b.x, b.y, b.z, radius_to}});
}

/// The spokes that span the skin, from the top finger to the back, side to be mirrored.
Curve spoke(int index, int side) {
  if (index < 3) {
    const Point3 tip{kWingTips[index][0], kWingTips[index][1], kWingTips[index][2]};
    return bone(kWingWrist, tip, 0.10 - 0.03 * index, 0.045, 0.012, side);
  }
  return bone(kWingRoot, kWingHeel, 0.0, 0.03, 0.03, side);
}

}  // namespace

Mesh eye_mesh() {
  const Surface ball = [](double u, double v) {
    const double around = 2.0 * kPi * u;
    const double down = kPi * v;  // v = 0 is the back of the eye
    const double cornea = 1.0 + 0.05 * smoothstep(0.80, 0.95, v);
    return kEyeRadius * cornea *
           Point3(std::sin(down) * std::cos(around), std::sin(down) * std::sin(around), -std::cos(down));
  };
  return tessellate(ball, 40, 32);
}

Image eye_painting(int width, int height) {
  return paint_color(width, height, [](double u, double v) {
    const double away = (1.0 - v) * kPi;  // angle from the pupil's middle
    const double fibre = 0.5 + 0.5 * noise({std::cos(2.0 * kPi * u) * 9.0, std::sin(2.0 * kPi * u) * 9.0, away * 3.0});
    Vec3 iris = mix(swatch(0xF0B23A), swatch(0xB4571C), smoothstep(0.30, 0.62, away + 0.22 * fibre));
    iris = mix(iris, swatch(0x2A1208), smoothstep(0.58, 0.68, away));
    const double slit_x = std::abs(std::cos(2.0 * kPi * u)) * away;
    const double slit_y = std::abs(std::sin(2.0 * kPi * u)) * away;
    const double pupil = std::hypot(slit_x / 0.24, slit_y / 0.40);
    iris = mix(swatch(0x050303), iris, smoothstep(0.90, 1.06, pupil));
    const Vec3 white = mix(swatch(0xEFE6D2), swatch(0xC98F6A), smoothstep(0.9, 1.5, away));
    return mix(iris, white, smoothstep(0.68, 0.74, away));
  });
}

Mesh horn_mesh(int side) {
  const double s = side;
  const double lean = 0.05;  // the head's tilt lifts one horn
  const Curve path({{0.30 * s, 3.60 - lean * s, 0.00, 0.200},
                    {0.42 * s, 3.92 - lean * s, -0.08, 0.160},
                    {0.66 * s, 4.24 - lean * s, -0.26, 0.120},
                    {0.84 * s, 4.52 - lean * s, -0.30, 0.080},
                    {0.84 * s, 4.78 - lean * s, -0.18, 0.040},
                    {0.79 * s, 4.90 - lean * s, -0.08, 0.004}});
  const Section ringed = [](double angle, double t) {
    const double ring = 1.0 + 0.07 * std::pow(std::abs(std::sin(t * 34.0)), 0.6) * (1.0 - t);
    return Point2(ring * std::cos(angle), ring * std::sin(angle));
  };
  return tessellate(sweep(path, {0.0, 0.0, 1.0}, ringed), 18, 80);
}

Image horn_painting(int width, int height) {
  return paint_color(width, height, [](double u, double v) {
    const double grain = 0.5 + 0.8 * fbm({u * 8.0, v * 26.0, 2.0}, 3);
    Vec3 color = mix(swatch(0x4A3426), swatch(0xCDB48A), smoothstep(0.05, 0.75, v + 0.10 * grain));
    color = mix(color, swatch(0x2C2019), 0.55 * smoothstep(0.45, 0.1, std::abs(std::sin(v * 34.0))));
    return mix(color, swatch(0x3A2A20), 0.8 * smoothstep(0.90, 1.0, v));
  });
}

Mesh tail_mesh() {
  const Curve path({{0.02, 1.12, -0.38, 0.250},
                    {0.06, 0.86, -0.72, 0.175},
                    {0.34, 0.48, -1.02, 0.130},
                    {0.86, 0.26, -1.10, 0.105},
                    {1.42, 0.36, -0.86, 0.085},
                    {1.72, 0.76, -0.66, 0.070},
                    {1.66, 1.18, -0.58, 0.058},
                    {1.40, 1.34, -0.56, 0.050},
                    {1.22, 1.20, -0.52, 0.044},
                    {1.26, 1.02, -0.46, 0.040},
                    {1.38, 0.90, -0.38, 0.075},
                    {1.62, 0.78, -0.26, 0.003}});
  const Section leaf = [](double angle, double t) {
    const double blade = smoothstep(0.90, 0.955, t) * (1.0 - smoothstep(0.97, 1.0, t));
    const double fin = 1.0 + 0.35 * std::pow(std::abs(std::sin(t * 60.0)), 1.5) * (std::cos(angle) > 0.9 ? 1.0 : 0.0) *
                                 smoothstep(0.8, 0.6, t);
    return Point2(std::cos(angle) * fin * (1.0 + 2.6 * blade), std::sin(angle) * (1.0 - 0.35 * blade));
  };
  Mesh mesh = tessellate(sweep(path, {0.0, 1.0, 0.0}, leaf), 22, 130);
  for (Vec2& uv : mesh.uvs) {  // on the skin's ramp: dark above, paler below
    uv = {static_cast<float>(0.14 + 0.16 * (1.0 - std::cos(2.0 * kPi * uv.x))), 0.04F};
  }
  return mesh;
}

Mesh wing_bones(int side) {
  Mesh bones = tessellate(sweep(bone(kWingRoot, kWingWrist, 0.16, 0.105, 0.055, side)), 14, 24);
  for (int i = 0; i < 3; ++i) append(bones, tessellate(sweep(spoke(i, side)), 12, 24));
  const Point3 claw = kWingWrist + Point3(0.02, 0.24, 0.10);
  append(bones, tessellate(sweep(bone(kWingWrist, claw, 0.02, 0.05, 0.004, side)), 10, 10));
  for (Vec2& uv : bones.uvs) uv = {0.22F, 0.05F};
  return bones;
}

Mesh wing_skin(int side) {
  Mesh skin;
  for (int i = 0; i < 3; ++i) {
    const Curve upper = spoke(i, side);
    const Curve lower = spoke(i + 1, side);
    const Surface span = [=](double u, double v) {
      const double reach = v * (1.0 - 0.20 * std::sin(kPi * u) * v);  // the edge hangs in a curve between two tips
      const Point3 a(upper.at(reach));
      const Point3 b(lower.at(reach));
      const Point3 sag{0.0, -0.05 * std::sin(kPi * u) * v, 0.10 * std::sin(kPi * u) * std::sin(kPi * 0.5 * v)};
      return a * (1.0 - u) + b * u + sag;
    };
    Mesh part = tessellate(span, 18, 24);
    for (Vec2& uv : part.uvs) uv.x = (uv.x + static_cast<float>(i)) / 3.0F;
    append(skin, part);
  }
  return skin;
}

Image wing_painting(int width, int height) {
  return paint_color(width, height, [](double u, double v) {
    const double finger = std::abs(std::remainder(u * 3.0, 1.0));
    const double vein = std::abs(noise({u * 14.0 + 0.8 * noise({u * 6.0, v * 6.0, 1.0}), v * 5.0, 3.0}));
    Vec3 color =
        mix(swatch(0x8E3B2E), swatch(0xD98A4E), smoothstep(0.1, 1.0, v + 0.25 * noise({u * 5.0, v * 5.0, 0.0})));
    color = mix(color, swatch(0x5A2420), 0.6 * smoothstep(0.10, 0.02, vein));
    return mix(color, swatch(0x3C2A28), 0.7 * smoothstep(0.10, 0.0, finger));
  });
}

}  // namespace luminist
