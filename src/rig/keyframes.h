#pragma once
// rig/keyframes.h -- lights that change over frames: keys of parameters or of their numbers, and the rig at one frame.
#include <array>
#include <span>
#include <string>
#include <vector>

#include "params/toml_reader.h"

namespace luminist {

class ParamBlock;
struct LightRig;
struct ParamSpec;

/// How a value goes on to that of the next key.
enum class KeyInterpolation {
  kStep,    ///< it stays, and jumps
  kLinear,  ///< directions along the great circle, colours as light adds: in linear RGB
  kSmooth,  ///< without kinks at keys and without leaving the range between two (Steffen 1990)
};
/// "step", "linear", "smooth".
std::span<const std::string> key_interpolation_words();

struct Key {
  double frame = 0.0;
  KeyInterpolation interpolation = KeyInterpolation::kSmooth;
  std::array<double, 3> value{};  ///< the stored numbers of the parameter, in its components
};

/// One parameter over time, or one of its numbers. Before its first and after its last key it stands still. Ints, bools
/// and choices step.
///
/// Numbers of a vec2, vec3 or colour may be keyed alone, because each goes its own way between two keys. A direction is
/// keyed as a whole: what it goes along is a great circle. A parameter has one track for all of it or tracks for its
/// numbers, never both: a key of one number turns a whole track into one for each, which makes the same curve.
struct KeyTrack {
  std::string light;      ///< name; empty: the ambient
  std::string param;      ///< name in the schema
  std::vector<Key> keys;  ///< ascending frames, at least one
  int component = -1;     ///< -1: all of the parameter; else Key::value[0] is that number of it
};

/// What a key is of. component: -1 for all of the parameter.
struct KeyPlace {
  std::string light;  ///< empty: the ambient
  int param = 0;
  int component = -1;
};

/// Whether single numbers of a parameter can have keys.
bool keys_by_component(const ParamSpec& spec);

/// Sets what has keys to its value at a frame, then keeps the constraints. Tracks of lights and parameters that are
/// not there are passed over. cost O(keys). thread any.
void pose(LightRig& rig, double frame);

// Edits. The light, the parameter and the component exist (LUM_CHECK). A place that names all of a parameter means each
// of its tracks.

/// A key for what is there now, in place of one at that frame.
void set_key(LightRig& rig, const KeyPlace& place, double frame, KeyInterpolation interpolation);
/// Takes the key at a frame away, and its track with the last one. returns whether there was one; so do the next two.
bool remove_key(LightRig& rig, const KeyPlace& place, double frame);
/// In place of one that is at the other frame.
bool move_key(LightRig& rig, const KeyPlace& place, double from, double to);
bool set_interpolation(LightRig& rig, const KeyPlace& place, double frame, KeyInterpolation interpolation);

/// Keys, at that frame, for what has keys already and is not where they say. What turns a rig by hand or by a solve
/// calls it, so that what was found at a frame stays there. A new key interpolates as the one before it.
/// returns how many keys were set.
int follow_with_keys(LightRig& rig, double frame);

/// All frames with a key of a light, ascending; of any with "*". "" is the ambient.
std::vector<double> key_frames(const LightRig& rig, const std::string& light);

/// The parameters of a light, or of the ambient for ""; null if there is no such light.
ParamBlock* keyed_block(LightRig& rig, const std::string& light);
/// "color", or "position.x" of a track of one number; "" where the rig lacks the parameter.
std::string track_name(const LightRig& rig, const KeyTrack& track);

/// The [[key]] tables of a rig file: frame, light (absent: the ambient), interpolation (absent: "smooth"), and the
/// parameters that have a key there, as `color = [1, 0.9, 0.8]` or `position.x = 2`. errors kBadContent at
/// path:line:col: a light that is not there, an unknown parameter, two keys of one number at one frame.
Result<void> read_keys(std::span<const TomlValue> tables, const std::string& path, LightRig& rig);
/// The tables that read back to the same bits; "" without keys.
std::string keys_to_toml(const LightRig& rig);

}  // namespace luminist
