#pragma once
// tests/bench/figure6.h -- the paper's Figure 6: a new light from crude paint, and the same light refined.
#include "bench/bench_suite.h"
#include "gpu/device.h"

namespace luminist {

/// The committed strokes of the still life, by another hand for each seed. Task "7" is Figure 2(d): the starting
/// configuration gets its place, aim and footprint from the crude paint. Task "12" is 2(f): more paint, and all that
/// shapes the light is free. errors the renderer's.
Result<void> run_figure6(Device& device, const SuiteOptions& options);

}  // namespace luminist
