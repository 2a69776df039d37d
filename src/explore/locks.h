#pragma once
// explore/locks.h -- who may turn what while lights are tried out.
#include <optional>

#include "render/param_state.h"

namespace luminist {

/// Whether the solver may turn anything of a light: it shines and a degree of freedom is unlocked.
bool is_free(const Light& light);

/// Who makes up for lights that are gone (no material does, whatever its locks): what is unlocked; or, where that is
/// nothing of any light because nobody has said what may turn, what the types of the lights leave to the solver.
enum class MakeUp { kUnlocked, kUnlockedOrByType };
ParamState with_free_lights(ParamState state, MakeUp who);

/// Of what is unlocked, only the colours of lights stay so; nothing if there are none.
std::optional<ParamState> with_only_colors_free(ParamState state);

/// The values of one state under the locks of another, which has the same blocks.
ParamState with_locks_of(ParamState values, const ParamState& locks);

}  // namespace luminist
