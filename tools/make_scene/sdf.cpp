#include "make_scene/sdf.h"

#include <algorithm>
#include <cmath>

namespace luminist {

double sphere_distance(const Point3& p, const Point3& center, double radius) {
  return glm::length(p - center) - radius;
}

double ellipsoid_distance(const Point3& p, const Point3& center, const Point3& radii) {
  const Point3 q = (p - center) / radii;
  const double k0 = glm::length(q);
  const double k1 = glm::length(q / radii);
  if (k1 < 1e-12) return -std::min({radii.x, radii.y, radii.z});
  return k0 * (k0 - 1.0) / k1;
}

double box_distance(const Point3& p, const Point3& half, double rounding) {
  const Point3 q = glm::abs(p) - half + rounding;
  const Point3 outside = glm::max(q, Point3(0.0));
  return glm::length(outside) + std::min(std::max({q.x, q.y, q.z}), 0.0) - rounding;
}

double round_cone_distance(const Point3& p, const Point3& a, const Point3& b, double radius_a, double radius_b) {
  const Point3 axis = b - a;
  const double t = std::clamp(glm::dot(p - a, axis) / glm::dot(axis, axis), 0.0, 1.0);
  return glm::length(p - a - axis * t) - (radius_a + (radius_b - radius_a) * t);
}

double smooth_union(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * k * 0.25;
}

double smooth_intersection(double a, double b, double k) {
  return -smooth_union(-a, -b, k);
}

double smooth_difference(double a, double b, double k) {
  return -smooth_union(-a, b, k);
}

Point3 field_normal(const Field& field, const Point3& p, double step) {
  const auto slope = [&](const Point3& d) { return field(p + d) - field(p - d); };
  const Point3 g{slope({step, 0.0, 0.0}), slope({0.0, step, 0.0}), slope({0.0, 0.0, step})};
  const double length = glm::length(g);
  return length > 0.0 ? g / length : Point3(0.0, 1.0, 0.0);
}

Point3 rotated_x(const Point3& p, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
}

Point3 rotated_y(const Point3& p, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * p.x + s * p.z, p.y, -s * p.x + c * p.z};
}

Point3 rotated_z(const Point3& p, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

}  // namespace luminist
