#pragma once
// solve/progress.h -- what solvers of a session share: the best picture so far, the account, and when to end.
#include <limits>

#include "solve/objective.h"
#include "solve/solve_session.h"

namespace luminist {

/// Counts full pictures and work, keeps the best state, ends a solve by the options. thread: the renderer's.
class Progress {
 public:
  Progress(const Renderer& renderer, ParamState start, const SolveOptions& options);

  /// A full picture of `state` was compared: epsilon with penalty. The first one is the start's.
  void record(const ParamState& state, double epsilon);
  /// The same with a penalty that also counts how far directions have turned.
  void record(const ParamState& state, double epsilon, double penalty);
  /// A full picture was compared in another way than those of record().
  void count() { ++report_.evals; }
  /// A state is better than the best, by a closer look than the errors that are told. No picture more.
  void improve(const ParamState& state, double epsilon);
  /// Ends the solve; the first reason stays.
  void finish(Termination termination);
  /// Brings the account of work up to date.
  void tally();
  void add_seconds(double seconds) { report_.seconds += seconds; }
  void name_solver(const char* name) { report_.solver = name; }

  [[nodiscard]] bool running() const { return report_.termination == Termination::kRunning; }
  [[nodiscard]] const ParamState& best() const { return best_; }
  [[nodiscard]] const SolveReport& report() const { return report_; }
  [[nodiscard]] const SolveOptions& options() const { return options_; }

 private:
  const Renderer* renderer_;
  SolveOptions options_;
  ParamState best_;
  SolveReport report_;
  WorkCount work_before_;
  double picture_work_ = 1.0;  ///< shades and shadow queries of one full picture of the starting rig
};

/// One way to search. step() returns false when it has come to its own end.
class Solver {
 public:
  Solver() = default;
  virtual ~Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual Result<bool> step() = 0;
};

}  // namespace luminist
