#pragma once
// solve/simplex_solver.h -- the solver of the paper: the simplex on whole pictures, restarted until halted.
#include "solve/nelder_mead.h"
#include "solve/progress.h"

namespace luminist {

/// One full picture a step. A restart charts directions around the minimum. The progress must outlive it.
class SimplexSolver final : public Solver {
 public:
  SimplexSolver(Renderer& renderer, const Target& target, Progress& progress, const NelderMeadOptions& options);
  Result<bool> step() override;

 private:
  Progress* progress_;
  Objective objective_;
  NelderMead simplex_;
};

}  // namespace luminist
