#include "bench/styles.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "bench/painted.h"
#include "bench/painter.h"
#include "bench/perturbation.h"

namespace luminist {
namespace {

constexpr PaintedPlan kStylesPlan{{512, 512}, {128, 128}, 20, 5};
constexpr std::array<int, 2> kLights{1, 3};  // of a task: the first of the rig
constexpr float kStylesBrush = 0.06F;        // diameter of a dab, picture heights
constexpr float kVisible = 0.05F;            // of the brightest pixel: what a painter would change
constexpr double kLeastPainted = 0.03;       // of the picture

/// The first lights of the rig, with what is solved for unlocked.
ParamState start_of(const BenchStage& stage, int lights) {
  static constexpr std::array<std::string_view, 3> kLook{"position", "direction", "color"};
  ParamState state = stage.state;
  state.rig.lights.resize(static_cast<std::size_t>(lights), state.rig.lights.front());
  for (Light& light : state.rig.lights) unlock_roles(light, kLook);
  const ParamSchema& schema = state.style.schema();
  for (int param = 0; param < schema.size(); ++param) {
    if (schema[param].role == "color" && !schema[param].quality) state.style.set_param_locked(param, false);
  }
  return state;
}

/// Where two pictures differ visibly.
std::vector<unsigned char> difference(const Image& a, const Image& b) {
  float peak = 0.0F;
  for (std::size_t i = 0; i < a.pixels(); ++i) peak = std::max(peak, glm::length(a.rgb(i)));
  std::vector<unsigned char> mask(a.pixels());
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = glm::distance(a.rgb(i), b.rgb(i)) > kVisible * peak ? 1 : 0;
  return mask;
}

/// Made on the small probe's picture, so that every size gets the same strokes.
Result<StrokeFile> style_paint(const BenchStage& probe, const ParamState& start, std::span<const UnitRange> ranges,
                               std::uint64_t seed) {
  constexpr int kDraws = 200;
  Random random(seed);
  LUM_TRY(const Image before, probe.renderer().render(start));
  for (int i = 0; i < kDraws; ++i) {
    LUM_TRY(const Image wanted, probe.renderer().render(perturbed(start, probe.frame(), ranges, {}, random)));
    const std::vector<unsigned char> mask = difference(wanted, before);
    const auto painted = std::count(mask.begin(), mask.end(), 1);
    if (static_cast<double>(painted) < kLeastPainted * static_cast<double>(mask.size())) continue;
    Brush brush;
    brush.diameter = kStylesBrush;
    brush.texture = 0.0F;
    StrokeFile file;
    file.strokes = colored_dabs(brush, wanted, mask, random);
    if (!file.strokes.empty()) return file;
  }
  return Error{ErrorKind::kLimit, "no change of the light and the style can be seen", probe.scene, "scenes", ""};
}

/// One style in one scene with so many lights.
Result<void> run_style(Device& device, BenchSuite& suite, const BenchScene& scene, const std::string& task,
                       int lights) {
  LUM_TRY(const BenchStage probe, open_bench_stage(device, scene, 96, 96));
  const ParamState probe_start = start_of(probe, lights);
  LUM_TRY(const std::vector<UnitRange> ranges, useful_ranges(probe.renderer(), probe_start));
  const auto make = [&](const BenchStage& stage, std::uint64_t seed) -> Result<BenchTask> {
    LUM_TRY(const StrokeFile strokes, style_paint(probe, probe_start, ranges, seed));
    ParamState start = start_of(stage, lights);
    LUM_TRY(Canvas canvas, canvas_on(stage, start));
    LUM_TRY_VOID(canvas.apply(strokes, "generated"));
    return BenchTask{std::move(start), canvas.target()};
  };
  return run_painted(device, suite, scene, {{task, make}}, kStylesPlan);
}

std::string task_name(const std::string& style, int lights) {
  return fmt::format("{}-{}", style, lights);
}

}  // namespace

Result<void> run_styles(Device& device, const SuiteOptions& options) {
  std::vector<std::string> styles;
  std::vector<std::string> tasks;
  for (std::string& style : style_names(AssetRoots::standard())) {
    if (style == "cinematic") continue;
    LUM_TRY(const Style loaded, load_style(AssetRoots::standard(), style));
    if (!loaded.shades() || loaded.engine != StyleEngine::kRaster) continue;
    for (const int lights : kLights) tasks.push_back(task_name(style, lights));
    styles.push_back(std::move(style));
  }
  LUM_TRY(BenchSuite suite, BenchSuite::create("styles", options, {"still_life", "bust", "creature"}, tasks));
  for (const std::string& name : suite.scenes()) {
    for (const std::string& style : styles) {
      for (const int lights : kLights) {
        const std::string task = task_name(style, lights);
        if (!suite.wants_task(task)) continue;
        BenchScene scene = demo_scene(name);
        scene.shot.style = style;
        LUM_TRY_VOID(run_style(device, suite, scene, task, lights));
      }
    }
  }
  return {};
}

}  // namespace luminist
