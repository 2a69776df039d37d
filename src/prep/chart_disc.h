#pragma once
// prep/chart_disc.h -- a region of a surface, cut open until it is a disc.
#include <optional>

#include "prep/charts.h"

namespace luminist {

/// One piece with one border loop and no handle. Corners on both sides of a cut are different points.
struct Disc {
  std::vector<glm::dvec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of points, in the region's order
  std::vector<std::uint32_t> border;                    ///< points in order, the surface to the left
};

/// Twice the area of the triangle between the origin and two places; its sign is the way around.
inline double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// Cuts run along the shortest ways between borders and around handles, shorter on sharp edges and in grooves. Nothing
/// for a closed surface. cost O(n log n). source Erickson and Whittlesey 2005 (tree and cotree).
std::optional<Disc> disc_of(const WeldedMesh& surface, const SurfaceSides& sides, const Region& region);

}  // namespace luminist
