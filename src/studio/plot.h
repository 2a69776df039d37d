#pragma once
// studio/plot.h -- how a solve went, as a picture.
#include "base/image.h"
#include "solve/solve_session.h"

namespace luminist {

/// Best epsilon so far, logarithmic, over the work in render equivalents. returns 900 x 540 pixels, linear RGB.
Image convergence_plot(const SolveReport& report);

}  // namespace luminist
