#include "bench/recover.h"

#include <cstdio>

#include <fmt/format.h>

#include "bench/hidden_light.h"
#include "solve/start_light.h"

namespace luminist {
namespace {

constexpr double kGoal = 0.05;
constexpr float kUnpainted = 0.1F;  // nu

/// The light of section 5.2 in an otherwise dark rig, all 18 degrees of freedom free.
Result<ParamState> start_state(const Stage& stage, const ParamState& dark, const HiddenTask& task) {
  LUM_TRY(Light light, free_cinematic(stage.types, "new", stage.frame));
  LUM_TRY(const StartLight start, estimate_start_light(stage.renderer->surface(), task.target, stage.frame));
  apply_start_light(start, light);
  ParamState state = dark;
  state.rig.lights.push_back(light);
  return state;
}

Result<BenchRun> run_one(Stage& stage, SolverKind kind, int max_evals, std::uint64_t seed) {
  const ParamState dark = initial_state(stage.types, stage.style, stage.frame);
  LUM_TRY(const HiddenTask task, hidden_task(*stage.renderer, stage.types, dark, kUnpainted, seed));
  LUM_TRY(const ParamState start, start_state(stage, dark, task));
  LUM_TRY(const double epsilon_start, stage.renderer->error(start, task.target));
  SolveOptions options;
  options.solver = kind;
  options.seed = seed;
  options.until = kGoal * epsilon_start;
  options.max_evals = max_evals;
  LUM_TRY(SolveSession session, SolveSession::create(*stage.renderer, start, task.target, options));
  BenchRun run;
  LUM_TRY(run.report, run_to_end(session));
  run.success = run.report.epsilon <= kGoal * run.report.epsilon_start;
  run.capped = run.report.termination == Termination::kEvalLimit;
  return run;
}

Result<BenchReport> run_method(Device& device, const BenchScene& scene, const BenchOptions& options, SolverKind kind) {
  const bool fast = kind == SolverKind::kFast;
  BenchReport report{"recover",
                     scene.name,
                     fast ? options.width : options.simplex_width,
                     fast ? options.height : options.simplex_height,
                     fast ? "fast" : "simplex",
                     1,
                     18,
                     {}};
  LUM_TRY(const std::unique_ptr<Stage> stage, bench_stage(device, scene, report.width, report.height));
  const int seeds = fast ? options.seeds : std::min(options.seeds, options.simplex_seeds);
  for (int seed = 1; seed <= seeds; ++seed) {
    LUM_TRY(const BenchRun run, run_one(*stage, kind, fast ? std::numeric_limits<int>::max() : options.simplex_evals,
                                        static_cast<std::uint64_t>(seed)));
    report.runs.push_back(run);
    if (!options.verbose) continue;
    const SolveReport& r = run.report;
    std::fputs(fmt::format("{} {} seed {}: {:.5f} -> {:.5f} ({:.4f}) evals {} RE {:.1f} {:.3f} s {}{}\n", scene.name,
                           report.method, seed, r.epsilon_start, r.epsilon, r.epsilon / r.epsilon_start, r.evals,
                           r.render_equivalents, r.seconds, to_string(r.termination), run.success ? "" : "  MISSED")
                   .c_str(),
               stderr);
  }
  return report;
}

}  // namespace

Result<void> run_recover(Device& device, const BenchOptions& options,
                         const std::function<void(const BenchReport&)>& report) {
  LUM_TRY(const std::vector<BenchScene> scenes, bench_scenes(options));
  for (const BenchScene& scene : scenes) {
    for (const SolverKind kind : {SolverKind::kFast, SolverKind::kSimplex}) {
      if (kind == SolverKind::kSimplex && options.no_simplex) continue;
      LUM_TRY(const BenchReport done, run_method(device, scene, options, kind));
      report(done);
    }
  }
  return {};
}

}  // namespace luminist
