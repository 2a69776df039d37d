#pragma once
// rig/light_rig.h -- the lights of a shot.
#include <string>
#include <string_view>
#include <vector>

#include "base/math.h"
#include "params/param_block.h"
#include "rig/constraint.h"
#include "rig/keyframes.h"
#include "rig/light_type.h"
#include "scene/scene.h"

namespace luminist {

struct Light {
  std::string name;  ///< unique in the rig
  std::string type;  ///< a LightType's name
  std::string group;
  bool muted = false;
  ParamBlock params;
  std::vector<std::string> objects = {};  ///< patterns of the objects that it lights (rig/light_links.h); empty: all
};

struct LightRig {
  ParamBlock ambient;
  std::vector<Light> lights;
  std::string shadow_light;             ///< all lights use this light's shadow map; empty: each its own
  std::vector<Constraint> constraints;  ///< kept by keep_constraints()
  std::vector<KeyTrack> keys;           ///< what changes over frames; the parameters are as at one of them

  [[nodiscard]] Light* find(const std::string& name);
  [[nodiscard]] const Light* find(const std::string& name) const;
  /// "name", or "name-2", "name-3"... if it is taken.
  [[nodiscard]] std::string unused_name(const std::string& wanted) const;
};

/// What the paths of its parameters begin with: "lights/key"; of no name, the ambient light.
std::string light_path(const std::string& name);

/// Whether a text can name a light or a group: 1 to 255 bytes without control characters, '/', '*', '=' and ':', which
/// mean something in the paths of parameters.
bool is_light_name(std::string_view name);

/// No lights, the ambient's default. thread any.
LightRig empty_rig(const LightTypes& types, const SceneFrame& frame);

/// A light with its type's defaults. errors kUsage for an unknown type (with the nearest name) or a bad name.
Result<Light> make_light(const LightTypes& types, const std::string& type, const std::string& name,
                         const SceneFrame& frame);

/// A rig file: TOML, `shadow_light`, [ambient], [[light]] tables with name, type, group, muted, `objects =
/// ["creature*"]` (what the light lights; whether such objects exist is check_links()'s to say) and the parameters by
/// their manifest names; `unlocked = ["color", ...]` where a saved rig differs from the schema's own choice;
/// [[key]] tables as of read_keys(); [[constraint]] tables with `light` and one of `on_plane = {point, normal}`,
/// `at_distance = {distance, from}`, `mirror_of = {light, point, normal}` and `same_color = {light, factor}`, which are
/// kept in the rig that is returned. errors kMissing; kBadContent at path:line:col with the nearest valid key,
/// kBadContent for two lights of one name and for what find_fault() finds.
Result<LightRig> load_rig(const std::string& path, const LightTypes& types, const SceneFrame& frame);
Result<LightRig> parse_rig(const std::string& toml, const std::string& path, const LightTypes& types,
                           const SceneFrame& frame);
/// The same file, by hand readable; numbers written so that they read back to the same bits, in any locale.
std::string rig_to_toml(const LightRig& rig);
/// errors kUnwritable; kNumerical for a number that is not finite.
Result<void> save_rig(const LightRig& rig, const std::string& path);

/// Lights of a glTF scene: spots as cinematic lights, points and suns as what they are. A spot or point keeps its
/// position; its falloff is quadratic and its colour such that a white diffuser that faces it at the scene's centre has
/// the radiance I / (pi d^2). A sun's colour is E / pi. Names are made unique, characters that a name cannot hold
/// become
/// '_'. errors kUsage if there are no lights of these types.
Result<std::vector<Light>> from_punctual(const std::vector<PunctualLight>& lights, const LightTypes& types,
                                         const SceneFrame& frame);

/// Lights that stand where the scene has them go where it has them at another moment. before, after: the scene's lights
/// at the two, as from_punctual() makes them, in the same order. A light of the rig is the scene's if it has the name
/// and type of one, stands and points as that does before, bit for bit, and has no keys of its place: what the lighter
/// moved or keyed is the lighter's. returns whether one went anywhere.
bool follow_scene(LightRig& rig, const std::vector<Light>& before, const std::vector<Light>& after);

}  // namespace luminist
