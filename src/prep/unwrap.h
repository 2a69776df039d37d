#pragma once
// prep/unwrap.h -- a plane for any mesh: charts whose u runs along the strokes, and an atlas of them.
#include <vector>

#include "prep/chart_map.h"
#include "scene/mesh.h"

namespace luminist {

struct UnwrapOptions {
  ChartOptions charts;
  double stretch = 1.04;   ///< most of a chart, see Distortion
  std::uint64_t seed = 1;  ///< of the charts' offsets
};

/// One chart of an unwrapped mesh: a disc, laid without flips or overlap.
struct Chart {
  std::vector<std::uint32_t> triangles;  ///< of the unwrapped mesh, ascending
  ChartMethod method = ChartMethod::kRigid;
  Distortion distortion;   ///< as the floats of the result have it
  double area = 0.0;       ///< in squared scene units, on the surface and in the plane alike
  double coherence = 1.0;  ///< in [0,1]: how parallel the stroke field is in the plane
};

struct UnwrapTotals {
  std::size_t flipped = 0;
  double area = 1.0;  ///< means over the surface and worst triangle, as in Distortion
  double worst_area = 1.0;
  double angle = 1.0;
  double worst_angle = 1.0;
  double stretch = 1.0;
  double coherence = 1.0;
  double seams = 0.0;        ///< length of all charts' borders over the root of the area
  double utilization = 0.0;  ///< share of the atlas that charts cover
};

struct Unwrapped {
  Mesh mesh;                  ///< the repaired surface; vertices split where charts meet, with all their attributes
  std::vector<Vec2> strokes;  ///< [vertices] place on the chart in scene units, u along the strokes; each chart has an
                              ///< offset of its own, so that charts overlap here
  std::vector<Vec2> atlas;    ///< [vertices] in [0,1]^2; charts do not overlap
  std::vector<std::uint32_t> chart_of_triangle;
  std::vector<Chart> charts;
  UnwrapTotals totals;
};

/// repair(), stroke_field(), charts_of(), flatten() and pack(). Takes any mesh; nothing gives nothing. Same mesh, same
/// bits. cost about 30 us a triangle.
Unwrapped unwrap(const Mesh& mesh, const UnwrapOptions& options = {});

}  // namespace luminist
