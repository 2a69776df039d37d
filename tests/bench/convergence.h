#pragma once
// tests/bench/convergence.h -- how the methods of one task came nearer to the target (paper, Figure 6).
#include <string>
#include <vector>

#include "base/image.h"
#include "bench/bench_report.h"

namespace luminist {

/// A curve for each report: over the work in render equivalents the median over its runs of the best epsilon so far, as
/// a share of the start's. Both axes are logarithmic. A run that has ended keeps its best.
Image convergence_image(const std::string& title, const std::vector<BenchReport>& reports);

}  // namespace luminist
