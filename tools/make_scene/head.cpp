#include "make_scene/head.h"

#include <algorithm>
#include <cmath>

#include "make_scene/chain.h"

namespace luminist {
namespace {

/// Cranium, forehead, jaw, cheeks: the big planes.
double skull_distance(const Point3& p) {
  double d = ellipsoid_distance(p, {0.0, 3.3, -1.3}, {7.3, 8.2, 9.2});
  d = smooth_union(d, ellipsoid_distance(p, {0.0, 3.8, 3.0}, {5.9, 5.4, 5.55}), 2.0);
  d = smooth_union(d, ellipsoid_distance(p, {0.0, -4.2, 2.6}, {5.35, 7.2, 5.7}), 2.6);
  const Knot jaw[] = {{{4.55, -5.8, 0.6}, 1.0}, {{3.45, -8.4, 3.9}, 1.1}, {{1.1, -10.0, 6.9}, 1.2}};
  d = smooth_union(d, chain_distance(p, jaw, 0.8), 2.4);
  d = smooth_union(d, ellipsoid_distance(p, {0.0, -10.0, 7.25}, {1.75, 1.35, 1.6}), 1.5);
  d = smooth_union(d, ellipsoid_distance(p, {3.95, -2.2, 5.2}, {1.9, 1.5, 1.8}), 2.2);
  d = smooth_union(d, ellipsoid_distance(p, {3.2, -5.2, 4.9}, {2.2, 2.9, 2.3}), 2.2);
  const Knot arch[] = {{{4.9, -1.8, 4.5}, 0.7}, {{6.3, -1.3, 0.4}, 0.5}};
  d = smooth_union(d, chain_distance(p, arch, 0.5), 1.6);
  return smooth_difference(d, ellipsoid_distance(p, {7.9, 2.6, 4.6}, {1.6, 2.4, 2.4}), 1.6);  // temples
}

/// An almond in the plane of the face: where two discs overlap, its corners at x = 1.75 and 4.55.
double almond_distance(double x, double y) {
  const double tilt = 0.07;  // outer corners a little higher
  const double dx = x - 3.15;
  const double u = dx * std::cos(tilt) + (y + 0.02) * std::sin(tilt);
  const double v = (y + 0.02) * std::cos(tilt) - dx * std::sin(tilt);
  const double upper = std::hypot(u + 0.12, v + 1.56) - 2.10;  // the upper lid's arch peaks towards the nose
  const double lower = std::hypot(u - 0.12, v - 1.68) - 2.20;
  return std::max(upper, lower);
}

/// The eyeball between its lids; the iris is a dish with a drilled pupil, as sculptors cut it.
double eye_distance(const Point3& p) {
  const Point3 center{3.15, 0.0, 6.30};
  const double ball = sphere_distance(p, center, 1.24);
  const double opening = almond_distance(p.x, p.y);
  double lids = sphere_distance(p, center, 1.48);
  lids = smooth_difference(lids, std::max(opening, 6.5 - p.z), 0.20);
  const double crease = std::abs(opening - 0.48) - 0.05;
  lids = smooth_difference(lids, std::max({crease, sphere_distance(p, center, 1.9), 0.1 - p.y}), 0.26);
  const Point3 gaze = glm::normalize(Point3(0.0, 0.10, 1.0));
  const double iris = smooth_difference(ball, sphere_distance(p, center + gaze * 1.66, 0.70), 0.12);
  return smooth_union(lids, smooth_difference(iris, sphere_distance(p, center + gaze * 1.05, 0.22), 0.12), 0.12);
}

double orbit_distance(double d, const Point3& p) {
  const Point3 q = rotated_z(p - Point3(3.25, 0.05, 8.75), 0.10);
  d = smooth_difference(d, ellipsoid_distance(q, Point3(0.0), {2.25, 1.35, 1.95}), 1.3);
  const Knot brow[] = {
      {{1.3, 1.75, 7.95}, 0.55}, {{3.0, 2.25, 7.65}, 0.55}, {{4.6, 1.95, 6.4}, 0.38}, {{5.4, 0.8, 5.0}, 0.20}};
  d = smooth_union(d, chain_distance(p, brow, 0.6), 1.4);
  return smooth_union(d, eye_distance(p), 0.22);
}

double nose_distance(double d, const Point3& p) {
  const Knot bridge[] = {
      {{0.0, 1.8, 8.05}, 0.75}, {{0.0, 0.3, 8.40}, 0.60}, {{0.0, -1.6, 9.30}, 0.62}, {{0.0, -3.0, 9.95}, 0.72}};
  const Knot side[] = {{{0.75, -0.2, 7.4}, 0.55}, {{1.15, -3.0, 8.5}, 0.85}};
  double nose = chain_distance(p, bridge, 0.5);
  nose = smooth_union(nose, chain_distance(p, side, 0.5), 0.9);
  nose = smooth_union(nose, sphere_distance(p, {0.0, -3.50, 10.08}, 0.82), 0.7);
  nose = smooth_union(nose, ellipsoid_distance(p, {1.10, -3.92, 9.20}, {0.66, 0.60, 0.86}), 0.50);
  const Knot columella[] = {{{0.0, -4.0, 9.9}, 0.42}, {{0.0, -4.65, 9.0}, 0.45}};
  nose = smooth_union(nose, chain_distance(p, columella, 0.3), 0.5);
  d = smooth_union(d, nose, 0.75);
  return smooth_difference(
      d, ellipsoid_distance(rotated_y(p - Point3(0.66, -4.62, 9.55), 0.35), Point3(0.0), {0.32, 0.42, 0.66}), 0.22);
}

double mouth_distance(double d, const Point3& p) {
  d = smooth_union(d, ellipsoid_distance(p, {0.0, -7.0, 6.7}, {2.9, 2.5, 2.55}), 1.6);
  const Knot philtrum[] = {{{0.0, -5.1, 9.50}, 0.16}, {{0.0, -5.95, 9.75}, 0.18}};
  d = smooth_difference(d, chain_distance(p, philtrum, 0.2), 0.45);
  const Knot upper[] = {{{0.0, -6.60, 9.16}, 0.36},
                        {{0.55, -6.48, 9.12}, 0.38},
                        {{1.45, -6.82, 8.62}, 0.30},
                        {{2.65, -7.22, 7.55}, 0.06}};
  const Knot lower[] = {
      {{0.0, -7.92, 8.98}, 0.48}, {{0.75, -7.88, 8.88}, 0.48}, {{1.6, -7.62, 8.42}, 0.34}, {{2.45, -7.28, 7.75}, 0.08}};
  d = smooth_union(d, chain_distance(p, upper, 0.3), 0.50);
  d = smooth_union(d, chain_distance(p, lower, 0.3), 0.50);
  const Knot line[] = {
      {{0.0, -7.16, 9.56}, 0.07}, {{0.6, -7.06, 9.48}, 0.07}, {{1.5, -7.14, 9.00}, 0.07}, {{2.62, -7.26, 8.10}, 0.11}};
  d = smooth_difference(d, chain_distance(p, line, 0.05), 0.24);
  d = smooth_difference(d, ellipsoid_distance(p, {2.85, -7.32, 8.1}, {0.35, 0.45, 0.5}), 0.7);  // corners
  d = smooth_difference(d, ellipsoid_distance(p, {0.0, -8.95, 9.55}, {1.5, 0.38, 0.80}), 0.9);
  const Knot fold[] = {{{1.85, -4.5, 9.0}, 0.05}, {{3.1, -6.6, 8.15}, 0.05}};
  return smooth_difference(d, chain_distance(p, fold, 0.2), 0.9);
}

/// The outer ear, a bowl with a rolled rim, tilted away from the head.
double ear_distance(const Point3& p) {
  Point3 q = p - Point3(6.95, -1.5, -0.9);
  q = rotated_y(q, 0.42);  // opens forward
  q = rotated_x(q, 0.16);
  double d = ellipsoid_distance(q, {0.15, 0.1, -0.25}, {0.55, 2.9, 1.75});
  d = smooth_difference(d, ellipsoid_distance(q, {0.75, 0.1, -0.25}, {0.55, 2.3, 1.25}), 0.25);
  const Knot helix[] = {{{0.45, 0.15, 0.75}, 0.26},  {{0.60, 1.2, 1.25}, 0.28},  {{0.72, 2.55, 0.75}, 0.30},
                        {{0.78, 2.95, -0.4}, 0.32},  {{0.78, 2.3, -1.55}, 0.32}, {{0.72, 0.8, -1.95}, 0.30},
                        {{0.60, -0.8, -1.55}, 0.28}, {{0.50, -2.0, -0.75}, 0.34}};
  d = smooth_union(d, chain_distance(q, helix, 0.2), 0.25);
  const Knot antihelix[] = {
      {{0.60, 1.9, -0.35}, 0.22}, {{0.66, 0.9, -0.95}, 0.30}, {{0.62, -0.5, -0.80}, 0.32}, {{0.55, -1.3, -0.15}, 0.30}};
  d = smooth_union(d, chain_distance(q, antihelix, 0.2), 0.35);
  d = smooth_difference(d, ellipsoid_distance(q, {0.75, -0.25, 0.05}, {0.55, 0.85, 0.62}), 0.25);
  d = smooth_union(d, ellipsoid_distance(q, {0.45, -0.45, 0.85}, {0.35, 0.50, 0.32}), 0.3);  // tragus
  return smooth_union(d, ellipsoid_distance(q, {0.42, -2.55, 0.15}, {0.42, 0.85, 0.75}), 0.5);
}

}  // namespace

double head_distance(const Point3& point) {
  // Mirrored with a rounded fold, so that the middle of the face has no crease.
  const Point3 p{std::sqrt(point.x * point.x + 0.012), point.y, point.z};
  double d = skull_distance(p);
  d = nose_distance(d, p);
  d = orbit_distance(d, p);
  d = mouth_distance(d, p);
  return smooth_union(d, ear_distance(p), 0.45);
}

}  // namespace luminist
