#include "project/state_document.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "params/param_text.h"
#include "project/constraint_json.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

Error wrong(const std::string& path, const std::string& what) {
  return {ErrorKind::kBadContent, what, "", path, "undo the change, or restore the project from a copy"};
}

void write_block(const std::string& path, const ParamBlock& block, Document& document) {
  const ParamSchema& schema = block.schema();
  for (int param = 0; param < schema.size(); ++param) {
    const ParamSpec& spec = schema[param];
    document.set(path + "/" + spec.name, param_to_json(block, param).dump());
    if (spec.dofs() == 0) continue;
    Json locks = Json::array();
    for (int dof = 0; dof < spec.dofs(); ++dof) locks.push_back(block.locked_by_hand(spec.first_dof + dof));
    document.set(fmt::format("locks/{}/{}", path, spec.name), locks.dump());
  }
}

bool locked_by_default(const ParamBlock& block, const ParamSpec& spec) {
  for (int dof = 0; dof < spec.dofs(); ++dof) {
    if (block.locked_by_hand(spec.first_dof + dof) == spec.solve) return false;
  }
  return true;
}

/// Only what is not as the scene has it: nothing for who does not turn materials, and a scene whose materials change
/// shows that.
void write_material(const std::string& path, const ParamBlock& block, Document& document) {
  write_block(path, block, document);
  for (int param = 0; param < block.schema().size(); ++param) {
    const ParamSpec& spec = block.schema()[param];
    if (block.at_default(param, {})) document.set(path + "/" + spec.name, "");
    if (locked_by_default(block, spec)) document.set(fmt::format("locks/{}/{}", path, spec.name), "");
  }
}

/// A direction is stored as it is: normalizing a unit vector again can change its last bit.
Result<void> read_direction(const Json& value, const std::string& path, ParamBlock& block, int param) {
  if (!value.is_array() || value.size() != 3) return wrong(path, "three numbers are wanted");
  for (int component = 0; component < 3; ++component) {
    const Json& number = value[static_cast<std::size_t>(component)];
    if (!number.is_number()) return wrong(path, "three numbers are wanted");
    block.set(param, component, number.get<double>());
  }
  return {};
}

Result<void> read_locks(const Document& document, const std::string& path, ParamBlock& block, const ParamSpec& spec) {
  const Json locks = Json::parse(document.get(path), nullptr, false);
  if (!locks.is_array() || locks.size() != static_cast<std::size_t>(spec.dofs())) {
    return wrong(path, fmt::format("{} booleans are wanted", spec.dofs()));
  }
  for (int dof = 0; dof < spec.dofs(); ++dof) {
    const Json& locked = locks[static_cast<std::size_t>(dof)];
    if (!locked.is_boolean()) return wrong(path, "booleans are wanted");
    block.set_locked(spec.first_dof + dof, locked.get<bool>());
  }
  return {};
}

/// What the document does not hold keeps its default: a style may have gained a parameter since.
Result<void> read_block(const Document& document, const std::string& path, ParamBlock& block) {
  for (int param = 0; param < block.schema().size(); ++param) {
    const ParamSpec& spec = block.schema()[param];
    const std::string value_path = path + "/" + spec.name;
    if (document.has(value_path)) {
      const Json value = Json::parse(document.get(value_path), nullptr, false);
      auto set = spec.type == ParamType::kDirection ? read_direction(value, value_path, block, param)
                                                    : param_from_json(block, param, value);
      if (!set) return wrong(value_path, set.error().what);
    }
    const std::string lock_path = "locks/" + value_path;
    if (spec.dofs() > 0 && document.has(lock_path)) LUM_TRY_VOID(read_locks(document, lock_path, block, spec));
  }
  return {};
}

Result<std::string> text_at(const Document& document, const std::string& path) {
  const Json value = Json::parse(document.get(path), nullptr, false);
  if (!value.is_string()) return wrong(path, "a string is wanted");
  return value.get<std::string>();
}

