#include "bench/painted.h"

#include <algorithm>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "image_io/image_io.h"
#include "solve/objective.h"
#include "studio/drawing.h"

namespace luminist {
namespace {

constexpr double kNear = 0.05;
constexpr std::uint64_t kLongSeed = 1001;  // none of the runs that are judged
constexpr int kLongRuns = 2;               // of the fast solver
constexpr double kBeyondReach = 1e-9;      // a goal that keeps the fast solver at work to its last round

/// Epsilon, penalty included, of a state that was found on another picture.
Result<double> epsilon_of(Renderer& renderer, const ParamState& state, const Target& target) {
  Objective objective(renderer, state, target);
  return objective.evaluate(objective.unit(state));
}

/// The best of long runs at the size of `stage`. The simplexes walk on `small`.
Result<BenchRun> long_runs(const BenchStage& stage, const BenchStage& small, const PaintedCase& each,
                           std::uint64_t seed, int simplex_evals) {
  const MethodCaps caps{simplex_evals, std::numeric_limits<double>::infinity()};
  LUM_TRY(BenchTask task, each.make(stage, seed));
  task.goal = kBeyondReach;
  BenchRun best;
  ParamState best_state = task.start;
  for (int i = 0; i < kLongRuns; ++i) {
    ParamState found = task.start;
    LUM_TRY(const BenchRun run,
            run_method(stage.renderer(), task, Method::kFast, caps, kLongSeed + static_cast<std::uint64_t>(i), &found));
    if (i > 0 && run.epsilon >= best.epsilon) continue;
    best = run;
    best_state = found;
  }
  LUM_TRY(BenchTask small_task, each.make(small, seed));
  small_task.goal = kBeyondReach;
  for (const ParamState& start : {small_task.start, best_state}) {
    small_task.start = start;
    ParamState found = start;
    LUM_TRY([[maybe_unused]] const BenchRun run,
            run_method(small.renderer(), small_task, Method::kSimplex, caps, kLongSeed, &found));
    LUM_TRY(const double epsilon, epsilon_of(stage.renderer(), found, task.target));
    best.epsilon = std::min(best.epsilon, epsilon);
  }
  best.success = true;
  return best;
}

/// The first target and the start side by side, to be looked at: <bench>_<scene>_<task>_target.png.
Result<void> show_target(const BenchSuite& suite, const BenchStage& stage, const PaintedCase& each) {
  LUM_TRY(const BenchTask task, each.make(stage, 1));
  LUM_TRY(const Image start, stage.renderer().render(task.start));
  Image both(2 * stage.width, stage.height, 3);
  Drawing drawing(both);
  drawing.picture(0, 0, task.target.color);
  drawing.picture(stage.width, 0, start);
  return write_image(suite.file(fmt::format("{}_{}_target.png", suite.prefix(stage.scene), each.task)), both);
}

std::vector<MethodPlan> method_plans(const PaintedPlan& plan) {
  std::vector<MethodPlan> plans{{Method::kFast, plan.size, plan.seeds}};
  for (const Method method : {Method::kSimplex, Method::kNloptNelderMead, Method::kNloptBobyqa}) {
    plans.push_back({method, plan.baseline_size, plan.baseline_seeds});
  }
  return plans;
}

/// All plans of one size.
Result<void> run_size(BenchSuite& suite, const BenchStage& stage, const BenchStage& small, const PaintedCase& each,
                      const std::vector<MethodPlan>& plans, std::vector<BenchReport>& reports) {
  const int evals = suite.options().caps.max_evals;
  std::map<std::uint64_t, double> best;  // by the seed of the target
  std::vector<BenchReport> raw;
  for (const MethodPlan& plan : plans) {
    if (plan.size != PictureSize{stage.width, stage.height}) continue;
    BenchReport report;
    for (int i = 1; i <= plan.seeds; ++i) {
      const auto seed = static_cast<std::uint64_t>(i);
      const std::uint64_t target = each.one_target ? 1 : seed;
      const auto search = [&] { return long_runs(stage, small, each, target, evals); };
      LUM_TRY(const BenchRun longest,
              suite.find_or_make(stage, each.task, "reference", fmt::format("{} evals", evals), target, search));
      if (best.count(target) == 0) suite.follow(longest);
      const auto make = [&](std::uint64_t which) -> Result<BenchTask> {
        LUM_TRY(BenchTask task, each.make(stage, which));
        task.stated = false;
        return task;
      };
      LUM_TRY(BenchRun run, suite.solve(stage, each.task, plan.method, seed, make));
      const auto known = best.try_emplace(target, longest.epsilon).first;
      known->second = std::min(known->second, run.epsilon);
      report.runs.push_back(std::move(run));
    }
    if (!report.runs.empty()) raw.push_back(std::move(report));
  }
  for (BenchReport& report : raw) {
    for (BenchRun& run : report.runs) {
      const std::uint64_t target = each.one_target ? 1 : run.key.seed;
      run = judged(std::move(run), painted_goal(run.epsilon_start, best.at(target)));
      suite.follow(run);
    }
    suite.say(report);
    reports.push_back(std::move(report));
  }
  return {};
}

}  // namespace

double painted_goal(double start, double best) {
  return best + kNear * (start - best);
}

BenchRun judged(BenchRun run, double goal) {
  run.goal = goal;
  run.success = false;
  run.equivalents = run.total_equivalents;
  run.seconds = run.total_seconds;
  for (const ConvergencePoint& point : run.convergence) {
    if (point.epsilon > goal) continue;
    run.success = true;
    run.evals = point.evals;
    run.equivalents = point.render_equivalents;
    run.seconds = point.seconds;
    break;
  }
  return run;
}

Result<void> run_painted(Device& device, BenchSuite& suite, const BenchScene& scene,
                         const std::vector<PaintedCase>& cases, const PaintedPlan& plan) {
  const std::vector<MethodPlan> plans = suite.narrowed(method_plans(plan));
  LUM_TRY(const BenchStage small, open_bench_stage(device, scene, plan.baseline_size.width, plan.baseline_size.height));
  for (const PaintedCase& each : cases) {
    if (!suite.wants_task(each.task)) continue;
    std::vector<BenchReport> reports;
    for (const PictureSize& size : sizes_of(plans)) {
      LUM_TRY(const BenchStage stage, open_bench_stage(device, scene, size.width, size.height));
      LUM_TRY_VOID(show_target(suite, stage, each));
      LUM_TRY_VOID(run_size(suite, stage, small, each, plans, reports));
    }
    suite.say_speed_ups(reports);
    LUM_TRY_VOID(suite.draw(scene.name, each.task, reports));
  }
  return {};
}

}  // namespace luminist
