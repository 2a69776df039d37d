#include "bench/figure6.h"

#include <array>
#include <string_view>
#include <utility>

#include "bench/painted.h"
#include "bench/painter.h"
#include "bench/perturbation.h"
#include "solve/start_light.h"

namespace luminist {
namespace {

constexpr PaintedPlan kPlan{{640, 480}, {160, 120}, 20, 5};  // the strokes are for this aspect
const char* const kCrude = "meshes/still_life/figure2/1_key.json";
const char* const kRefined = "meshes/still_life/figure2/2_refine.json";

/// Position 3, direction 2, colour 3, shape 3, shadow density 1.
void free_twelve(Light& light) {
  static constexpr std::array<std::string_view, 5> kRoles{"position", "direction", "color", "shape", "shadow"};
  light.params.set_param_locked(-1, true);
  unlock_roles(light, kRoles);
}

/// Position 3, direction 2 and the first two numbers of the shape: half width and height.
void free_seven(Light& light) {
  static constexpr std::array<std::string_view, 3> kRoles{"position", "direction", "shape"};
  light.params.set_param_locked(-1, true);
  unlock_roles(light, kRoles);
  const ParamSchema& schema = light.params.schema();
  if (const auto shape = schema.by_role("shape")) light.params.set_locked(schema[*shape].first_dof + 2, true);
}

/// What is solved in Figure 2(d), and what was painted for it.
struct Crude {
  BenchTask task;
  Canvas canvas;
};

Result<Crude> crude(const BenchStage& stage, std::uint64_t seed) {
  Random random(seed);
  LUM_TRY(const StrokeFile strokes, committed_strokes(kCrude));
  LUM_TRY(Canvas canvas, canvas_on(stage, stage.state));
  LUM_TRY_VOID(canvas.apply(unsteady(strokes, random), kCrude));
  ParamState start = stage.state;
  LUM_TRY(Light light, make_light(stage.stage->types, "cinematic", "key", stage.frame()));
  LUM_TRY(const StartLight estimate, estimate_start_light(stage.renderer().surface(), canvas.target(), stage.frame()));
  apply_start_light(estimate, light);
  free_seven(light);
  start.rig.lights.push_back(std::move(light));
  Target target = canvas.target();
  return Crude{{std::move(start), std::move(target)}, std::move(canvas)};
}

Result<BenchTask> crude_task(const BenchStage& stage, std::uint64_t seed) {
  LUM_TRY(Crude made, crude(stage, seed));
  return std::move(made.task);
}

/// The light that the crude paint made, solved on this very picture, with more paint on top.
Result<BenchTask> refined_task(const BenchStage& stage, std::uint64_t seed) {
  LUM_TRY(const Crude made, crude(stage, seed));
  ParamState solved = made.task.start;
  free_twelve(solved.rig.lights.back());
  BenchTask first{solved, made.task.target};
  first.stated = false;
  LUM_TRY([[maybe_unused]] const BenchRun run, run_method(stage.renderer(), first, Method::kFast, {}, 1, &solved));
  LUM_TRY(Canvas canvas, canvas_on(stage, solved));
  LUM_TRY(StrokeFile strokes, committed_strokes(kRefined));
  Random random(seed + 1000);
  LUM_TRY_VOID(canvas.apply(unsteady(std::move(strokes), random), kRefined));
  return BenchTask{solved, canvas.target()};
}

}  // namespace

Result<void> run_figure6(Device& device, const SuiteOptions& options) {
  LUM_TRY(BenchSuite suite, BenchSuite::create("figure6", options, {"still_life"}, {"7", "12"}));
  if (!options.size.empty()) {
    LUM_TRY(const PictureSize size, parse_size(options.size));
    if (3 * size.width != 4 * size.height) {
      return Error{ErrorKind::kUsage, "the strokes of Figure 2 are painted on 4:3", "", "size", "for example 320x240"};
    }
  }
  for (const std::string& scene : suite.scenes()) {
    LUM_TRY_VOID(run_painted(device, suite, bare_scene(scene), {{"7", crude_task}, {"12", refined_task}}, kPlan));
  }
  return {};
}

}  // namespace luminist
