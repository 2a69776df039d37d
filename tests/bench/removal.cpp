#include "bench/removal.h"

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/painted.h"
#include "bench/perturbation.h"

namespace luminist {
namespace {

constexpr PaintedPlan kRemovalPlan{{512, 512}, {128, 128}, 20, 2};

using Roles = std::vector<std::string_view>;

ParamState without_shadows(ParamState state) {
  for (Light& light : state.rig.lights) {
    if (const auto density = light.params.schema().by_role("shadow")) light.params.set(*density, 0, 0.0);
  }
  return state;
}

/// The light whose absence changes the picture most.
Result<std::size_t> strongest(Renderer& renderer, const ParamState& state, const Target& target) {
  std::size_t best = 0;
  double most = -1.0;
  for (std::size_t i = 0; i < state.rig.lights.size(); ++i) {
    ParamState without = state;
    without.rig.lights[i].muted = true;
    LUM_TRY(const double loss, renderer.error(without, target));
    if (loss > most) most = loss, best = i;
  }
  return best;
}

Result<BenchTask> removal_task(const BenchStage& stage, const Roles& roles) {
  ParamState state = without_shadows(stage.state);
  LUM_TRY(const Image picture, stage.renderer().render(state));
  Target target = whole_picture(picture, picture);
  LUM_TRY(const std::size_t removed, strongest(stage.renderer(), state, target));
  state.rig.lights.erase(state.rig.lights.begin() + static_cast<std::ptrdiff_t>(removed));
  for (Light& light : state.rig.lights) unlock_roles(light, roles);
  return BenchTask{std::move(state), std::move(target)};
}

Result<void> say_dofs(Device& device, const BenchSuite& suite, const BenchScene& scene, const std::string& task,
                      const Roles& roles) {
  LUM_TRY(const BenchStage stage,
          open_bench_stage(device, scene, kRemovalPlan.baseline_size.width, kRemovalPlan.baseline_size.height));
  LUM_TRY(const BenchTask made, removal_task(stage, roles));
  const std::vector<std::string> names = free_names(made.start, stage.frame());
  const nlohmann::ordered_json line{{"bench", "removal"}, {"kind", "dofs"},       {"scene", scene.name},
                                    {"task", task},       {"dofs", names.size()}, {"names", names}};
  suite.say(line.dump(), fmt::format("{} task {}, free: {}", scene.name, task, fmt::join(names, " ")));
  return {};
}

}  // namespace

Result<void> run_removal(Device& device, const SuiteOptions& options) {
  LUM_TRY(BenchSuite suite, BenchSuite::create("removal", options, {"bust"}, {"36", "48"}));
  const std::vector<std::pair<std::string, Roles>> tasks{{"36", {"position", "color"}},
                                                         {"48", {"position", "color", "direction"}}};
  for (const std::string& name : suite.scenes()) {
    std::vector<PaintedCase> cases;
    for (const auto& [task, roles] : tasks) {
      if (!suite.wants_task(task)) continue;
      LUM_TRY_VOID(say_dofs(device, suite, demo_scene(name), task, roles));
      const Roles& free = roles;
      cases.push_back(
          {task, [&free](const BenchStage& stage, std::uint64_t) { return removal_task(stage, free); }, true});
    }
    LUM_TRY_VOID(run_painted(device, suite, demo_scene(name), cases, kRemovalPlan));
  }
  return {};
}

}  // namespace luminist
