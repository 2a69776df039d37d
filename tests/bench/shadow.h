#pragma once
// tests/bench/shadow.h -- an existing light is moved by erasing its shadow and painting it elsewhere.
#include "bench/bench_suite.h"
#include "gpu/device.h"

namespace luminist {

/// In a scene's committed rig the first light is to stand elsewhere: for each seed at another place, as far away and
/// aimed at the same spot. Dabs erase the shadow it casts and put down the one it would cast. Task "3" frees its
/// position, task "7" direction and half width and height too. errors the renderer's.
Result<void> run_shadow(Device& device, const SuiteOptions& options);

}  // namespace luminist
