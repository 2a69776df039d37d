#include "bench/method.h"

#include <algorithm>
#include <array>
#include <chrono>

#include <fmt/format.h>

#include "bench/nlopt_solver.h"
#include "explore/locks.h"
#include "solve/objective.h"
#include "solve/progress.h"

namespace luminist {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Work since it was made, in full pictures of one rig.
class Account {
 public:
  Account(const Renderer& renderer, const ParamState& state) : renderer_(&renderer), before_(renderer.work()) {
    const auto& lights = state.rig.lights;
    const auto lit = std::count_if(lights.begin(), lights.end(), [](const Light& light) { return !light.muted; });
    picture_ = 2.0 * static_cast<double>(renderer.surface().pixels()) * std::max<double>(1.0, static_cast<double>(lit));
  }
  [[nodiscard]] double equivalents() const {
    const WorkCount& now = renderer_->work();
    return (now.shades - before_.shades + now.shadow_queries - before_.shadow_queries) / picture_;
  }

 private:
  const Renderer* renderer_;
  WorkCount before_;
  double picture_ = 1.0;
};

/// The same engine without the sum it keeps of the lights that do not move: in the paper "a full rendering of the
/// scene" is compared each time (section 5), and a black box knows no lights.
class WholePictures final : public Renderer {
 public:
  explicit WholePictures(Renderer& engine) : engine_(&engine) {}
  [[nodiscard]] const SurfaceBuffer& surface() const override { return engine_->surface(); }
  [[nodiscard]] SceneFrame frame() const override { return engine_->frame(); }
  [[nodiscard]] const Style& style() const override { return engine_->style(); }
  [[nodiscard]] bool estimates() const override { return engine_->estimates(); }
  Result<Image> render(const ParamState& state, const RenderOptions& options) override {
    return engine_->render(state, options);
  }
  Result<double> error(const ParamState& state, const Target& target) override { return engine_->error(state, target); }
  Result<double> error(const ParamState& state, const Target& target, std::span<const int> /*moving*/) override {
    return engine_->error(state, target);
  }
  Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                        std::span<Vec3> out) override {
    return engine_->evaluate(candidates, samples, softness, out);
  }
  [[nodiscard]] const WorkCount& work() const override { return engine_->work(); }

 private:
  Renderer* engine_;
};

/// Watches a solve from outside: when it got better first, and when it reached the goal.
class Watch {
 public:
  Watch(const Renderer& renderer, const BenchTask& task) : account_(renderer, task.start), goal_(task.goal) {}

  void look(const SolveReport& report) {
    if (report.evals == 0) return;
    const double now = seconds_since(begin_);
    if (run_.first_seconds == 0.0 && report.epsilon < report.epsilon_start) run_.first_seconds = now;
    if (run_.success) return;
    run_.success = report.epsilon <= goal_;
    run_.evals = report.evals;
    run_.equivalents = account_.equivalents();
    run_.seconds = now;
  }
  /// What came before the method's own clock.
  void prepared() { prepared_ = seconds_since(begin_); }
  [[nodiscard]] double equivalents() const { return account_.equivalents(); }

  BenchRun finish(const SolveReport& report, bool capped) {
    look(report);
    if (!run_.success) run_.equivalents = account_.equivalents(), run_.seconds = seconds_since(begin_);
    run_.capped = capped;
    run_.epsilon_start = report.epsilon_start;
    run_.epsilon = report.epsilon;
    run_.goal = goal_;
    run_.total_equivalents = account_.equivalents();
    run_.total_seconds = seconds_since(begin_);
    run_.convergence = report.convergence;
    for (ConvergencePoint& point : run_.convergence) point.seconds += prepared_;
    return run_;
  }

 private:
  Account account_;
  double goal_;
  BenchRun run_;
  double prepared_ = 0.0;
  Clock::time_point begin_ = Clock::now();
};

SolveOptions solve_options(const BenchTask& task, Method method, const MethodCaps& caps, std::uint64_t seed) {
  SolveOptions options;
  options.solver = method == Method::kFast ? SolverKind::kFast : SolverKind::kSimplex;
  options.seed = seed;
  if (task.stated) options.until = task.goal;
  if (method != Method::kFast) options.max_evals = caps.max_evals;
  return options;
}

