#pragma once
// tests/bench/perturbation.h -- lights that are moved away from where they belong (paper, section 6: Table I).
#include <span>
#include <string_view>
#include <vector>

#include "render/renderer.h"
#include "solve/random.h"

namespace luminist {

/// How far a degree of freedom moves, as a share of its range.
struct PerturbReach {
  double least = 0.1;
  double most = 0.5;
};

/// A part of [0,1], of one degree of freedom.
struct UnitRange {
  double low = 0.0;
  double high = 1.0;
};

/// Unlocks the parameters of a light that have one of the roles, and nothing that is a quality.
void unlock_roles(Light& light, std::span<const std::string_view> roles);

/// The useful range of every unlocked degree of freedom of the lights, in UnitMap order: the part of [0,1] around the
/// present value in which turning it alone changes the picture by at most half of what taking its light away does.
/// Beyond that the light no longer does its work. All of [0,1] for what is no light's. The ends are exact to a 1/1000
/// of [0,1] near the value and to a sixteenth of their distance from it. errors the renderer's. cost about 20 pictures
/// each.
Result<std::vector<UnitRange>> useful_ranges(Renderer& renderer, const ParamState& original);

/// Moves every unlocked degree of freedom by a share in `reach` of its range, up or down by chance, and the other way
/// where it would leave its range. Deterministic. ranges [dofs].
ParamState perturbed(const ParamState& original, const SceneFrame& frame, std::span<const UnitRange> ranges,
                     const PerturbReach& reach, Random& random);

}  // namespace luminist
