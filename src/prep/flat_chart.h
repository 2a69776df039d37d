#pragma once
// prep/flat_chart.h -- regions laid flat without flips or overlap, divided where they do not lie well.
#include "prep/chart_map.h"
#include "prep/curvature.h"

namespace luminist {

/// A region in the plane, with the area that it has on the surface; the stroke field runs along +x, in the mean.
struct FlatChart {
  Region region;
  Disc disc;                       ///< of the region
  std::vector<glm::dvec2> places;  ///< [disc.points]
  ChartMethod method = ChartMethod::kRigid;
  Distortion distortion;
  double area = 0.0;
  double coherence = 1.0;  ///< in [0,1]: 1 if all confident directions of the field are parallel in the plane
};

struct FlatteningLimits {
  double stretch = 1.04;         ///< Distortion::stretch of a chart: lengths are off by a fifth, root mean square
  double aligned_stretch = 1.2;  ///< the same of a chart whose triangles are turned to the strokes
  double coherence = 0.75;       ///< charts that have less are divided
  double smallest = 0.01;        ///< but not for that if they are below this share of their piece's area
};

/// Regions are tried as LSCM, where that flips or overlaps with a border on a circle, then made as rigid as possible,
/// and turned to the strokes triangle by triangle; those beyond the limits are divided (by the normals of `smooth`) and
/// tried again, down to single triangles if need be, so that there is always an answer. In order of their first
/// triangles; same surface, same bits. cost about 20 us a triangle over all cores.
std::vector<FlatChart> flatten(const WeldedMesh& surface, const SurfaceSides& sides, const SurfaceSides& smooth,
                               const StrokeField& field, std::vector<Region> regions,
                               const FlatteningLimits& limits = {});

}  // namespace luminist