std::string keys_path(const std::string& light, const std::string& name) {
  return fmt::format("keys/{}/{}", light_path(light), name);
}

void write_keys(const LightRig& rig, Document& document) {
  document.erase_below("keys/");
  for (const KeyTrack& track : rig.keys) {
    const std::string name = track_name(rig, track);
    if (name.empty()) continue;
    Json keys = Json::array();
    for (const Key& key : track.keys) {
      const std::string& word = key_interpolation_words()[static_cast<std::size_t>(key.interpolation)];
      if (track.component >= 0) {
        keys.push_back({key.frame, word, key.value[0]});
      } else {
        keys.push_back({key.frame, word, key.value[0], key.value[1], key.value[2]});
      }
    }
    document.set(keys_path(track.light, name), keys.dump());
  }
}

/// numbers: how many a key of the track holds, 1 or 3.
Result<Key> read_key(const Json& value, const std::string& path, std::size_t numbers) {
  bool shaped = value.is_array() && value.size() == 2 + numbers && value[0].is_number() && value[1].is_string();
  for (std::size_t i = 0; shaped && i < numbers; ++i) shaped = value[2 + i].is_number();
  if (!shaped) return wrong(path, fmt::format("a frame, an interpolation and {} numbers are wanted", numbers));
  const std::span<const std::string> words = key_interpolation_words();
  const auto word = std::find(words.begin(), words.end(), value[1].get<std::string>());
  if (word == words.end()) return wrong(path, fmt::format("use one of {}", fmt::join(words, ", ")));
  Key key{value[0].get<double>(), static_cast<KeyInterpolation>(word - words.begin()), {}};
  for (std::size_t i = 0; i < numbers; ++i) key.value[i] = value[2 + i].get<double>();
  return key;
}

Result<void> read_track(const Document& document, const ParamSpec& spec, KeyTrack track, LightRig& rig) {
  const std::string path = keys_path(track.light, track.component < 0 ? spec.name : dof_name(spec, track.component));
  if (!document.has(path)) return {};
  const Json keys = Json::parse(document.get(path), nullptr, false);
  if (!keys.is_array() || keys.empty()) return wrong(path, "an array of keys is wanted");
  for (const Json& each : keys) {
    LUM_TRY(const Key key, read_key(each, path, track.component < 0 ? 3 : 1));
    if (!track.keys.empty() && !(key.frame > track.keys.back().frame)) return wrong(path, "frames must ascend");
    const bool chosen = spec.type != ParamType::kChoice ||
                        (key.value[0] >= 0.0 && key.value[0] < static_cast<double>(spec.choices.size()));
    if (!chosen) return wrong(path, "there is no such choice");
    track.keys.push_back(key);
  }
  rig.keys.push_back(std::move(track));
  return {};
}

Result<void> read_tracks(const Document& document, const std::string& light, const ParamBlock& block, LightRig& rig) {
  for (const ParamSpec& spec : block.schema().specs()) {
    const std::size_t before = rig.keys.size();
    LUM_TRY_VOID(read_track(document, spec, {light, spec.name, {}}, rig));
    if (rig.keys.size() > before || !keys_by_component(spec)) continue;
    for (int c = 0; c < spec.components(); ++c) {
      LUM_TRY_VOID(read_track(document, spec, {light, spec.name, {}, c}, rig));
    }
  }
  return {};
}

/// A path that is not there holds none.
Result<std::vector<std::string>> texts_at(const Document& document, const std::string& path) {
  std::vector<std::string> texts;
  if (!document.has(path)) return texts;
  const Json value = Json::parse(document.get(path), nullptr, false);
  for (const Json& each : value.is_array() ? value : Json::array({nullptr})) {
    if (!each.is_string()) return wrong(path, "an array of strings is wanted");
    texts.push_back(each.get<std::string>());
  }
  return texts;
}

