#include "solve/solve_session.h"

#include <cmath>
#include <optional>
#include <utility>

#include "solve/fast_solver.h"
#include "solve/progress.h"
#include "solve/refinement.h"
#include "solve/sample_cells.h"
#include "solve/simplex_solver.h"

namespace luminist {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPaperSimplexSize = 0.1;    // of the paper's solver
constexpr double kInVain = 0.98;             // of the start's error, left
constexpr double kBlurredSimplexSize = 0.2;  // for a metric with plateaus

bool nothing_counts(const SurfaceBuffer& surface, const Target& target) {
  for (std::size_t pixel = 0; pixel < surface.pixels(); ++pixel) {
    if (surface.object[pixel] != 0 && target.importance.data[pixel] > 0.0F) return false;
  }
  return true;
}

/// "lights/key, style": the blocks whose locks leave nothing to turn. Materials are not looked for there.
std::string locked_blocks(const ParamState& state) {
  std::string names;
  const std::vector<const ParamBlock*> blocks = state.blocks();
  const std::vector<std::string> paths = state.block_paths();
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i]->schema().dofs() == 0 || material_of_block(state, static_cast<int>(i)) >= 0) continue;
    names += (names.empty() ? "" : ", ") + paths[i];
  }
  return names;
}

}  // namespace

class SolveSession::Impl {
 public:
  Impl(Renderer& renderer, ParamState start, Target target, const SolveOptions& options)
      : renderer_(&renderer), target_(std::move(target)), progress_(renderer, std::move(start), options) {}

  Result<void> begin(std::shared_ptr<const EdgeMask> edges) {
    if (progress_.options().solver == SolverKind::kSimplex) {
      use_simplex({.size = kPaperSimplexSize, .restarts = progress_.options().restarts});
      return {};
    }
    start_ = progress_.best();
    edges_ = edges;
    LUM_TRY(solver_, FastSolver::create(*renderer_, target_, progress_, std::move(edges)));
    progress_.name_solver("fast");
    progress_.tally();
    return {};
  }

  Result<bool> step() {
    if (!progress_.running()) return false;
    const Clock::time_point before = Clock::now();
    auto more = solver_->step();
    progress_.add_seconds(std::chrono::duration<double>(Clock::now() - before).count());
    if (!more) return more;
    if (progress_.running() && !*more) end_of_solver();
    if (!progress_.running() && !std::isfinite(progress_.report().epsilon)) {
      return Error{ErrorKind::kNumerical, "no picture with a finite error was seen", "", "",
                   "check the target and the lights for values that are not finite"};
    }
    return progress_.running();
  }

  Progress& progress() { return progress_; }
  [[nodiscard]] const Progress& progress() const { return progress_; }

 private:
  void use_simplex(const NelderMeadOptions& options) {
    solver_ = std::make_unique<SimplexSolver>(*renderer_, target_, progress_, options);
    progress_.name_solver("simplex");
    by_simplex_ = true;
  }

  /// Estimates are looked at more closely once; `auto` goes on with whole pictures where samples did not see what the
  /// metric sees: nothing came of them.
  void end_of_solver() {
    const SolveReport& report = progress_.report();
    const bool automatic = progress_.options().solver == SolverKind::kAuto;
    const bool refined = renderer_->estimates() && !start_;  // and the simplex would compare other paths
    const bool in_vain = !refined && report.epsilon > kInVain * report.epsilon_start;
    if (automatic && !by_simplex_ && renderer_->style().metric.blur > 0.0F && in_vain) {
      use_simplex({.size = kBlurredSimplexSize, .restarts = 2, .restart_gain = 0.01});
      return;
    }
    if (std::unique_ptr<Solver> closer = by_simplex_ ? nullptr : refinement(); closer) {
      solver_ = std::move(closer);
      return;
    }
    progress_.finish(Termination::kConverged);
  }

  /// Null where there is nothing to refine, or it was done.
  std::unique_ptr<Solver> refinement() {
    if (!start_ || progress_.options().max_evals - progress_.report().evals < Refinement::kPictures) return nullptr;
    ParamState start = *std::exchange(start_, std::nullopt);
    return Refinement::create(*renderer_, target_, progress_, std::move(start), edges_);
  }

  Renderer* renderer_;
  Target target_;
  Progress progress_;
  std::unique_ptr<Solver> solver_;
  bool by_simplex_ = false;
  std::optional<ParamState> start_;  ///< until what was found from it is refined
  std::shared_ptr<const EdgeMask> edges_;
};

SolveSession::SolveSession(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SolveSession::SolveSession(SolveSession&&) noexcept = default;
SolveSession& SolveSession::operator=(SolveSession&&) noexcept = default;
SolveSession::~SolveSession() = default;

Result<void> check_free(const ParamState& state, const SceneFrame& frame) {
  const std::vector<const ParamBlock*> blocks = state.blocks();
  if (UnitMap::create(blocks, frame).dofs() > 0) return {};
  return Error{ErrorKind::kNothingToDo, "everything is locked", "", locked_blocks(state),
               "unlock what may change, or add a light"};
}

Result<SolveSession> SolveSession::create(Renderer& renderer, ParamState start, Target target,
                                          const SolveOptions& options, std::shared_ptr<const EdgeMask> edges) {
  keep_constraints(start.rig);
  LUM_TRY_VOID(check_free(start, renderer.frame()));
  sanitize(target);
  if (nothing_counts(renderer.surface(), target)) {
    return Error{ErrorKind::kNothingToDo, "nothing counts: the importance is zero wherever something is visible", "",
                 "importance", "paint, or give unpainted pixels some weight"};
  }
  auto impl = std::make_unique<Impl>(renderer, std::move(start), std::move(target), options);
  LUM_TRY_VOID(impl->begin(std::move(edges)));
  return SolveSession(std::move(impl));
}

Result<bool> SolveSession::step() {
  return impl_->step();
}

Result<bool> SolveSession::run_for(std::chrono::milliseconds slice) {
  const Clock::time_point end = Clock::now() + slice;
  while (true) {
    LUM_TRY(const bool more, step());
    if (!more) return false;
    if (Clock::now() >= end) return true;
  }
}

void SolveSession::stop() {
  impl_->progress().finish(Termination::kStopped);
}

const ParamState& SolveSession::best() const {
  return impl_->progress().best();
}

const SolveReport& SolveSession::report() const {
  return impl_->progress().report();
}

const char* to_string(Termination termination) {
  switch (termination) {
    case Termination::kRunning:
      return "running";
    case Termination::kTargetReached:
      return "target_reached";
    case Termination::kConverged:
      return "converged";
    case Termination::kEvalLimit:
      return "eval_limit";
    case Termination::kStopped:
      return "stopped";
  }
  return "running";
}

}  // namespace luminist
