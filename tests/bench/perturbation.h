#pragma once
// tests/bench/perturbation.h -- lights that are moved away from where they belong (paper, section 6: Table I).
#include <span>
#include <string>
#include <string_view>

#include "render/param_state.h"
#include "solve/random.h"

namespace luminist {

/// How far a degree of freedom moves, as a share of its useful range. The useful range is the manifest's: what the
/// solver's [0,1] stands for; of a direction, the angles around the original one.
struct PerturbReach {
  double least = 0.1;
  double most = 0.5;
};

/// "full": the paper's 10 to 50 %. "small": a quarter of that.
PerturbReach full_reach();
PerturbReach small_reach();

/// Unlocks the parameters of a light that have one of the roles, and nothing that is a quality.
void unlock_roles(Light& light, std::span<const std::string_view> roles);

/// Moves every unlocked degree of freedom by a share in `reach` of its range, up or down by chance, and the other way
/// where it would leave [0,1]. Deterministic.
ParamState perturbed(const ParamState& original, const SceneFrame& frame, const PerturbReach& reach, Random& random);

}  // namespace luminist
