#include "rig/light_links.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/files.h"
#include "base/pattern.h"

namespace luminist {
namespace {

constexpr std::string_view kGroupPrefix = "group:";

std::string nearest_hint(std::string_view word, const std::vector<std::string>& names) {
  const std::string nearest = nearest_name(word, names);
  if (!nearest.empty()) return fmt::format("did you mean \"{}\"?", nearest);
  return names.empty() ? "there are none" : fmt::format("there are: {}", fmt::join(names, ", "));
}

}  // namespace

Result<std::vector<Light*>> lights_named(LightRig& rig, std::string_view name) {
  const bool by_group = name.starts_with(kGroupPrefix);
  std::vector<Light*> found;
  std::vector<std::string> names;
  for (Light& light : rig.lights) {
    const std::string own = by_group ? fmt::format("{}{}", kGroupPrefix, light.group) : light.name;
    if (own == name) found.push_back(&light);
    if (own != kGroupPrefix && std::ranges::find(names, own) == names.end()) names.push_back(own);
  }
  if (!found.empty()) return found;
  return Error{ErrorKind::kUsage, fmt::format("there is no light \"{}\"", name), "", "light",
               nearest_hint(name, names)};
}

bool lights_object(const Light& light, std::string_view object) {
  return light.objects.empty() ||
         std::ranges::any_of(light.objects, [&](const std::string& pattern) { return matches(pattern, object); });
}

int key_light(const LightRig& rig, std::string_view object) {
  int key = -1;
  int highest = -1;
  for (std::size_t i = 0; i < rig.lights.size(); ++i) {
    const Light& light = rig.lights[i];
    const int rank = (light.group == kKeyGroup ? 2 : 0) + (light.objects.empty() ? 0 : 1);
    if (rank <= highest || !lights_object(light, object)) continue;
    highest = rank;
    key = static_cast<int>(i);
  }
  return key;
}

std::string link_signature(const LightRig& rig) {
  std::string signature;
  for (const Light& light : rig.lights) {
    // Lengths before texts, so that no two rigs are written alike.
    (signature += light.group == kKeyGroup ? 'k' : '.') += std::to_string(light.objects.size());
    for (const std::string& pattern : light.objects) signature += fmt::format(":{}:{}", pattern.size(), pattern);
  }
  return signature;
}

Result<void> check_links(const LightRig& rig, std::span<const std::string> objects, const std::string& where) {
  for (const Light& light : rig.lights) {
    for (const std::string& pattern : light.objects) {
      if (std::ranges::any_of(objects, [&](const std::string& object) { return matches(pattern, object); })) continue;
      return Error{
          ErrorKind::kUsage,
          fmt::format("the light \"{}\" is linked to \"{}\", and there is no such object", light.name, pattern), where,
          "objects", nearest_hint(pattern, {objects.begin(), objects.end()})};
    }
  }
  return {};
}

Result<void> link_light(LightRig& rig, std::string_view name, const std::vector<std::string>& patterns,
                        std::span<const std::string> objects) {
  LUM_TRY(const std::vector<Light*> lights, lights_named(rig, name));
  LightRig linked = rig;
  const bool all = patterns.size() == 1 && patterns.front() == "*";
  for (const Light* light : lights) linked.find(light->name)->objects = all ? std::vector<std::string>{} : patterns;
  LUM_TRY_VOID(check_links(linked, objects, ""));
  rig = std::move(linked);
  return {};
}

Result<LinkWords> parse_link(const std::string& words) {
  const std::size_t equals = words.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == words.size()) {
    return Error{ErrorKind::kUsage, fmt::format("\"{}\" links nothing", words), "", words,
                 "write LIGHT=OBJECTS, as key=creature*,floor or group:rim=*"};
  }
  LinkWords link{words.substr(0, equals), {}};
  for (std::size_t start = equals + 1; start <= words.size();) {
    const std::size_t comma = std::min(words.find(',', start), words.size());
    link.patterns.push_back(words.substr(start, comma - start));
    start = comma + 1;
  }
  return link;
}

Result<void> link_lights(LightRig& rig, const std::vector<std::string>& words, std::span<const std::string> objects) {
  LightRig linked = rig;
  for (const std::string& each : words) {
    LUM_TRY(const LinkWords link, parse_link(each));
    LUM_TRY_VOID(link_light(linked, link.light, link.patterns, objects));
  }
  rig = std::move(linked);
  return {};
}

}  // namespace luminist
