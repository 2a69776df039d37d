#pragma once
// tests/bench/scaling.h -- how work and time grow with what is asked for.
#include "bench/bench_suite.h"
#include "gpu/device.h"

namespace luminist {

/// The fast solver on the bust, whose lights are moved by 1 to 3 % of all that the solver may try, to 5 % of epsilon or
/// its cap. Tasks: "dofs" (18 to 504, all of 1 to 28 lights), "lights" (1 to 100, the first one free), "triangles" (to
/// a million, subdivided) and "pixels" (to 3840x2160). Says for every axis the exponents of work, time and the time of
/// one picture: the slopes over doubly logarithmic axes, through the points that reached the goal. A point that the
/// device cannot hold is said and left out.
Result<void> run_scaling(Device& device, const SuiteOptions& options);

}  // namespace luminist
