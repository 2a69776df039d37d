#include "make_scene/chain.h"

namespace luminist {

double chain_distance(const Point3& p, std::span<const Knot> knots, double k) {
  double d = 1e9;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double link =
        round_cone_distance(p, knots[i - 1].place, knots[i].place, knots[i - 1].radius, knots[i].radius);
    d = i == 1 ? link : smooth_union(d, link, k);
  }
  return d;
}

}  // namespace luminist
