#pragma once
// tests/solve/degenerate_problem.h -- problems that nobody would pose on purpose, drawn at random.
#include <string>

#include "render/renderer.h"
#include "solve/random.h"
#include "solve/solve_session.h"

namespace luminist {

struct DegenerateProblem {
  ParamState start;
  Target target;
  SolveOptions options;
  int steps = 0;     ///< after which it is stopped
  std::string what;  ///< what is wrong with it, for messages
  bool all_locked = false;
};

/// Lights that no lighter would leave so: inside objects, behind the wall, below the floor, at a surface, at the eye,
/// far away; of no size, no colour, crossed cutoffs, extreme exponents; muted, doubled, sharing the shadow of one of
/// them, or none at all; values far out of their ranges. Any locks, at least one degree of freedom unlocked. Appends to
/// what.
ParamState degenerate_lights(const ParamState& empty, const Light& prototype, const SurfaceBuffer& surface,
                             const SceneFrame& frame, Random& random, std::string& what);

/// Paint on a picture that cannot be matched or says nothing: none, stripes that contradict each other, noise, far too
/// bright, negative, pixels that are no numbers; importance zero in places, everywhere, negative or no number.
/// Appends to what.
void degenerate_paint(Target& target, Random& random, std::string& what);

/// All of that on an engine, from a rig without lights in its style. Same seed, same problem. errors the renderer's.
Result<DegenerateProblem> degenerate_problem(Renderer& renderer, const ParamState& empty, const Light& prototype,
                                             std::uint64_t seed);

/// What holds of any solve that has ended, whatever it was given.
void expect_sound(Renderer& renderer, const SolveSession& session, const DegenerateProblem& problem);

/// True if anything visible has importance once what is no number is masked.
bool counts_somewhere(const SurfaceBuffer& surface, Target target);

/// Solves a problem, or sees it refused for the right reason.
void solve_degenerate(Renderer& renderer, const DegenerateProblem& problem);

}  // namespace luminist
