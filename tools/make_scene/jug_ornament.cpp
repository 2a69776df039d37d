#include "make_scene/jug_ornament.h"

#include <algorithm>
#include <cmath>

#include "make_scene/noise.h"

namespace luminist {
namespace {

constexpr double kBelly = 0.128;       // height of the frieze's middle
constexpr double kMeanRadius = 0.100;  // motifs on the belly are drawn at this radius
constexpr int kFlowers = 6;
constexpr double kEdge = 0.0005;  // softness of a brush stroke's edge

/// 1 inside a shape of which the signed distance is given.
double ink(double distance, double edge = kEdge) {
  return smoothstep(edge, -edge, distance);
}

/// Signed distance to a line of some width along a height.
double band(double y, double center, double width) {
  return std::abs(y - center) - 0.5 * width;
}

/// A leaf from `a` to `b`: the lens between two circles.
double leaf(const Point2& p, const Point2& a, const Point2& b, double width) {
  const Point2 middle = 0.5 * (a + b);
  const double half = 0.5 * glm::length(b - a);
  const Point2 axis = (b - a) / (2.0 * half);
  const Point2 d = p - middle;
  const Point2 q{std::abs(glm::dot(d, axis)), std::abs(d.x * axis.y - d.y * axis.x)};
  const double h = 0.5 * width;
  const double offset = (half * half - h * h) / (2.0 * h);
  return glm::length(q + Point2(0.0, offset)) - (offset + h);
}

struct Paint {
  Vec3 color;
  double load = 0.0;  ///< how much pigment the brush leaves, before the glaze shows through
};

/// Pigment pools towards the end of strokes and thins over the middle.
void lay(Vec3& ground, const Paint& paint, double coverage, double pooling) {
  ground = mix(ground, paint.color, std::clamp(coverage * paint.load * pooling, 0.0, 1.0));
}

/// A flower of eight petals about the origin: wash, outline, veins, an ochre heart.
void flower(Vec3& color, const Point2& p, double size, double pooling) {
  const double r = glm::length(p);
  const double angle = std::atan2(p.y, p.x);
  const double petal = std::abs(std::cos(4.0 * angle));
  const double edge = size * (0.62 + 0.38 * std::pow(petal, 0.55));
  const Paint wash{swatch(0x6C8CC8), 0.80};
  const Paint line{ornament_cobalt(), 0.93};
  const Paint ochre{swatch(0xC98A22), 0.95};
  lay(color, wash, ink(r - edge), pooling);
  lay(color, line, ink(std::abs(r - edge) - 0.0007), pooling);
  const double vein = std::abs(std::remainder(angle, 0.25 * kPi)) * r;
  lay(color, line, ink(vein - 0.0006 * smoothstep(size * 0.85, size * 0.4, r)) * ink(r - size * 0.82), pooling);
  const double inner = size * (0.36 + 0.07 * std::cos(8.0 * angle + kPi));
  lay(color, line, ink(r - inner), pooling);
  lay(color, ochre, ink(r - size * 0.27), 1.0);
  lay(color, line, ink(r - size * 0.08), 1.0);
}

/// One repeat of the frieze; x in [-half, half] around a flower, y from the frieze's middle.
void frieze(Vec3& color, Point2 p, double half, double pooling) {
  const Paint line{ornament_cobalt(), 0.93};
  const Paint green{swatch(0x54784A), 0.85};
  const Point2 q{std::abs(p.x), p.y};
  const double vine_y = 0.012 * std::sin(kPi * p.x / half);
  const double vine = std::abs(p.y - vine_y) - 0.0008;
  if (q.x > 0.020) lay(color, line, ink(vine), pooling);
  const double turn = p.x > 0.0 ? 1.0 : -1.0;
  const Point2 s{q.x, p.y * turn};  // the vine has half-turn symmetry about the flower
  const double leaves[] = {
      leaf(s, {0.027, 0.011}, {0.035, 0.031}, 0.0095), leaf(s, {0.034, 0.010}, {0.049, 0.024}, 0.0085),
      leaf(s, {0.030, 0.010}, {0.040, -0.008}, 0.0080), leaf(s, {0.040, 0.006}, {0.052, -0.020}, 0.0095)};
  for (const double d : leaves) {
    lay(color, green, ink(d), pooling);
    lay(color, line, ink(std::abs(d) - 0.0004), pooling * 0.8);
  }
  flower(color, p, 0.0245, pooling);
  for (const double y : {0.0305, -0.0305}) {
    for (const double x : {0.0, 0.0065, 0.0125}) {
      const double size = 0.0018 - 0.0005 * x / 0.0125;
      lay(color, line, ink(glm::length(Point2(q.x - x, p.y - y + (y > 0.0 ? 1.0 : -1.0) * x * x * 18.0)) - size),
          pooling);
    }
  }
}

/// Straight bands, the scallops under the shoulder and the row of leaves on the neck.
void borders(Vec3& color, double angle, double y, double radius, double pooling) {
  const Paint line{ornament_cobalt(), 0.93};
  const Paint ochre{swatch(0xC98A22), 0.92};
  for (const double center : {0.0220, 0.0845, 0.1710, 0.2335}) lay(color, line, ink(band(y, center, 0.0030)), pooling);
  for (const double center : {0.0805, 0.1750, 0.2380, 0.2585}) lay(color, line, ink(band(y, center, 0.0009)), pooling);
  lay(color, ochre, ink(band(y, 0.0885, 0.0022)), pooling);
  lay(color, ochre, ink(band(y, 0.1668, 0.0022)), pooling);
  lay(color, line, ink(band(y, 0.3085, 0.0085)), pooling);
  lay(color, ochre, ink(band(y, 0.2960, 0.0020)), pooling);

  const double scallop = std::remainder(angle, 2.0 * kPi / 24.0) * radius;  // hangs from the shoulder's band
  const double arch = glm::length(Point2(scallop, (y - 0.1790) * 0.8)) - 0.0088;
  if (y > 0.1765 && y < 0.20) {
    lay(color, {swatch(0x6C8CC8), 0.7}, ink(arch), pooling);
    lay(color, line, ink(std::abs(arch) - 0.0007), pooling);
  }
  const double step = 2.0 * kPi / 18.0;
  const double x = std::remainder(angle, step) * radius;
  const double tips[] = {leaf({x, y}, {0.0, 0.2040}, {0.0, 0.2300}, 0.0085)};
  for (const double d : tips) lay(color, line, ink(d), pooling);
  const double between = std::remainder(angle + 0.5 * step, step) * radius;
  lay(color, ochre, ink(glm::length(Point2(between, y - 0.2230)) - 0.0021), pooling);
  const double dart = std::remainder(angle, 2.0 * kPi / 20.0) * std::max(radius, 0.06);
  const double flame = leaf({dart, y}, {0.0, 0.0260}, {0.0, 0.0760}, 0.0150);
  lay(color, {swatch(0x6C8CC8), 0.75}, ink(flame), pooling);
  lay(color, line, ink(std::abs(flame) - 0.0007), pooling);
  lay(color, line, ink(leaf({dart, y}, {0.0, 0.0360}, {0.0, 0.0660}, 0.0040)), pooling);
  const double neck = std::remainder(angle + 5.0 * (y - 0.2480), 2.0 * kPi / 14.0) * radius;
  if (y > 0.2405 && y < 0.2565) lay(color, line, ink(std::abs(neck) - 0.0024), pooling);
}

}  // namespace

Vec3 ornament_cobalt() {
  return swatch(0x22398A);
}

Vec3 ornament_glaze(const Point2& place) {
  const double cloud = fbm({place.x * 22.0, place.y * 22.0, 5.0}, 3);
  const double speck = cells({place.x * 260.0, place.y * 260.0, 1.5}).nearest;
  const Vec3 cream = mix(swatch(0xEFE5CC), swatch(0xE2D2AE), std::clamp(0.45 + 0.9 * cloud, 0.0, 1.0));
  return mix(cream, swatch(0x9C8560), 0.35 * smoothstep(0.16, 0.07, speck));
}

Vec3 ornament_color(double angle, double height, double radius) {
  const Point3 round{std::sin(angle) * radius, height, std::cos(angle) * radius};
  const double sway_x = 0.0011 * noise(round * 55.0) + 0.0004 * noise(round * 170.0);
  const double sway_y = 0.0010 * noise(round * 48.0 + Point3(9.0)) + 0.0004 * noise(round * 150.0 + Point3(4.0));
  const double pooling = 0.88 + 0.30 * noise(round * 130.0) + 0.22 * noise(round * 38.0);
  Vec3 color = ornament_glaze({angle * kMeanRadius, height});
  const double y = height + sway_y;
  const double turned = angle + sway_x / radius;
  borders(color, turned, y, radius, pooling);
  if (std::abs(y - kBelly) < 0.0375) {
    const double step = 2.0 * kPi / kFlowers;
    const double x = std::remainder(turned, step) * kMeanRadius;
    frieze(color, {x, y - kBelly}, 0.5 * step * kMeanRadius, pooling);
  }
  return color;
}

}  // namespace luminist
