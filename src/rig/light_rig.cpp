#include "rig/light_rig.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/files.h"

namespace luminist {

Light* LightRig::find(const std::string& name) {
  const auto hit = std::find_if(lights.begin(), lights.end(), [&](const Light& light) { return light.name == name; });
  return hit == lights.end() ? nullptr : &*hit;
}

const Light* LightRig::find(const std::string& name) const {
  const auto hit = std::find_if(lights.begin(), lights.end(), [&](const Light& light) { return light.name == name; });
  return hit == lights.end() ? nullptr : &*hit;
}

std::string light_path(const std::string& name) {
  return name.empty() ? "ambient" : "lights/" + name;
}

std::string LightRig::unused_name(const std::string& wanted) const {
  std::string name = wanted;
  for (int number = 2; find(name) != nullptr; ++number) name = fmt::format("{}-{}", wanted, number);
  return name;
}

bool is_light_name(std::string_view name) {
  return !name.empty() && name.size() <= 255 && std::none_of(name.begin(), name.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F || c == '/' || c == '*' || c == '=' || c == ':';
  });
}

LightRig empty_rig(const LightTypes& types, const SceneFrame& frame) {
  return {ParamBlock(types.ambient(), frame), {}, "", {}, {}};
}

Result<Light> make_light(const LightTypes& types, const std::string& type, const std::string& name,
                         const SceneFrame& frame) {
  if (!is_light_name(name)) {
    return Error{ErrorKind::kUsage, fmt::format("\"{}\" is no name for a light", name), "", "name",
                 "use 1 to 255 characters, none of them / * = :"};
  }
  if (const LightType* found = types.find(type)) return Light{name, type, "", false, ParamBlock(found->schema, frame)};
  const std::vector<std::string> names = types.names();
  const std::string nearest = nearest_name(type, names);
  return Error{ErrorKind::kUsage, fmt::format("there is no light type \"{}\"", type), "", "type",
               nearest.empty() ? fmt::format("one of {}", fmt::join(names, ", "))
                               : fmt::format("did you mean \"{}\"?", nearest)};
}

}  // namespace luminist
