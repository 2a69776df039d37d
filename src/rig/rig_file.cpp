// Rig files: reading and writing (rig/light_rig.h).
#include <cmath>

#include <fmt/format.h>

#include "base/files.h"
#include "params/param_toml.h"
#include "params/toml_reader.h"
#include "rig/constraint_toml.h"
#include "rig/light_rig.h"

namespace luminist {
namespace {

Result<Light> read_light(const TomlValue& table, const LightRig& rig, const std::string& path, const LightTypes& types,
                         const SceneFrame& frame) {
  TomlReader read(table, path, ErrorKind::kBadContent);
  const std::string name = read.string("name");
  const std::string type = read.string("type");
  LUM_TRY_VOID(read.status());  // the type decides which other keys are valid
  auto light = make_light(types, type, name, frame);
  if (!light) {
    read.fail(light.error().field, light.error().what, light.error().hint);
  } else if (rig.find(name) != nullptr) {
    read.fail("name", fmt::format("two lights are named \"{}\"", name), "rename one of them");
  }
  LUM_TRY_VOID(read.status());
  light->group = read.string("group", "");
  if (!light->group.empty() && !is_light_name(light->group)) {
    read.fail("group", fmt::format("\"{}\" is no name for a group", light->group),
              "use 1 to 255 characters, none of them / * = :");
  }
  light->muted = read.boolean("muted", false);
  light->objects = read.strings("objects");
  read_params(read, light->params);
  LUM_TRY_VOID(read.finish());
  return light;
}

/// The first number of a block that no file can hold.
Result<void> check_finite(const ParamBlock& block, const std::string& path, const std::string& owner) {
  for (int param = 0; param < block.schema().size(); ++param) {
    const ParamSpec& spec = block.schema()[param];
    for (int c = 0; c < spec.components(); ++c) {
      if (std::isfinite(block.get(param, c))) continue;
      return Error{ErrorKind::kNumerical, fmt::format("the {} of {} is not finite", spec.name, owner), path, spec.name,
                   "set it before saving"};
    }
  }
  return {};
}

}  // namespace

Result<LightRig> load_rig(const std::string& path, const LightTypes& types, const SceneFrame& frame) {
  LUM_TRY(const std::string text, read_file(path));
  return parse_rig(text, path, types, frame);
}

Result<LightRig> parse_rig(const std::string& toml, const std::string& path, const LightTypes& types,
                           const SceneFrame& frame) {
  LUM_TRY(const TomlValue document, parse_toml(toml, path, ErrorKind::kBadContent));
  TomlReader root(document, path, ErrorKind::kBadContent);
  LightRig rig = empty_rig(types, frame);
  rig.shadow_light = root.string("shadow_light", "");
  const TomlValue* ambient = root.table("ambient");
  const std::span<const TomlValue> lights = root.tables("light");
  const std::span<const TomlValue> constraints = root.tables("constraint");
  const std::span<const TomlValue> keys = root.tables("key");
  LUM_TRY_VOID(root.finish());
  if (ambient != nullptr) {
    TomlReader read(*ambient, path, ErrorKind::kBadContent);
    read_params(read, rig.ambient);
    LUM_TRY_VOID(read.finish());
  }
  for (const TomlValue& table : lights) {
    LUM_TRY(Light light, read_light(table, rig, path, types, frame));
    rig.lights.push_back(std::move(light));
  }
  if (!rig.shadow_light.empty() && rig.find(rig.shadow_light) == nullptr) {
    std::vector<std::string> names;
    for (const Light& light : rig.lights) names.push_back(light.name);
    const std::string nearest = nearest_name(rig.shadow_light, names);
    root.fail("shadow_light", fmt::format("there is no light \"{}\"", rig.shadow_light),
              nearest.empty() ? "name a light of this rig" : fmt::format("did you mean \"{}\"?", nearest));
  }
  LUM_TRY_VOID(root.status());
  LUM_TRY_VOID(read_constraints(constraints, path, rig));
  LUM_TRY_VOID(read_keys(keys, path, rig));
  return rig;
}

std::string rig_to_toml(const LightRig& rig) {
  std::string text;
  if (!rig.shadow_light.empty()) text += fmt::format("shadow_light = {}\n\n", toml_string(rig.shadow_light));
  text += "[ambient]\n" + params_to_toml(rig.ambient);
  for (const Light& light : rig.lights) {
    text += fmt::format("\n[[light]]\nname = {}\ntype = {}\n", toml_string(light.name), toml_string(light.type));
    if (!light.group.empty()) text += fmt::format("group = {}\n", toml_string(light.group));
    if (light.muted) text += "muted = true\n";
    if (!light.objects.empty()) {
      std::vector<std::string> quoted;
      for (const std::string& pattern : light.objects) quoted.push_back(toml_string(pattern));
      text += fmt::format("objects = [{}]\n", fmt::join(quoted, ", "));
    }
    text += params_to_toml(light.params);
  }
  return text + constraints_to_toml(rig) + keys_to_toml(rig);
}

Result<void> save_rig(const LightRig& rig, const std::string& path) {
  LUM_TRY_VOID(check_finite(rig.ambient, path, "ambient"));
  for (const Light& light : rig.lights) LUM_TRY_VOID(check_finite(light.params, path, light.name));
  return write_file_atomic(path, rig_to_toml(rig));
}

}  // namespace luminist
