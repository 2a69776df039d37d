#include <algorithm>
#include <cmath>

#include "make_scene/head.h"
#include "make_scene/noise.h"

namespace luminist {
namespace {

/// Rounded strands side by side: 1 on a strand's back, 0 in the furrow between two.
double strand(double phase) {
  const double s = std::sin(phase);
  return std::pow(s * s + 0.03, 0.30);
}

/// Height of the strands over the hair's mass: they run from the brow to the knot and wave on their way.
double strands(const Point3& p) {
  const Point3 q = p - Point3(0.0, 2.6, 0.0);
  const double around = std::atan2(q.x, q.y);
  const double along = q.z;
  const double aside = smoothstep(0.0, 0.55, std::abs(around));  // straight at the parting
  const double wave = aside * (0.30 * std::sin(along * 0.85 + 2.2 * std::abs(around)) + 0.35 * noise(p * 0.22));
  const double coarse = strand(around * 7.0 + wave * 2.2);
  const double middle = strand(around * 17.0 + wave * 5.0 + 1.5 * aside * noise(p * 0.35 + Point3(5.0)));
  const double fine = strand(around * 25.0 + wave * 7.5 + 2.0 * aside * noise(p * 0.5 + Point3(11.0)));
  return 0.65 * coarse + 0.27 * middle + 0.08 * fine;
}

double knot_distance(const Point3& p) {
  const Point3 q = p - Point3(0.0, 1.6, -12.0);
  const double around = std::atan2(q.x, q.y);
  const double away = std::hypot(q.x, q.y);
  const double coil = strand(2.0 * around + away * 2.6 + q.z * 0.6) * 0.5 + 0.2 * strand(5.0 * around + away * 6.5);
  return ellipsoid_distance(q, Point3(0.0), {3.4, 3.1, 2.5}) - 0.42 * coil;
}

}  // namespace

double hair_distance(const Point3& p) {
  const Point3 fold{std::sqrt(p.x * p.x + 0.05), p.y, p.z};
  const double mass = ellipsoid_distance(fold, {0.0, 3.5, -1.6}, {7.75, 8.75, 9.7});
  if (mass > 3.0 && p.z > -8.0) return mass - 1.0;  // too far for the strands to matter
  const double relief = strands(fold);
  double d = mass - 0.15 - 0.95 * relief;
  // The hairline: over the brow, down the temples, behind the ears to the nape.
  const double front = 0.83 * p.z - 0.55 * p.y - 2.05 - 0.35 * std::cos(fold.x * 1.1) - 0.45 * relief;
  d = smooth_intersection(d, front, 1.1);
  d = smooth_difference(d, ellipsoid_distance(fold, {8.6, -2.0, -0.6}, {2.6, 2.9, 1.9}), 0.9);  // free of the ears
  return smooth_union(d, knot_distance(p), 0.7);
}

}  // namespace luminist
