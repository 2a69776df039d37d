#pragma once
// solve/light_variants.h -- other places and shapes for one light, drawn at random: where restarts begin.
#include <span>
#include <vector>

#include "render/param_state.h"
#include "solve/random.h"

namespace luminist {

/// What a light may be wanted for: places of the picture, each with a say.
struct LightPlaces {
  std::span<const Vec3> position;  ///< world
  std::span<const Vec3> normal;
  std::vector<double> say;  ///< >= 0, of any sum
};

/// `count` variants of a state in which one block's unlocked parameters are others (colours stay: they are solved).
///
/// Half of them, if the light has a free position and direction, stand somewhere around a place of the picture and
/// shine at it; the rest jitter the present values by 3, 10 or 30 % of their ranges. All are within their ranges.
std::vector<ParamState> light_variants(const ParamState& state, int block, const LightPlaces& places,
                                       const SceneFrame& frame, int count, Random& random);

}  // namespace luminist
