#pragma once
// rig/keyframes.h -- lights that change over frames: keys of single parameters, and the rig at one frame.
#include <array>
#include <span>
#include <string>
#include <vector>

#include "params/toml_reader.h"

namespace luminist {

struct LightRig;

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

/// One parameter over time. Before its first and after its last key it stands still. Ints, bools and choices step.
struct KeyTrack {
  std::string light;      ///< name; empty: the ambient
  std::string param;      ///< name in the schema
  std::vector<Key> keys;  ///< ascending frames, at least one
};

/// Sets what has keys to its value at a frame, then keeps the constraints. Tracks of lights and parameters that are
/// not there are passed over. cost O(keys). thread any.
void pose(LightRig& rig, double frame);

/// A key for a parameter as it is now, in place of one at that frame. The light and the parameter exist (LUM_CHECK).
void set_key(LightRig& rig, const std::string& light, int param, double frame, KeyInterpolation interpolation);

/// Takes the key of a parameter at a frame away, and its track with the last one. returns whether there was one.
bool remove_key(LightRig& rig, const std::string& light, int param, double frame);

/// Keys, at that frame, for what has keys already and is not where they say. What turns a rig by hand or by a solve
/// calls it, so that what was found at a frame stays there. A new key interpolates as the one before it.
/// returns how many keys were set.
int follow_with_keys(LightRig& rig, double frame);

/// All frames with a key of a light, ascending; of any with "*". "" is the ambient.
std::vector<double> key_frames(const LightRig& rig, const std::string& light);

/// The [[key]] tables of a rig file: frame, light (absent: the ambient), interpolation (absent: "smooth"), and the
/// parameters that have a key there. errors kBadContent at path:line:col: a light that is not there, an unknown
/// parameter, two keys of one parameter at one frame.
Result<void> read_keys(std::span<const TomlValue> tables, const std::string& path, LightRig& rig);
/// The tables that read back to the same bits; "" without keys.
std::string keys_to_toml(const LightRig& rig);

}  // namespace luminist
