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
#include "params/param_values.h"
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
ParamBlock* find_block(TomlReader& read, const std::string& light, LightRig& rig) {
  if (ParamBlock* found = keyed_block(rig, light)) return found;
  std::vector<std::string> names;
  for (const Light& each : rig.lights) names.push_back(each.name);
  const std::string nearest = nearest_name(light, names);
  read.fail("light", fmt::format("there is no light \"{}\"", light),
            nearest.empty() ? "name a light of this rig" : fmt::format("did you mean \"{}\"?", nearest));
  return nullptr;
}

/// Light, number of a parameter, frame.
using Taken = std::set<std::tuple<std::string, std::string, double>>;

/// What a table says of one light at one frame.
struct KeyTable {
  std::string light;
  double frame = 0.0;
  KeyInterpolation interpolation = KeyInterpolation::kSmooth;
};

/// The numbers of one parameter, as `position.x = 2`. returns how many.
Result<int> read_components(const TomlValue& numbers, const std::string& path, const KeyTable& key, int param,
                            LightRig& rig, Taken& taken) {
  ParamBlock& block = *keyed_block(rig, key.light);
  const ParamSpec& spec = block.schema()[param];
  TomlReader read(numbers, path, ErrorKind::kBadContent);
  if (!keys_by_component(spec)) {
    for (const TomlEntry& entry : numbers.entries) static_cast<void>(read.value(entry.key));
    read.fail(spec.name, fmt::format("a {} is keyed as a whole", type_name(spec.type)), wanted_form(spec));
  }
  int count = 0;
  for (int c = 0; c < spec.components() && keys_by_component(spec); ++c) {
    const std::string name = dof_name(spec, c);
    const std::string part = name.substr(spec.name.size() + 1);
    if (numbers.find(part) == nullptr) continue;
    block.set(param, c, read.number(part));
    if (!taken.insert({key.light, name, key.frame}).second) read.fail(part, "it has a key at this frame already");
    set_key(rig, {key.light, param, c}, key.frame, key.interpolation);
    ++count;
  }
  LUM_TRY_VOID(read.finish());
  return count;
}

/// The table without what it says of single numbers: keys of whole parameters.
TomlValue whole_part(const TomlValue& table) {
  TomlValue whole = table;
  std::erase_if(whole.entries, [](const TomlEntry& entry) { return entry.value.kind == TomlValue::Kind::kTable; });
  return whole;
}

Result<void> read_key(const TomlValue& table, const std::string& path, LightRig& rig, Taken& taken) {
  const TomlValue whole = whole_part(table);
  TomlReader read(whole, path, ErrorKind::kBadContent);
  KeyTable key;
  key.frame = read.number("frame");
  key.light = read.string("light", "");
  key.interpolation = read_interpolation(read);
  ParamBlock* block = find_block(read, key.light, rig);
  LUM_TRY_VOID(read.status());
  const ParamBlock before = *block;
  read_params(read, *block);
  if (table.find("unlocked") != nullptr) read.fail("unlocked", "locks do not change over frames");
  int count = 0;
  for (const TomlEntry& entry : table.entries) {
    const auto param = block->schema().find(entry.key);
    if (!param) {
      if (entry.value.kind == TomlValue::Kind::kTable)
        read.fail_at(entry.value, entry.key, "there is no such parameter");
      continue;
    }
    if (entry.value.kind == TomlValue::Kind::kTable) {
      LUM_TRY(const int numbers, read_components(entry.value, path, key, *param, rig, taken));
      count += numbers;
      continue;
    }
    ++count;
    const ParamSpec& spec = block->schema()[*param];
    for (int c = 0; c < spec.components(); ++c) {
      const std::string name = keys_by_component(spec) ? dof_name(spec, c) : spec.name;
      const bool again = spec.components() > 1 && !keys_by_component(spec) && c > 0;
      if (!again && !taken.insert({key.light, name, key.frame}).second) {
        read.fail(spec.name, "it has a key at this frame already");
      }
    }
    set_key(rig, {key.light, *param}, key.frame, key.interpolation);
  }
  *block = before;
  if (count == 0) read.fail("frame", "no parameter has a key here", "add one, as color = [1, 0.9, 0.8]");
  return read.finish();
}

/// "color = [1, 1, 1]\n", "position.x = 2\n": what a key says, in a block of the light's type.
std::string key_line(const KeyTrack& track, const Key& key, ParamBlock& block, int param) {
  const ParamSpec& spec = block.schema()[param];
  if (track.component >= 0) {
    block.set(param, track.component, key.value[0]);
    const auto stored = static_cast<float>(block.get(param, track.component));
    return fmt::format("{} = {}\n", dof_name(spec, track.component), number_text(shortest_double(stored)));
  }
  for (int c = 0; c < spec.components(); ++c) block.set(param, c, key.value[static_cast<std::size_t>(c)]);
  return fmt::format("{} = {}\n", track.param, param_to_toml(block, param));
}

}  // namespace

Result<void> read_keys(std::span<const TomlValue> tables, const std::string& path, LightRig& rig) {
  Taken taken;
  for (const TomlValue& table : tables) LUM_TRY_VOID(read_key(table, path, rig, taken));
  return {};
}

std::string keys_to_toml(const LightRig& rig) {
  // One table for all that a light has at a frame with one interpolation, its lines by parameter and number.
  using Lines = std::map<std::pair<int, int>, std::string>;
  std::map<std::tuple<std::string, double, KeyInterpolation>, Lines> tables;
  for (const KeyTrack& track : rig.keys) {
    if (track_name(rig, track).empty()) continue;
    const Light* light = rig.find(track.light);
    ParamBlock block = light != nullptr ? light->params : rig.ambient;
    const int param = *block.schema().find(track.param);
    for (const Key& key : track.keys) {
      tables[{track.light, key.frame, key.interpolation}][{param, track.component}] =
          key_line(track, key, block, param);
    }
  }
  std::string text;
  for (const auto& [place, lines] : tables) {
    const auto& [light, frame, interpolation] = place;
    text += fmt::format("\n[[key]]\nframe = {}\n", number_text(frame));
    if (!light.empty()) text += fmt::format("light = {}\n", toml_string(light));
    text += fmt::format("interpolation = \"{}\"\n", key_interpolation_words()[static_cast<std::size_t>(interpolation)]);
    for (const auto& [number, line] : lines) text += line;
  }
  return text;
}

}  // namespace luminist
