#include "bench/recover.h"

#include <algorithm>

#include "bench/hidden_light.h"
#include "solve/start_light.h"

namespace luminist {
namespace {

constexpr float kUnpainted = 0.1F;  // nu

/// The light of section 5.2 in an otherwise dark rig, all 18 degrees of freedom free.
Result<BenchTask> recovery_task(const BenchStage& stage, std::uint64_t seed) {
  const ParamState dark = initial_state(stage.stage->types, stage.stage->style, stage.frame());
  LUM_TRY(HiddenTask hidden, hidden_task(stage.renderer(), stage.stage->types, dark, kUnpainted, seed));
  LUM_TRY(Light light, free_cinematic(stage.stage->types, "new", stage.frame()));
  LUM_TRY(const StartLight start, estimate_start_light(stage.renderer().surface(), hidden.target, stage.frame()));
  apply_start_light(start, light);
  BenchTask task{dark, std::move(hidden.target)};
  task.start.rig.lights.push_back(light);
  LUM_TRY(const double epsilon, stage.renderer().error(task.start, task.target));
  task.goal = kReached * epsilon;
  return task;
}

}  // namespace

Result<void> run_recover(Device& device, const RecoverOptions& options) {
  LUM_TRY(BenchSuite suite, BenchSuite::create("recover", options.suite, {}, {}));
  std::vector<BenchScene> scenes{bare_scene(options.scene)};
  if (!options.meshes.empty()) {
    LUM_TRY(scenes, scenes_of_folder(options.meshes));
  }
  std::vector<MethodPlan> plans{{Method::kFast, options.size, options.seeds}};
  if (!options.no_simplex) {
    plans.push_back({Method::kSimplex, options.simplex_size, std::min(options.seeds, options.simplex_seeds)});
  }
  for (const BenchScene& scene : scenes) {
    for (const MethodPlan& plan : plans) {
      LUM_TRY(const BenchStage stage, open_bench_stage(device, scene, plan.size.width, plan.size.height));
      LUM_TRY([[maybe_unused]] const BenchReport report,
              suite.run(stage, "18", plan, [&](std::uint64_t seed) { return recovery_task(stage, seed); }));
    }
  }
  return {};
}

}  // namespace luminist
