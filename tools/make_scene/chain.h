#pragma once
// make_scene/chain.h -- limbs: chains of round cones.
#include <span>

#include "make_scene/sdf.h"

namespace luminist {

struct Knot {
  Point3 place;
  double radius;
};

/// Signed distance to round cones through the knots, blended over k.
double chain_distance(const Point3& p, std::span<const Knot> knots, double k);

}  // namespace luminist
