#pragma once
// tests/bench/table1.h -- the paper's Table I: lights are moved away, and found again from the original picture.
#include "bench/bench_suite.h"
#include "gpu/device.h"

namespace luminist {

struct Table1Options {
  SuiteOptions suite;
  /// "full": by 10 to 50 % of the useful range (see useful_ranges()). "small": by a quarter of that. "manifest": by 10
  /// to 50 % of all that the solver may try, which mostly throws a light off the scene: it starts in the dark.
  std::string perturb = "full";
};

/// 5, 18, 30 and 51 degrees of freedom of 1, 1, 2 and 4 lights of the scenes' committed rigs, each moved by 10 to 50 %
/// of its useful range; the original picture is the target everywhere; the goal is 5 % of the epsilon that the move
/// made. Says which degrees of freedom are free, a line a scene, row, method and size, and how much the faithful
/// simplex takes more than the fast solver. Draws the convergence of each row. errors kUsage; the renderer's.
Result<void> run_table1(Device& device, const Table1Options& options);

}  // namespace luminist
