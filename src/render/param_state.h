#pragma once
// render/param_state.h -- everything that can be turned in one shot: the rig and the style's parameters.
#include <string>
#include <string_view>
#include <vector>

#include "params/param_block.h"
#include "params/unit_map.h"
#include "rig/light_rig.h"
#include "style/style.h"

namespace luminist {

struct ParamState {
  LightRig rig;
  ParamBlock style;

  /// ambient, then the lights in rig order, then the style: the order that a UnitMap of a state uses.
  [[nodiscard]] std::vector<ParamBlock*> blocks();
  [[nodiscard]] std::vector<const ParamBlock*> blocks() const;
  /// "ambient", "lights/<name>", "style": the prefix of a block's parameters.
  [[nodiscard]] std::vector<std::string> block_paths() const;
};

/// Index of a light's block in blocks(), from its index in the rig.
inline int light_block(int light) {
  return light + 1;
}

/// An empty rig and the style's defaults; every degree of freedom of ambient and style locked as the schemas say.
ParamState initial_state(const LightTypes& types, const Style& style, const SceneFrame& frame);

/// Sets "lights/key/barn=0.3,0.3,0.1", "ambient/color=...", "style/threshold=...".
/// errors kUsage: no '=', unknown path (with the nearest), bad value, or what follows another light.
Result<void> set_path(ParamState& state, std::string_view assignment);

/// "20 is outside the range 0 to 1": what is said of a parameter outside of its range; "" inside, for an unknown path
/// and where there is no range. Values out of range work as long as nobody solves for them.
std::string range_note(const ParamState& state, std::string_view path, const SceneFrame& frame);

/// Locks or unlocks what matches a pattern: "lights/key/color", "lights/*/position", "style/*", "*", or a group as
/// "group:fill/color"; a component as "lights/key/position.y"; all of a light or a group as "lights/key", "group:fill".
/// '*' stands for any run of characters. What follows another light is no degree of freedom, whatever its lock.
/// returns the number of degrees of freedom that matched. errors kUsage if none did (with the nearest path).
Result<int> set_locked(ParamState& state, std::string_view pattern, bool locked);

/// A parameter, or one of its numbers: its block of blocks(), and its place in the schema.
struct ParamPlace {
  std::size_t block = 0;
  int param = 0;
  int component = -1;  ///< -1: all of it
};
/// What a pattern as of set_locked() names, and numbers of it that can have keys (keys_by_component()) as
/// "lights/key/position.y". errors kUsage if it names none (with the nearest).
Result<std::vector<ParamPlace>> params_matching(const ParamState& state, std::string_view pattern);

/// Names of the unlocked degrees of freedom in UnitMap order: "lights/key/position.x", "lights/key/direction.u" ...
std::vector<std::string> dof_names(const ParamState& state, const UnitMap& map);

}  // namespace luminist
