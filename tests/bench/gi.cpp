#include "bench/gi.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include <fmt/ranges.h>

#include "bench/bench_statistics.h"
#include "bench/painter.h"
#include "render/metric.h"
#include "rig/constraint.h"
#include "trace/path_renderer.h"

namespace luminist {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kStrokes = "meshes/room/figure10/strokes.json";
constexpr const char* kLight = "panel";
constexpr int kReferenceSeed = 4711;

/// The engine as a black box: every picture is traced anew, where it counts, and compared.
class FreshPictures final : public Renderer {
 public:
  explicit FreshPictures(PathRenderer& engine) : engine_(&engine) {}
  [[nodiscard]] const SurfaceBuffer& surface() const override { return engine_->surface(); }
  [[nodiscard]] SceneFrame frame() const override { return engine_->frame(); }
  [[nodiscard]] const Style& style() const override { return engine_->style(); }
  [[nodiscard]] bool estimates() const override { return engine_->estimates(); }
  [[nodiscard]] const WorkCount& work() const override { return engine_->work(); }
  Result<Image> render(const ParamState& state, const RenderOptions& options) override {
    return engine_->render(state, options);
  }
  Result<double> error(const ParamState& state, const Target& target) override {
    LUM_TRY(const Image picture, engine_->render_where(state, target.importance));
    return picture_error(picture, target, style().metric);
  }
  Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                        std::span<Vec3> out) override {
    return engine_->evaluate(candidates, samples, softness, out);
  }

 private:
  PathRenderer* engine_;
};

/// One start and what was painted over it.
struct GiTask {
  ParamState start;
  Target target;  ///< at the whole size
};

/// The values that are free, in the order of kFree.
constexpr std::array<const char*, 4> kFree{"position.x", "position.z", "size", "intensity"};

struct GiRun {
  ParamState found;
  int evals = 0;
  bool capped = false;
  double seconds = 0.0;
  double cpu_seconds = 0.0;    ///< of all threads
  double first_seconds = 0.0;  ///< when the best was better than the start first; 0: never
  double epsilon = 0.0;        ///< by the independent picture
};

Result<void> assign(ParamState& state, const std::string& path, double value) {
  return set_path(state, fmt::format("{}={:.9g}", path, value));
}

/// The figure's rig with its panel elsewhere: anywhere over the room's middle, of any size and another strength.
Result<ParamState> moved_start(const ParamState& rig, std::uint64_t seed) {
  Random random(seed);
  ParamState start = rig;
  std::erase_if(start.rig.constraints,
                [](const Constraint& each) { return std::holds_alternative<Between>(each.rule); });
  const std::string light = fmt::format("lights/{}", kLight);
  Light* panel = start.rig.find(kLight);
  const auto position = panel != nullptr ? panel->params.schema().by_role("position") : std::nullopt;
  if (!position) return Error{ErrorKind::kMissing, "the figure's rig has no panel", "", kLight, ""};
  panel->params.set(*position, 0, random.uniform(-1.5, 1.5));
  panel->params.set(*position, 2, random.uniform(-1.2, 1.2));
  LUM_TRY_VOID(assign(start, light + "/size", random.uniform(0.2, 1.0)));
  LUM_TRY_VOID(assign(start, light + "/intensity", random.uniform(0.5, 1.5)));
  LUM_TRY_VOID(assign(start, "style/seed", static_cast<double>(seed)));
  LUM_TRY_VOID(assign(start, "style/clamp", 0.0));  // what is judged is exact but for noise
  for (ParamBlock* block : start.blocks()) block->set_param_locked(-1, true);
  for (const char* dof : kFree) LUM_TRY_VOID(set_locked(start, light + "/" + dof, false));
  keep_constraints(start.rig);
  return start;
}

Result<GiTask> make_task(const BenchStage& stage, std::uint64_t seed, int samples) {
  LUM_TRY(ParamState start, moved_start(stage.state, seed));
  LUM_TRY_VOID(assign(start, "style/samples", samples));
  GiTask task{std::move(start), {}};
  LUM_TRY(const StrokeFile strokes, committed_strokes(kStrokes));
  LUM_TRY(Canvas canvas, canvas_on(stage, task.start));
  LUM_TRY_VOID(canvas.apply(strokes, kStrokes));
  task.target = canvas.target();
  return task;
}

