#pragma once
// studio/shared_solve.h -- one rig for several sessions at once, each with a picture, a style and paint of its own.
#include <chrono>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "render/views.h"
#include "studio/session.h"

namespace luminist {

/// A solve of what the sessions want together: the mean of their errors, weighted. The rig is one, with the locks and
/// constraints of the first session's; every style has its own parameters (sessions of one style share them). The
/// sessions stay as they are. They outlive the solve. thread the device's.
class SharedSolve {
 public:
  /// weights [sessions] > 0. errors kNothingToDo: nothing painted in one of them, everything locked, nothing counts;
  /// those of Views::create().
  static Result<SharedSolve> create(std::span<Session* const> sessions, std::span<const double> weights,
                                    const SolveOptions& options);

  /// The same of views that are ready, from a rig with its locks and constraints. What the views point to outlives it.
  static Result<SharedSolve> create(std::vector<View> views, const LightRig& rig, const SolveOptions& options);

  /// As SolveSession. errors the engines'.
  Result<bool> run_for(std::chrono::milliseconds slice) { return solve_->run_for(slice); }
  void stop() { solve_->stop(); }
  /// Of the mean of all errors; work in pictures of all sessions.
  [[nodiscard]] const SolveReport& report() const { return solve_->report(); }

  [[nodiscard]] const LightRig& rig() const { return solve_->best().rig; }
  /// The rig with the style of one session.
  [[nodiscard]] ParamState state(std::size_t session) const;
  struct Errors {
    double start = 0.0;
    double found = 0.0;
  };
  /// Of one session, without penalties. errors the engine's. cost two pictures.
  Result<Errors> errors(std::size_t session);

 private:
  SharedSolve(std::unique_ptr<Views> views, ParamState start) : views_(std::move(views)), start_(std::move(start)) {}

  std::unique_ptr<Views> views_;
  ParamState start_;
  std::optional<SolveSession> solve_;
};

}  // namespace luminist
