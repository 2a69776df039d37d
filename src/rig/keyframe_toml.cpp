// The [[key]] tables of rig files (rig/keyframes.h).
#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "base/files.h"
#include "params/param_text.h"
#include "params/param_toml.h"
#include "rig/keyframes.h"
#include "rig/light_rig.h"

namespace luminist {
namespace {

KeyInterpolation read_interpolation(TomlReader& read) {
  const std::string word = read.string("interpolation", "smooth");
  const std::span<const std::string> words = key_interpolation_words();
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) {
    read.fail("interpolation", fmt::format("\"{}\" is no interpolation", word),
              fmt::format("use {}", fmt::join(words, ", ")));
    return KeyInterpolation::kSmooth;
  }
  return static_cast<KeyInterpolation>(found - words.begin());
}

/// The block that a key is of, or nothing after a mistake.
ParamBlock* keyed_block(TomlReader& read, const std::string& light, LightRig& rig) {
  if (light.empty()) return &rig.ambient;
  if (Light* found = rig.find(light)) return &found->params;
  std::vector<std::string> names;
  for (const Light& each : rig.lights) names.push_back(each.name);
  const std::string nearest = nearest_name(light, names);
  read.fail("light", fmt::format("there is no light \"{}\"", light),
            nearest.empty() ? "name a light of this rig" : fmt::format("did you mean \"{}\"?", nearest));
  return nullptr;
}

using Taken = std::set<std::tuple<std::string, std::string, double>>;

Result<void> read_key(const TomlValue& table, const std::string& path, LightRig& rig, Taken& taken) {
  TomlReader read(table, path, ErrorKind::kBadContent);
  const double frame = read.number("frame");
  const std::string light = read.string("light", "");
  const KeyInterpolation interpolation = read_interpolation(read);
  ParamBlock* block = keyed_block(read, light, rig);
  LUM_TRY_VOID(read.status());
  const ParamBlock before = *block;
  read_params(read, *block);
  if (table.find("unlocked") != nullptr) read.fail("unlocked", "locks do not change over frames");
  int count = 0;
  for (int param = 0; param < block->schema().size(); ++param) {
    const std::string& name = block->schema()[param].name;
    if (table.find(name) == nullptr) continue;
    ++count;
    if (!taken.insert({light, name, frame}).second) read.fail(name, "it has a key at this frame already");
    set_key(rig, light, param, frame, interpolation);
  }
  *block = before;
  if (count == 0) read.fail("frame", "no parameter has a key here", "add one, as color = [1, 0.9, 0.8]");
  return read.finish();
}

}  // namespace

Result<void> read_keys(std::span<const TomlValue> tables, const std::string& path, LightRig& rig) {
  Taken taken;
  for (const TomlValue& table : tables) LUM_TRY_VOID(read_key(table, path, rig, taken));
  return {};
}

std::string keys_to_toml(const LightRig& rig) {
  // One table for all that a light has at a frame with one interpolation, its lines by parameter.
  std::map<std::tuple<std::string, double, KeyInterpolation>, std::map<int, std::string>> tables;
  for (const KeyTrack& track : rig.keys) {
    const Light* light = rig.find(track.light);
    if (light == nullptr && !track.light.empty()) continue;
    ParamBlock block = light != nullptr ? light->params : rig.ambient;
    const auto param = block.schema().find(track.param);
    if (!param) continue;
    for (const Key& key : track.keys) {
      for (int c = 0; c < block.schema()[*param].components(); ++c) {
        block.set(*param, c, key.value[static_cast<std::size_t>(c)]);
      }
      tables[{track.light, key.frame, key.interpolation}][*param] =
          fmt::format("{} = {}\n", track.param, param_to_toml(block, *param));
    }
  }
  std::string text;
  for (const auto& [place, lines] : tables) {
    const auto& [light, frame, interpolation] = place;
    text += fmt::format("\n[[key]]\nframe = {}\n", number_text(frame));
    if (!light.empty()) text += fmt::format("light = {}\n", toml_string(light));
    text += fmt::format("interpolation = \"{}\"\n", key_interpolation_words()[static_cast<std::size_t>(interpolation)]);
    for (const auto& [param, line] : lines) text += line;
  }
  return text;
}

}  // namespace luminist
