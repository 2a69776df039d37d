#pragma once
// render/param_state.h -- everything that can be turned in one shot: the rig, the style's parameters, the materials.
#include <string>
#include <string_view>
#include <vector>

#include "params/param_block.h"
#include "params/unit_map.h"
#include "rig/light_rig.h"
#include "scene/material_params.h"
#include "style/style.h"

namespace luminist {

struct ParamState {
  LightRig rig;
  ParamBlock style;
  std::vector<MaterialParams> materials = {};  ///< of the scene, all in its order; none: they are as it has them

  /// ambient, then the lights in rig order, then the style, then the materials: the order that a UnitMap of a state
  /// uses.
  [[nodiscard]] std::vector<ParamBlock*> blocks();
  [[nodiscard]] std::vector<const ParamBlock*> blocks() const;
  /// "ambient", "lights/<name>", "style", "materials/<name>": the prefix of a block's parameters.
  [[nodiscard]] std::vector<std::string> block_paths() const;
};

/// Index of a light's block in blocks(), from its index in the rig.
inline int light_block(int light) {
  return light + 1;
}

/// The index of the material in the state that a block of blocks() is of, or -1.
int material_of_block(const ParamState& state, int block);

/// The materials' values as bytes: equal for states whose surfaces scatter light alike. cost O(materials).
std::string material_bytes(const ParamState& state);

/// An empty rig, the style's defaults and no materials; every degree of freedom of ambient and style locked as the
/// schemas say.
ParamState initial_state(const LightTypes& types, const Style& style, const SceneFrame& frame);

/// Sets "lights/key/barn=0.3,0.3,0.1", "ambient/color=...", "style/threshold=...", "materials/jug/roughness=0.3".
/// errors kUsage: no '=', unknown path (with the nearest), bad value, or what follows another light.
Result<void> set_path(ParamState& state, std::string_view assignment);

/// "20 is outside the range 0 to 1": what is said of a parameter outside of its range; "" inside, for an unknown path
/// and where there is no range. Values out of range work as long as nobody solves for them.
std::string range_note(const ParamState& state, std::string_view path, const SceneFrame& frame);

/// Locks or unlocks what matches a pattern: "lights/key/color", "lights/*/position", "style/*", "*", or a group as
/// "group:fill/color"; a component as "lights/key/position.y"; all of a light or a group as "lights/key", "group:fill".
/// '*' stands for any run of characters. What follows another light is no degree of freedom, whatever its lock.
/// Materials are unlocked by their name only, as "materials/jug" or "materials/*/tint": "*" unlocks what light can do.
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