Result<Light> read_light(const Document& document, const std::string& name, const LightTypes& types,
                         const SceneFrame& frame) {
  const std::string path = light_path(name);
  LUM_TRY(const std::string type, text_at(document, path + "/@type"));
  LUM_TRY(Light light, make_light(types, type, name, frame));
  LUM_TRY(light.group, text_at(document, path + "/@group"));
  light.muted = document.get(path + "/@muted") == "true";
  LUM_TRY(light.objects, texts_at(document, path + "/@objects"));
  LUM_TRY_VOID(read_block(document, path, light.params));
  return light;
}

}  // namespace

void write_state(const ParamState& state, Document& document) {
  Json names = Json::array();
  for (const Light& light : state.rig.lights) names.push_back(light.name);
  const Json present = Json::parse(document.get("rig/lights"), nullptr, false);
  for (const Json& name : present.is_array() ? present : Json::array()) {
    if (!name.is_string() || state.rig.find(name.get<std::string>()) != nullptr) continue;
    document.erase_below(fmt::format("lights/{}/", name.get<std::string>()));
    document.erase_below(fmt::format("locks/lights/{}/", name.get<std::string>()));
  }
  document.set("rig/lights", names.dump());
  document.set("rig/shadow_light", Json(state.rig.shadow_light).dump());
  document.set("rig/constraints", constraints_to_json(state.rig.constraints));
  for (const Light& light : state.rig.lights) {
    const std::string path = light_path(light.name);
    document.set(path + "/@type", Json(light.type).dump());
    document.set(path + "/@group", Json(light.group).dump());
    document.set(path + "/@muted", Json(light.muted).dump());
    document.set(path + "/@objects", light.objects.empty() ? "" : Json(light.objects).dump());
    write_block(path, light.params, document);
  }
  write_keys(state.rig, document);
  write_block("ambient", state.rig.ambient, document);
  write_block("style", state.style, document);
  for (const MaterialParams& material : state.materials) {
    write_material("materials/" + material.name, material.params, document);
  }
}

Result<ParamState> read_state(const Document& document, const LightTypes& types, const Style& style,
                              const SceneFrame& frame, std::vector<MaterialParams> materials) {
  ParamState state = initial_state(types, style, frame);
  state.materials = std::move(materials);
  const Json names = Json::parse(document.get("rig/lights"), nullptr, false);
  if (!names.is_array()) return wrong("rig/lights", "an array of names is wanted");
  for (const Json& name : names) {
    if (!name.is_string()) return wrong("rig/lights", "an array of names is wanted");
    LUM_TRY(Light light, read_light(document, name.get<std::string>(), types, frame));
    state.rig.lights.push_back(std::move(light));
  }
  LUM_TRY(state.rig.shadow_light, text_at(document, "rig/shadow_light"));
  LUM_TRY_VOID(read_block(document, "ambient", state.rig.ambient));
  LUM_TRY_VOID(read_block(document, "style", state.style));
  for (MaterialParams& material : state.materials) {
    LUM_TRY_VOID(read_block(document, "materials/" + material.name, material.params));
  }
  LUM_TRY_VOID(read_tracks(document, "", state.rig.ambient, state.rig));
  for (const Light& light : state.rig.lights) LUM_TRY_VOID(read_tracks(document, light.name, light.params, state.rig));
  LUM_TRY(state.rig.constraints, constraints_from_json(document.get("rig/constraints")));
  if (const auto fault = find_fault(state.rig)) return wrong("rig/constraints", fault->what);
  keep_constraints(state.rig);
  return state;
}

std::vector<std::string> missing_materials(const Document& document, const ParamState& state) {
  constexpr std::string_view kBelow = "materials/";
  std::set<std::string> missing;
  for (const auto& [path, value] : document.entries()) {
    if (value.empty() || !path.starts_with(kBelow)) continue;
    const std::string name = path.substr(kBelow.size(), path.find('/', kBelow.size()) - kBelow.size());
    missing.insert(name);
  }
  for (const MaterialParams& material : state.materials) missing.erase(material.name);
  return {missing.begin(), missing.end()};
}

}  // namespace luminist