Target smaller(const Target& target, int width, int height) {
  Target result;
  result.color = resized(target.color, width, height);
  result.before = resized(target.before, width, height);
  result.importance = resized(target.importance, width, height);
  result.stroke.assign(result.color.pixels(), 0);
  return result;
}

/// Solves until the solver ends. run.seconds go on from what they are.
Result<void> solve(Renderer& renderer, const Target& target, const SolveOptions& options, GiRun& run) {
  const Clock::time_point begin = Clock::now();
  const std::clock_t cpu_begin = std::clock();
  const double before = run.seconds;
  const auto now = [&] { return before + std::chrono::duration<double>(Clock::now() - begin).count(); };
  LUM_TRY(SolveSession session, SolveSession::create(renderer, run.found, target, options));
  bool more = true;
  while (more) {
    LUM_TRY(more, session.step());
    const SolveReport& report = session.report();
    if (run.first_seconds == 0.0 && report.epsilon < report.epsilon_start) run.first_seconds = now();
  }
  run.found = session.best();
  run.evals += session.report().evals;
  run.capped = session.report().termination == Termination::kEvalLimit;
  run.seconds = now();
  run.cpu_seconds += static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC;
  return {};
}

/// The benchmark at one size: its stages and what it was asked for.
class GiBench {
 public:
  GiBench(Device& device, const GiOptions& options) : device_(&device), options_(&options) {}

  Result<void> prepare() {
    for (const int part : {4, 2, 1}) {
      BenchScene scene = demo_scene("room");
      scene.shot.rig = "meshes/room/figure10/rig.toml";
      scene.shot.style = "path";
      LUM_TRY(BenchStage stage, open_bench_stage(*device_, scene, std::max(1, options_->size.width / part),
                                                 std::max(1, options_->size.height / part)));
      stages_.push_back(std::move(stage));
    }
    return {};
  }

  Result<GiRun> run(const std::string& method, const GiTask& task, std::uint64_t seed) {
    GiRun run{task.start};
    SolveOptions options;
    options.seed = seed;
    options.restarts = 0;  // of either solver
    if (method == "kept" || method == "searched") {
      options.restarts = method == "kept" ? 0 : -1;
      options.solver = SolverKind::kFast;
      LUM_TRY_VOID(solve(stages_.back().renderer(), task.target, options, run));
      return run;
    }
    options.solver = SolverKind::kSimplex;
    for (std::size_t i = method == "full" ? stages_.size() - 1 : 0; i < stages_.size(); ++i) {
      const BenchStage& stage = stages_[i];
      options.max_evals = options_->max_evals - run.evals;
      if (options.max_evals <= 0) break;
      FreshPictures fresh(*stage.stage->paths);
      LUM_TRY_VOID(solve(fresh, smaller(task.target, stage.width, stage.height), options, run));
    }
    return run;
  }

  /// Epsilon without penalty, by paths that no method has seen.
  Result<double> judge(ParamState state, const Target& target) {
    LUM_TRY_VOID(assign(state, "style/samples", options_->reference));
    LUM_TRY_VOID(assign(state, "style/seed", kReferenceSeed));
    FreshPictures fresh(*stages_.back().stage->paths);
    return fresh.error(state, target);
  }

  Result<GiTask> task(std::uint64_t seed) { return make_task(stages_.back(), seed, options_->samples); }

 private:
  Device* device_;
  const GiOptions* options_;
  std::vector<BenchStage> stages_;  ///< a quarter of the size, a half, the whole
};

std::array<double, kFree.size()> free_values(const ParamState& state) {
  const ParamBlock& panel = state.rig.find(kLight)->params;
  const ParamSchema& schema = panel.schema();
  const int position = *schema.by_role("position");
  return {panel.get(position, 0), panel.get(position, 2), panel.get(*schema.find("size")),
          panel.get(*schema.find("intensity"))};
}

