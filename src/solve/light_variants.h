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
  Vec3 focus{0.0F};         ///< where the picture counts on average
};

/// `count` variants of a state in which one block's unlocked parameters are others (colours stay: they are solved, or
/// descend by themselves).
///
/// If the light has a free position and direction, a third of them stand elsewhere around what it shines on and a third
/// shine at another place of the picture, with about the same footprint. The others, and the rest of the parameters of
/// many, are jittered by 3, 10 or 30 % of their ranges. All are within their ranges.
std::vector<ParamState> light_variants(const ParamState& state, int block, const LightPlaces& places,
                                       const SceneFrame& frame, int count, Random& random);

/// Variants that differ from a state in little, in groups of which the best is wanted, for what has no slope:
///
/// - each unlocked degree of freedom of one block, colours excepted, alone elsewhere in its range (a cutoff far beyond
///   the scene matters to no slope), around the state and around it with the rest of the manifest's group as in
///   `start`;
/// - one edge of a light's shape (role "shape", half sizes) moved: the light turns and narrows or widens at once, for
///   an edge outside the picture has no slope either. The same with one manifest group at a time as in `start` or as a
///   new light has it: cutoffs that do an edge's work hide where the edge belongs.
std::vector<std::vector<ParamState>> light_scans(const ParamState& state, const ParamState& start, int block,
                                                 const SceneFrame& frame);

/// The state with one block's values as they are in another state of the same rig.
ParamState with_block_of(const ParamState& state, const ParamState& from, int block);

/// The state with two lights in each other's place: what is unlocked in both has changed hands. Empty if they are not
/// of one type or share nothing unlocked.
std::vector<ParamState> light_exchange(const ParamState& state, int block, int other);

}  // namespace luminist
