#include "make_scene/vessel.h"

#include <cmath>

#include "make_scene/curve.h"
#include "make_scene/noise.h"
#include "make_scene/painting.h"

namespace luminist {
namespace {

Curve bowl_profile() {
  return Curve::profile({{0.000, 0.0060},  {0.0250, 0.0060}, {0.0330, 0.0040}, {0.0350, 0.0000}, {0.0390, 0.0005},
                         {0.0400, 0.0050}, {0.0400, 0.0100}, {0.0500, 0.0150}, {0.0680, 0.0260}, {0.0830, 0.0440},
                         {0.0910, 0.0620}, {0.0950, 0.0705}, {0.0948, 0.0722}, {0.0925, 0.0718}, {0.0880, 0.0630},
                         {0.0790, 0.0450}, {0.0640, 0.0290}, {0.0450, 0.0180}, {0.0200, 0.0130}, {0.0000, 0.0125}});
}

}  // namespace

Mesh bowl_mesh() {
  return tessellate(revolve(bowl_profile()), 80, 60);
}

double bowl_floor(double distance) {
  const Curve profile = bowl_profile();
  const double start = profile.fraction_at_point(13);  // where the inside begins
  double nearest = 1e9;
  double height = 0.0;
  for (int i = 0; i <= 200; ++i) {
    const Point4 p = profile.at(mix(start, 1.0, i / 200.0));
    if (std::abs(p.x - distance) < nearest) nearest = std::abs(p.x - distance), height = p.y;
  }
  return height;
}

Image bowl_painting(int width, int height) {
  const Curve profile = bowl_profile();
  return paint_color(width, height, [&](double u, double v) {
    const Point4 p = profile.at(v);
    const double around = 2.0 * kPi * u;
    const Point3 q{std::cos(around) * 2.0, std::sin(around) * 2.0, p.y * 45.0};
    const double cloud = 0.5 + 0.9 * fbm(q, 4);
    Vec3 color = mix(swatch(0x4E8078), swatch(0x76A393), std::clamp(cloud, 0.0, 1.0));
    color = mix(color, swatch(0x2F5E5C), 0.6 * smoothstep(0.030, 0.012, p.y + 0.006 * noise(q * 2.0)));
    const double lip = smoothstep(0.0690, 0.0715, p.y + 0.0016 * noise(q * 3.0));
    color = mix(color, swatch(0x7A4E2A), 0.85 * lip);
    const double foot = smoothstep(0.0085, 0.0055, p.y + 0.0012 * noise(q * 4.0)) * smoothstep(0.028, 0.034, p.x);
    color = mix(color, swatch(0x9A6E4A), foot);
    return mix(color, swatch(0x28403C), 0.5 * smoothstep(0.16, 0.06, cells(q * Point3(5.0, 5.0, 2.0)).nearest));
  });
}

}  // namespace luminist
