#pragma once
// studio/plot.h -- how a solve went, as a picture.
#include <string>
#include <vector>

#include "base/image.h"
#include "solve/solve_session.h"

namespace luminist {

/// Best epsilon so far, logarithmic, over the work in render equivalents. returns 900 x 540 pixels, linear RGB.
Image convergence_plot(const SolveReport& report);

/// A line through points, in the order of their x; named in the legend.
struct PlotCurve {
  struct Point {
    double x = 0.0;
    double y = 0.0;
  };
  std::string name;
  std::vector<Point> points;
};

/// Curves over two logarithmic axes with a legend; points that are not positive and finite are left out.
/// returns 900 x 540 pixels, linear RGB.
Image curve_plot(const std::string& title, const std::string& x_name, const std::string& y_name,
                 const std::vector<PlotCurve>& curves);

}  // namespace luminist
