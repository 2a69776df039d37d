#pragma once
// prep/chart_packing.h -- flat charts side by side in the unit square.
#include <vector>

#include "surface/surface_sides.h"

namespace luminist {

/// Where a chart goes: turned by the angle whose cosine and sine are `turn`, then moved, then scaled as all are.
struct ChartPlacement {
  glm::dvec2 turn{1.0, 0.0};
  glm::dvec2 offset{0.0};
};

struct ChartPacking {
  std::vector<ChartPlacement> charts;
  double scale = 1.0;        ///< of all charts alike
  double utilization = 0.0;  ///< share of the square that charts cover

  [[nodiscard]] glm::dvec2 place(std::size_t chart, const glm::dvec2& at) const;  ///< in [0,1]^2
};

/// Bounding boxes, turned to be small, the high ones first, each as low as it fits (skyline); the best of some widths
/// of the strip. Boxes keep a margin of a 256th of the square, or less where charts are many and small.
/// borders  [charts] polygons; areas [charts] what they cover.   cost O(charts^1.5).
ChartPacking pack(const std::vector<std::vector<glm::dvec2>>& borders, const std::vector<double>& areas);

}  // namespace luminist
