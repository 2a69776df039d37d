#pragma once
// solve/solve_session.h -- one solve, in steps: stopped, continued or cancelled at any time, never worse than its
// start.
#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "solve/sample_cells.h"

namespace luminist {

enum class SolverKind { kAuto, kFast, kSimplex };

struct SolveOptions {
  SolverKind solver = SolverKind::kAuto;
  std::uint64_t seed = 1;
  double until = 0.0;                               ///< stop when epsilon (with penalty) is at most this
  int max_evals = std::numeric_limits<int>::max();  ///< full pictures compared
  int restarts = -1;  ///< -1: the solver's own stop rule; the simplex restarts until halted
};

enum class Termination { kRunning, kTargetReached, kConverged, kEvalLimit, kStopped };

/// A point of the convergence plot.
struct ConvergencePoint {
  double render_equivalents = 0.0;
  int evals = 0;
  double seconds = 0.0;  ///< inside the session; reported, never decided on
  double epsilon = 0.0;  ///< best so far, on the full picture
};

struct SolveReport {
  /// Infinite until the start was compared. Both are told anew once estimates are compared more exactly (refinement.h).
  double epsilon_start = std::numeric_limits<double>::infinity();
  double epsilon = std::numeric_limits<double>::infinity();
  double penalty_start = 0.0;       ///< what parameters outside their ranges add to epsilon_start
  double penalty = 0.0;             ///< and to epsilon
  int evals = 0;                    ///< full pictures compared
  double render_equivalents = 0.0;  ///< all work over that of one full picture of the starting rig
  double seconds = 0.0;
  std::string solver;  ///< what ran: "fast" or "simplex"
  Termination termination = Termination::kRunning;
  std::vector<ConvergencePoint> convergence;

  /// How far the pictures are from the target, whatever the ranges: what is told to whoever painted it.
  [[nodiscard]] double error_start() const { return epsilon_start - penalty_start; }
  [[nodiscard]] double error() const { return epsilon - penalty; }
  /// Whether a number is outside its range by more than the rounding of what is stored.
  [[nodiscard]] bool outside() const { return penalty > 1e-5; }
};

/// errors kNothingToDo if everything is locked (names the locks).
Result<void> check_free(const ParamState& state, const SceneFrame& frame);

/// thread: the renderer's. The renderer must outlive the session.
class SolveSession {
 public:
  /// Turns the unlocked degrees of freedom of start; its constraints hold in everything that is found.
  /// edges: edge_pixels() of the renderer's surface, null to have it made. errors kNothingToDo: everything locked
  /// (names the locks), the importance is zero everywhere; the renderer's.
  static Result<SolveSession> create(Renderer& renderer, ParamState start, Target target, const SolveOptions& options,
                                     std::shared_ptr<const EdgeMask> edges = nullptr);
  SolveSession(SolveSession&&) noexcept;
  SolveSession& operator=(SolveSession&&) noexcept;
  ~SolveSession();

  /// One step: an evaluation of the simplex, an iteration of the fast solver. returns false when it is done.
  /// errors the renderer's; kNumerical if no finite epsilon was ever seen. The best so far stays.
  Result<bool> step();
  /// Steps until done or the slice is over (at least one step).
  Result<bool> run_for(std::chrono::milliseconds slice);
  /// Ends a running session: termination becomes kStopped.
  void stop();

  [[nodiscard]] const ParamState& best() const;
  [[nodiscard]] const SolveReport& report() const;

 private:
  class Impl;
  explicit SolveSession(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// The word of the report's JSON for a termination.
const char* to_string(Termination termination);

}  // namespace luminist
