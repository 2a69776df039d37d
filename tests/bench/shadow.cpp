#include "bench/shadow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "bench/painted.h"
#include "bench/painter.h"
#include "bench/perturbation.h"

namespace luminist {
namespace {

constexpr PaintedPlan kShadowPlan{{512, 512}, {128, 128}, 20, 5};
constexpr float kBrush = 0.08F;        // diameter of a dab, picture heights
constexpr std::size_t kLeastDabs = 5;  // of shadow and of light: less is no request

/// Where light number 0 casts a shadow: pixels that lose at least half of what it would give them.
Result<std::vector<unsigned char>> shadow_of_first(Renderer& renderer, const ParamState& state) {
  ParamState alone = state;
  for (std::size_t i = 1; i < alone.rig.lights.size(); ++i) alone.rig.lights[i].muted = true;
  ParamState dark = alone;
  dark.rig.lights[0].muted = true;
  LUM_TRY(const Image lit, renderer.render(alone));
  LUM_TRY(const Image unshadowed, renderer.render(alone, RenderOptions{.shadows = false}));
  LUM_TRY(const Image none, renderer.render(dark));
  const auto brightness = [](const Vec3& color) { return color.x + color.y + color.z; };
  float peak = 0.0F;
  for (std::size_t i = 0; i < lit.pixels(); ++i) peak = std::max(peak, brightness(unshadowed.rgb(i) - none.rgb(i)));
  std::vector<unsigned char> mask(lit.pixels());
  for (std::size_t i = 0; i < mask.size(); ++i) {
    const float full = brightness(unshadowed.rgb(i) - none.rgb(i));
    mask[i] = full > 0.02F * peak && brightness(lit.rgb(i) - none.rgb(i)) < 0.5F * full ? 1 : 0;
  }
  return mask;
}

/// The first light 15 to 45 degrees around the spot it looks at, at the same distance and height within a few degrees.
ParamState moved(const ParamState& state, const SceneFrame& frame, Random& random) {
  ParamState result = state;
  ParamBlock& params = result.rig.lights[0].params;
  const int position = params.schema().by_role("position").value();
  const int direction = params.schema().by_role("direction").value();
  const Vec3 from = params.vec3(position);
  const Vec3 way = params.vec3(direction);
  const float distance = glm::length(frame.center - from);
  const Vec3 aim = from + distance * way;
  const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
  const auto turn = static_cast<float>(side * random.uniform(0.26, 0.79));
  const auto lift = static_cast<float>(random.uniform(-0.1, 0.1));
  Vec3 back = -way;
  back = {std::cos(turn) * back.x + std::sin(turn) * back.z, back.y + lift,
          std::cos(turn) * back.z - std::sin(turn) * back.x};
  params.set_vec3(position, aim + distance * glm::normalize(back));
  params.set_vec3(direction, -glm::normalize(back));
  return result;
}

/// a and not b.
std::vector<unsigned char> without(std::vector<unsigned char> a, const std::vector<unsigned char>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] != 0 && b[i] == 0 ? 1 : 0;
  return a;
}

/// The paint is made on the small probe's picture, so that every size gets the same strokes.
Result<StrokeFile> shadow_paint(const BenchStage& probe, std::uint64_t seed) {
  constexpr int kDraws = 200;
  Random random(seed);
  LUM_TRY(const std::vector<unsigned char> old_shadow, shadow_of_first(probe.renderer(), probe.state));
  for (int i = 0; i < kDraws; ++i) {
    const ParamState wanted = moved(probe.state, probe.frame(), random);
    LUM_TRY(const std::vector<unsigned char> new_shadow, shadow_of_first(probe.renderer(), wanted));
    Brush brush;
    brush.diameter = kBrush;
    brush.tool = PaintTool::kShadowEraser;
    StrokeFile file;
    file.strokes = dabs(brush, without(old_shadow, new_shadow), probe.width, probe.height, random);
    brush.tool = PaintTool::kShadow;
    const std::vector<Stroke> dark = dabs(brush, without(new_shadow, old_shadow), probe.width, probe.height, random);
    if (std::min(file.strokes.size(), dark.size()) < kLeastDabs) continue;
    file.strokes.insert(file.strokes.end(), dark.begin(), dark.end());
    return file;
  }
  return Error{ErrorKind::kLimit, "no place of the light moves its shadow", probe.scene, "scenes", ""};
}

Result<BenchTask> shadow_task(const BenchStage& probe, const BenchStage& stage, bool aims, std::uint64_t seed) {
  LUM_TRY(const StrokeFile strokes, shadow_paint(probe, seed));
  ParamState start = stage.state;
  Light& light = start.rig.lights[0];
  const ParamSchema& schema = light.params.schema();
  static constexpr std::array<std::string_view, 1> kPlace{"position"};
  static constexpr std::array<std::string_view, 3> kAim{"position", "direction", "shape"};
  unlock_roles(light, aims ? std::span<const std::string_view>(kAim) : kPlace);
  if (const auto shape = schema.by_role("shape")) light.params.set_locked(schema[*shape].first_dof + 2, true);
  LUM_TRY(Canvas canvas, canvas_on(stage, start));
  LUM_TRY_VOID(canvas.apply(strokes, "generated"));
  return BenchTask{std::move(start), canvas.target()};
}

}  // namespace

Result<void> run_shadow(Device& device, const SuiteOptions& options) {
  LUM_TRY(BenchSuite suite, BenchSuite::create("shadow", options, {"still_life", "bust", "creature"}, {"3", "7"}));
  for (const std::string& name : suite.scenes()) {
    const BenchScene scene = demo_scene(name);
    LUM_TRY(const BenchStage probe, open_bench_stage(device, scene, 128, 128));
    const auto case_of = [&probe](const char* task, bool aims) {
      return PaintedCase{task, [&probe, aims](const BenchStage& stage, std::uint64_t seed) {
                           return shadow_task(probe, stage, aims, seed);
                         }};
    };
    LUM_TRY_VOID(run_painted(device, suite, scene, {case_of("3", false), case_of("7", true)}, kShadowPlan));
  }
  return {};
}

}  // namespace luminist
