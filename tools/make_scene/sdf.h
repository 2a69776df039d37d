#pragma once
// make_scene/sdf.h -- signed distance fields: negative inside. Smooth operations blend over about a distance k.
#include <functional>

#include "make_scene/surface.h"

namespace luminist {

/// Signed distance, or a lower bound that does not change faster than the position does.
using Field = std::function<double(const Point3&)>;

double sphere_distance(const Point3& p, const Point3& center, double radius);
/// An approximation that is exact at the surface and near it; errs to the small side far away.
double ellipsoid_distance(const Point3& p, const Point3& center, const Point3& radii);
/// A box about the origin with half extents, its edges rounded by `rounding` (inside the extents).
double box_distance(const Point3& p, const Point3& half, double rounding);
/// A cone with round ends: the hull of two spheres, about; radii are linear along the axis.
double round_cone_distance(const Point3& p, const Point3& a, const Point3& b, double radius_a, double radius_b);

/// Polynomial smooth minimum (Quilez): differs from min by at most k/4, where the two are equal.
double smooth_union(double a, double b, double k);
double smooth_intersection(double a, double b, double k);
/// a without b.
double smooth_difference(double a, double b, double k);

/// Central differences, normalized.
Point3 field_normal(const Field& field, const Point3& p, double step);

Point3 rotated_x(const Point3& p, double angle);
Point3 rotated_y(const Point3& p, double angle);
Point3 rotated_z(const Point3& p, double angle);

}  // namespace luminist
