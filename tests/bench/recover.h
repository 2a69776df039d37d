#pragma once
// tests/bench/recover.h -- a hidden light of 18 degrees of freedom is asked for by its picture, and found again.
#include <functional>

#include "bench/bench_report.h"
#include "bench/bench_scene.h"

namespace luminist {

/// Runs the fast solver over all seeds and the simplex over its own, smaller share; hands each method's report on as
/// soon as it is there. Success: epsilon fell to 5 % of that of the start light of section 5.2.
Result<void> run_recover(Device& device, const BenchOptions& options,
                         const std::function<void(const BenchReport&)>& report);

}  // namespace luminist