void print_run(const GiOptions& options, const std::string& method, std::uint64_t seed, double start,
               const GiRun& run) {
  if (options.json) {
    const nlohmann::ordered_json line{{"bench", "gi"},
                                      {"kind", "run"},
                                      {"method", method},
                                      {"seed", seed},
                                      {"size", options.size.text()},
                                      {"evals", run.evals},
                                      {"capped", run.capped},
                                      {"seconds", run.seconds},
                                      {"cpu_seconds", run.cpu_seconds},
                                      {"first_seconds", run.first_seconds},
                                      {"epsilon_start", start},
                                      {"epsilon", run.epsilon},
                                      {"found", free_values(run.found)}};
    std::printf("%s\n", line.dump().c_str());
  } else {
    fmt::print(
        "{:<16} seed {}  {:>4} pictures{}  {:>8.2f} s ({:.2f} s of processors), better after {:.2f} s  error {:.5f} -> "
        "{:.5f}  at {:.3f}\n",
        method, seed, run.evals, run.capped ? " (cap)" : "", run.seconds, run.cpu_seconds, run.first_seconds, start,
        run.epsilon, fmt::join(free_values(run.found), ", "));
  }
  std::fflush(stdout);
}

void print_results(const GiOptions& options, const std::vector<std::string>& methods,
                   const std::map<std::string, std::vector<GiRun>>& runs) {
  const auto of = [&](const std::string& method, double GiRun::*what) {
    std::vector<double> values;
    if (const auto found = runs.find(method); found != runs.end()) {
      for (const GiRun& run : found->second) values.push_back(run.*what);
    }
    return median(std::move(values));
  };
  const double full = of("full", &GiRun::seconds);
  const double full_cpu = of("full", &GiRun::cpu_seconds);
  for (const std::string& method : methods) {
    const double seconds = of(method, &GiRun::seconds);
    const double cpu_seconds = of(method, &GiRun::cpu_seconds);
    const double speedup = seconds > 0.0 ? full / seconds : 0.0;
    const double cpu_speedup = cpu_seconds > 0.0 ? full_cpu / cpu_seconds : 0.0;
    if (options.json) {
      const nlohmann::ordered_json line{{"bench", "gi"},
                                        {"kind", "result"},
                                        {"method", method},
                                        {"size", options.size.text()},
                                        {"runs", options.seeds},
                                        {"samples", options.samples},
                                        {"max_evals", options.max_evals},
                                        {"reference", options.reference},
                                        {"seconds", seconds},
                                        {"cpu_seconds", cpu_seconds},
                                        {"first_seconds", of(method, &GiRun::first_seconds)},
                                        {"epsilon", of(method, &GiRun::epsilon)},
                                        {"speedup", speedup},
                                        {"cpu_speedup", cpu_speedup}};
      std::printf("%s\n", line.dump().c_str());
    } else {
      fmt::print(
          "{:<16} median {:.2f} s, error {:.5f}, {:.1f} times the full simplex's speed ({:.1f} by processor time)\n",
          method, seconds, of(method, &GiRun::epsilon), speedup, cpu_speedup);
    }
  }
  std::fflush(stdout);
}

}  // namespace

Result<void> run_gi(Device& device, const GiOptions& options) {
  std::vector<std::string> methods{"kept", "searched", "multiresolution", "full"};
  if (!options.methods.empty()) {
    for (const std::string& method : options.methods) {
      if (std::ranges::find(methods, method) != methods.end()) continue;
      return Error{ErrorKind::kUsage, fmt::format("there is no method \"{}\"", method), "", "--methods",
                   "one of full, multiresolution, kept, searched"};
    }
    methods = options.methods;
  }
  std::map<std::string, std::vector<GiRun>> runs;
  for (int seed = 1; seed <= options.seeds; ++seed) {
    std::optional<double> start;  // the same for all methods
    // Engines of its own for every seed and method: nothing is kept from one run to the next.
    for (const std::string& method : methods) {
      GiBench bench(device, options);
      LUM_TRY_VOID(bench.prepare());
      LUM_TRY(const GiTask task, bench.task(static_cast<std::uint64_t>(seed)));
      LUM_TRY(GiRun run, bench.run(method, task, static_cast<std::uint64_t>(seed)));
      if (!start) {
        LUM_TRY(start, bench.judge(task.start, task.target));
      }
      LUM_TRY(run.epsilon, bench.judge(run.found, task.target));
      print_run(options, method, static_cast<std::uint64_t>(seed), *start, run);
      runs[method].push_back(std::move(run));
    }
  }
  print_results(options, methods, runs);
  return {};
}

}  // namespace luminist