Result<BenchRun> run_session(Renderer& renderer, const BenchTask& task, Method method, const MethodCaps& caps,
                             std::uint64_t seed, ParamState* best) {
  // The renderer keeps what lights add that do not move. A run pays for that itself: an error for which no light moves
  // leaves it something else.
  LUM_TRY_VOID(renderer.error(task.start, task.target, std::span<const int>()));
  Watch watch(renderer, task);
  LUM_TRY(SolveSession session,
          SolveSession::create(renderer, task.start, task.target, solve_options(task, method, caps, seed)));
  watch.prepared();
  bool capped = false;
  while (!capped) {
    LUM_TRY(const bool more, session.step());
    watch.look(session.report());
    if (!more) break;
    capped = method == Method::kFast && watch.equivalents() > caps.max_equivalents;
  }
  session.stop();
  if (best != nullptr) *best = session.best();
  capped = capped || session.report().termination == Termination::kEvalLimit;
  return watch.finish(session.report(), capped);
}

Result<BenchRun> run_nlopt(Renderer& renderer, const BenchTask& task, Method method, const MethodCaps& caps,
                           std::uint64_t seed, ParamState* best) {
  Watch watch(renderer, task);
  Progress progress(renderer, task.start, solve_options(task, method, caps, seed));
  const NloptAlgorithm algorithm =
      method == Method::kNloptBobyqa ? NloptAlgorithm::kBobyqa : NloptAlgorithm::kNelderMead;
  LUM_TRY_VOID(solve_by_nlopt(renderer, task.target, progress, algorithm, [&] { watch.look(progress.report()); }));
  if (best != nullptr) *best = progress.best();
  return watch.finish(progress.report(), progress.report().termination == Termination::kEvalLimit);
}

}  // namespace

std::span<const std::string> method_words() {
  static const std::array<std::string, 4> words{"fast", "simplex", "nlopt_nelder_mead", "nlopt_bobyqa"};
  return words;
}

const std::string& to_word(Method method) {
  return method_words()[static_cast<std::size_t>(method)];
}

std::string MethodCaps::text(Method method) const {
  return method == Method::kFast ? fmt::format("{:g} RE", max_equivalents) : fmt::format("{} evals", max_evals);
}

Result<BenchRun> run_method(Renderer& renderer, const BenchTask& task, Method method, const MethodCaps& caps,
                            std::uint64_t seed, ParamState* best) {
  WholePictures whole(renderer);
  const auto search = [&]() -> Result<BenchRun> {
    if (method == Method::kFast) return run_session(renderer, task, method, caps, seed, best);
    if (method == Method::kSimplex) return run_session(whole, task, method, caps, seed, best);
    return run_nlopt(whole, task, method, caps, seed, best);
  };
  LUM_TRY(BenchRun run, search());
  run.lights = free_lights(task.start);
  run.dofs = free_dofs(task.start, renderer.frame());
  return run;
}

Result<double> time_evaluation(Renderer& renderer, const BenchTask& task) {
  constexpr double kStep = 0.01;  // of every range
  Objective objective(renderer, task.start, task.target);
  std::vector<double> x = objective.unit(task.start);
  std::array<double, 3> seconds{};
  for (double& each : seconds) {
    for (double& number : x) number += number < 0.5 ? kStep : -kStep;
    const Clock::time_point begin = Clock::now();
    LUM_TRY([[maybe_unused]] const double epsilon, objective.evaluate(x));
    each = seconds_since(begin);
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[1];
}

int free_lights(const ParamState& state) {
  return static_cast<int>(std::count_if(state.rig.lights.begin(), state.rig.lights.end(), is_free));
}

std::vector<std::string> free_names(const ParamState& state, const SceneFrame& frame) {
  const std::vector<const ParamBlock*> blocks = state.blocks();
  return dof_names(state, UnitMap::create(blocks, frame));
}

int free_dofs(const ParamState& state, const SceneFrame& frame) {
  const std::vector<const ParamBlock*> blocks = state.blocks();
  return UnitMap::create(blocks, frame).dofs();
}

}  // namespace luminist
