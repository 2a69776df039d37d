#pragma once
// tests/bench/styles.h -- a light and the colours of a style from paint, in styles that are not the cinematic one.
#include "bench/bench_suite.h"
#include "gpu/device.h"

namespace luminist {

/// Every style folder but `cinematic` is a task, in the creature's scene with one light. For each seed the light's
/// place, aim and colour and the style's colours are elsewhere; dabs of that picture are painted where it differs. The
/// light's position, direction and colour and the style's colours are free. errors the renderer's.
Result<void> run_styles(Device& device, const SuiteOptions& options);

}  // namespace luminist
