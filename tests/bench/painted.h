#pragma once
// tests/bench/painted.h -- tasks that nothing matches exactly: a solver is judged by how near it comes to the best.
#include <functional>
#include <string>
#include <vector>

#include "bench/bench_suite.h"
#include "gpu/device.h"

namespace luminist {

/// One task in one scene, at any size. make's goal does not count.
struct PaintedCase {
  std::string task;
  std::function<Result<BenchTask>(const BenchStage& stage, std::uint64_t seed)> make;
  bool one_target = false;  ///< start and target are the same for every seed: they have one best
};

/// Sizes and seeds of the fast solver and of the baselines.
struct PaintedPlan {
  PictureSize size{512, 512};
  PictureSize baseline_size{128, 128};
  int seeds = 20;
  int baseline_seeds = 5;
};

/// The goal of a task: within 5 % of what there was to gain of the best epsilon that any method found, long runs
/// included. The long runs are the fast solver's, pursued to its last round, and the simplex of the start and of the
/// fast solver's best, each to the cap of evaluations, on a small picture, taken to the full size; they are stored too.
double painted_goal(double start, double best);

/// A run that went on regardless of the goal, as if it had been stopped there: work and time are those of its
/// convergence, totals stay.
BenchRun judged(BenchRun run, double goal);

/// Runs every wanted case and says it. No method knows the goal: the fast solver ends by its own rule, the others at
/// their cap. errors of the cases; the renderer's.
Result<void> run_painted(Device& device, BenchSuite& suite, const BenchScene& scene,
                         const std::vector<PaintedCase>& cases, const PaintedPlan& plan);

}  // namespace luminist
