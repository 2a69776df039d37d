#pragma once
// tests/bench/removal.h -- a light is taken away, and the others make up for it (paper, section 6.1.1).
#include "bench/bench_suite.h"
#include "gpu/device.h"

namespace luminist {

/// The seven lights of the bust without shadows (density 0); the strongest is removed; the target is the picture with
/// it. Task "36" frees position and colour of the other six, "48" their direction too. errors the renderer's.
Result<void> run_removal(Device& device, const SuiteOptions& options);

}  // namespace luminist
