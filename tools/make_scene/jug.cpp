#include "make_scene/jug.h"

#include <cmath>

#include "make_scene/curve.h"
#include "make_scene/jug_ornament.h"
#include "make_scene/noise.h"
#include "make_scene/painting.h"

namespace luminist {
namespace {

// Rows of the texture: the outside of the body, the handle, the inside.
constexpr double kBodyEnd = 0.86;
constexpr double kHandleStart = 0.88;
constexpr double kHandleEnd = 0.95;
constexpr double kInsideStart = 0.97;
constexpr std::size_t kRim = 17;  // control point of the profile at the edge of the lip
constexpr double kSpoutAngle = 0.5 * kPi;

Curve body_profile() {
  return Curve::profile({{0.000, 0.004},  {0.030, 0.004},  {0.050, 0.003},   {0.0575, 0.000},  {0.0615, 0.003},
                         {0.0610, 0.009}, {0.0575, 0.016}, {0.0605, 0.027},  {0.080, 0.056},   {0.0985, 0.095},
                         {0.1050, 0.132}, {0.0985, 0.167}, {0.0790, 0.199},  {0.0585, 0.225},  {0.0485, 0.249},
                         {0.0475, 0.270}, {0.0540, 0.292}, {0.0610, 0.3085}, {0.0590, 0.3105}, {0.0560, 0.3070},
                         {0.0500, 0.292}, {0.0435, 0.270}, {0.0440, 0.249},  {0.0540, 0.225},  {0.0920, 0.167},
                         {0.0985, 0.132}, {0.0720, 0.056}, {0.040, 0.022},   {0.000, 0.018}});
}

double angle_from_spout(double angle) {
  return std::remainder(angle - kSpoutAngle, 2.0 * kPi);
}

/// The lip is pinched into a spout: drawn out and up in front, drawn in at its sides.
Surface body_surface() {
  return [profile = body_profile()](double u, double v) {
    const Point4 p = profile.at(v);
    const double angle = 2.0 * kPi * u;
    const double away = angle_from_spout(angle);
    const double height = std::pow(smoothstep(0.235, 0.325, p.y), 1.4);
    const double front = std::exp(-std::pow(away / 0.40, 2.0));
    const double side = std::exp(-std::pow((std::abs(away) - 0.85) / 0.38, 2.0));
    const double rings = 0.00012 * std::sin(p.y * 640.0 + 2.0 * std::sin(p.y * 77.0)) * smoothstep(0.02, 0.04, p.x);
    const double radius = std::max(p.x, 0.0) + rings + height * (0.037 * front - 0.019 * side);
    const double y = p.y + height * (0.019 * front - 0.008 * side);
    return Point3(radius * std::sin(angle), y, radius * std::cos(angle));
  };
}

/// The part [from, to] of a surface's v.
Surface part(const Surface& surface, double from, double to) {
  return [=](double u, double v) { return surface(u, from + (to - from) * v); };
}

void map_rows(Mesh& mesh, double from, double to) {
  for (Vec2& uv : mesh.uvs) uv.y = static_cast<float>(mix(from, to, uv.y));
}

/// A strap that leaves the neck, swings out and lands on the belly, wider where it is pressed on.
Surface handle_surface() {
  const Curve path({{-0.0440, 0.2790, 0.0, 0.0150},
                    {-0.0640, 0.2900, 0.0, 0.0124},
                    {-0.0930, 0.2880, 0.0, 0.0112},
                    {-0.1200, 0.2640, 0.0, 0.0108},
                    {-0.1300, 0.2290, 0.0, 0.0108},
                    {-0.1230, 0.1950, 0.0, 0.0112},
                    {-0.1060, 0.1690, 0.0, 0.0124},
                    {-0.0920, 0.1560, 0.0, 0.0165},
                    {-0.0860, 0.1490, 0.0, 0.0200}});
  const Section strap = [](double angle, double t) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double groove =
        0.16 * std::exp(-std::pow(s / 0.34, 2.0)) * (c > 0.0 ? 1.0 : 0.0) * c * c * smoothstep(0.0, 0.15, t);
    return Point2(0.62 * c - groove, 1.42 * std::copysign(std::pow(std::abs(s), 0.9), s));
  };
  return sweep(path, {0.0, 1.0, 0.0}, strap);
}

Vec3 handle_color(double along, double around) {
  const Vec3 glaze = ornament_glaze({around * 0.05, along * 0.25});
  const double wobble = 0.02 * noise({along * 30.0, around * 4.0, 3.0});
  const double stroke = smoothstep(0.30, 0.22, std::abs(std::fmod(along * 9.0 + wobble * 8.0, 1.0) - 0.5));
  const double on_back = smoothstep(0.21, 0.17, std::abs(std::remainder(around, 1.0)));
  return mix(glaze, ornament_cobalt(),
             0.88 * stroke * on_back * smoothstep(0.06, 0.12, along) * smoothstep(0.93, 0.86, along));
}

}  // namespace

Mesh jug_mesh() {
  const double rim = body_profile().fraction_at_point(kRim);
  const Surface body = body_surface();
  Mesh jug = tessellate(part(body, 0.0, rim), 112, 104);
  map_rows(jug, 0.0, kBodyEnd);
  const Surface inner = [inside = part(body, rim, 1.0)](double u, double v) {
    return inside(u, v * v);
  };  // dense at the lip
  Mesh inside = tessellate(inner, 112, 40);
  map_rows(inside, kInsideStart, 1.0);
  append(jug, inside);
  Mesh handle = tessellate(handle_surface(), 28, 72);
  for (Vec2& uv : handle.uvs) uv = {uv.y, static_cast<float>(mix(kHandleStart, kHandleEnd, uv.x))};
  append(jug, handle);
  return jug;
}

Image jug_painting(int width, int height) {
  const Curve profile = body_profile();
  const double rim = profile.fraction_at_point(kRim);
  return paint_color(width, height, [&](double u, double v) {
    if (v >= kInsideStart - 0.01) return ornament_glaze({u * 0.6, v});
    if (v >= kHandleStart - 0.01)
      return handle_color(u, std::clamp((v - kHandleStart) / (kHandleEnd - kHandleStart), 0.0, 1.0));
    const Point4 p = profile.at(std::min(v / kBodyEnd, 1.0) * rim);
    return ornament_color(2.0 * kPi * u, p.y, std::max(p.x, 0.03));
  });
}

}  // namespace luminist
