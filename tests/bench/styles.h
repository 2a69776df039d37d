#pragma once
// tests/bench/styles.h -- a light and the colours of a style from paint, in styles that are not the cinematic one.
#include "bench/bench_suite.h"
#include "gpu/device.h"

namespace luminist {

/// Every style folder but `cinematic` is two tasks, "<style>-1" and "<style>-3", with the first lights of the scene's
/// rig. For each seed their places, aims and colours and the style's colours are elsewhere; dabs of that picture are
/// painted where it differs. The lights' positions, directions and colours and the style's colours are free.
/// errors the renderer's.
Result<void> run_styles(Device& device, const SuiteOptions& options);

}  // namespace luminist
