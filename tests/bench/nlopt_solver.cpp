#include "bench/nlopt_solver.h"

#include <nlopt.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>

#include "solve/objective.h"

namespace luminist {
namespace {

constexpr double kFirstStep = 0.1;
constexpr double kTolerance = 1e-4;  // relative, of epsilon: that of the simplex
constexpr double kGain = 1e-3;       // a start from the minimum that gains less ends it
constexpr double kWorst = 1e6;       // stands for an infinite epsilon, which BOBYQA's parabolas cannot hold

struct NloptCloser {
  void operator()(nlopt_opt_s* opt) const { nlopt_destroy(opt); }
};

/// What the callback needs to know.
struct Search {
  Objective objective;
  Progress* progress;
  const std::function<void()>* watch;
  nlopt_opt_s* opt = nullptr;
  std::optional<Error> error = std::nullopt;
};

double evaluate(unsigned count, const double* x, double* /*gradient*/, void* data) {
  Search& search = *static_cast<Search*>(data);
  const std::span<const double> point(x, count);
  const auto epsilon = search.objective.evaluate(point);
  if (!epsilon) {
    search.error = epsilon.error();
    nlopt_force_stop(search.opt);
    return kWorst;
  }
  search.progress->record(search.objective.state(point), *epsilon);
  (*search.watch)();
  if (!search.progress->running()) nlopt_force_stop(search.opt);
  return std::min(*epsilon, kWorst);
}

/// One search from the best so far.
Result<void> descend(Search& search, NloptAlgorithm algorithm) {
  search.objective.recentre(search.progress->best());
  std::vector<double> x = search.objective.unit(search.progress->best());
  for (double& number : x) number = std::clamp(number, 0.0, 1.0);
  const auto count = static_cast<unsigned>(x.size());
  const std::unique_ptr<nlopt_opt_s, NloptCloser> opt(
      nlopt_create(algorithm == NloptAlgorithm::kBobyqa ? NLOPT_LN_BOBYQA : NLOPT_LN_NELDERMEAD, count));
  LUM_CHECK(opt != nullptr, "NLopt has these methods");
  search.opt = opt.get();
  nlopt_set_min_objective(opt.get(), evaluate, &search);
  nlopt_set_lower_bounds1(opt.get(), 0.0);
  nlopt_set_upper_bounds1(opt.get(), 1.0);
  nlopt_set_initial_step1(opt.get(), kFirstStep);
  nlopt_set_ftol_rel(opt.get(), kTolerance);
  double least = 0.0;
  const nlopt_result result = nlopt_optimize(opt.get(), x.data(), &least);
  if (search.error) return *search.error;
  LUM_CHECK(result != NLOPT_INVALID_ARGS && result != NLOPT_OUT_OF_MEMORY, "the search was set up rightly");
  return {};
}

}  // namespace

Result<void> solve_by_nlopt(Renderer& renderer, const Target& target, Progress& progress, NloptAlgorithm algorithm,
                            const std::function<void()>& watch) {
  Search search{Objective(renderer, progress.best(), target), &progress, &watch};
  const ParamState start = progress.best();
  LUM_TRY(const double epsilon, search.objective.evaluate(search.objective.unit(start)));
  progress.record(start, epsilon);
  for (bool first = true; progress.running(); first = false) {
    const double before = progress.report().epsilon;
    LUM_TRY_VOID(descend(search, algorithm));
    if (!first && progress.report().epsilon > (1.0 - kGain) * before) progress.finish(Termination::kConverged);
  }
  return {};
}

}  // namespace luminist
