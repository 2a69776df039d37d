#pragma once
// tests/bench/nlopt_solver.h -- NLopt's derivative-free methods on whole pictures: baselines made by others.
#include <functional>

#include "render/renderer.h"
#include "solve/progress.h"

namespace luminist {

enum class NloptAlgorithm { kNelderMead, kBobyqa };

/// Minimizes the objective of the progress's best state within the unit cube, first step 0.1 as the simplex, until the
/// progress ends by its options. A minimum is started from again, directions charted around it, until that gains
/// nothing: then it has converged. watch is called after every picture. errors the renderer's.
/// source NLopt 2.7 (Johnson): LN_NELDERMEAD (Box 1965 and Richardson and Kuester 1973 for the bounds), LN_BOBYQA
/// (Powell 2009).
Result<void> solve_by_nlopt(Renderer& renderer, const Target& target, Progress& progress, NloptAlgorithm algorithm,
                            const std::function<void()>& watch);

}  // namespace luminist
