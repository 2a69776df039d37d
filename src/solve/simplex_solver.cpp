#include "solve/simplex_solver.h"

namespace luminist {

SimplexSolver::SimplexSolver(Renderer& renderer, const Target& target, Progress& progress,
                             const NelderMeadOptions& options)
    : progress_(&progress),
      objective_(renderer, progress.best(), target),
      simplex_(objective_.unit(progress.best()), options) {}

Result<bool> SimplexSolver::step() {
  const std::vector<double> x = simplex_.point();
  LUM_TRY(const double epsilon, objective_.evaluate(x));
  progress_->record(objective_.state(x), epsilon, penalty(x));
  simplex_.tell(epsilon);
  if (simplex_.restarted()) {
    const ParamState minimum = objective_.state(simplex_.best());
    objective_.recentre(minimum);
    simplex_.recentre(objective_.unit(minimum));
  }
  return !simplex_.done();
}

}  // namespace luminist
