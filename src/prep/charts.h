#pragma once
// prep/charts.h -- a surface cut into regions that can be flattened with little distortion.
#include <vector>

#include "surface/surface_sides.h"

namespace luminist {

/// Triangles that are connected over sides.
using Region = std::vector<std::uint32_t>;

struct ChartOptions {
  /// How far the normals of a region may leave a plane curve on the sphere of directions, as a standard deviation. A
  /// cylinder, a cone and a plane have 0 however far they go around; a spherical cap of 55 degrees has 0.12.
  double spread = 0.12;
  /// Regions do not grow over an edge, radians.
  double crease = 0.87;
  /// Regions below this share of their piece's area join a neighbour, if that stays within twice the spread.
  double smallest = 0.004;
  /// Regions below this share join a neighbour whatever lies between: single triangles that stick out of a scan.
  double tiny = 3e-4;
};

/// Every triangle in one region: neighbours are merged, the best first, as long as the options allow. Borders come to
/// lie on sharp edges, in grooves rather than on ridges, and are straightened. No region is a closed surface. Regions
/// are in order of their first triangle. cost O(n log n), about 5 us a triangle.
/// source: hierarchical face clustering, Garland et al. 2001; developable regions, Julius et al. 2005.
std::vector<Region> charts_of(const SurfaceSides& sides, const ChartOptions& options = {});

/// A region of two triangles or more as two. features [region's triangles]: what should be alike in each part besides
/// the normals; may be empty.
std::array<Region, 2> halves_of(const SurfaceSides& sides, const Region& region,
                                const std::vector<glm::dvec2>& features);

}  // namespace luminist
