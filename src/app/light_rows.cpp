#include "app/light_rows.h"

#include <algorithm>

#include <fmt/format.h>

#include "rig/light_links.h"

namespace luminist {

std::vector<std::string> group_names(const LightRig& rig) {
  std::vector<std::string> names;
  for (const Light& light : rig.lights) {
    if (!light.group.empty() && std::ranges::find(names, light.group) == names.end()) names.push_back(light.group);
  }
  return names;
}

std::string unused_group(const LightRig& rig) {
  const std::vector<std::string> taken = group_names(rig);
  std::string name = "group";
  for (int number = 2; std::ranges::find(taken, name) != taken.end(); ++number) name = fmt::format("group-{}", number);
  return name;
}

std::vector<LightRow> light_rows(const LightRig& rig, const std::set<std::string>& folded) {
  std::vector<LightRow> rows;
  std::set<std::string> shown;
  for (const Light& light : rig.lights) {
    if (light.group.empty()) {
      rows.push_back({"", &light});
      continue;
    }
    if (!shown.insert(light.group).second) continue;
    rows.push_back({light.group, nullptr});
    if (folded.contains(light.group)) continue;
    for (const Light& each : rig.lights) {
      if (each.group == light.group) rows.push_back({each.group, &each});
    }
  }
  return rows;
}

std::vector<std::string> toggled_link(const Light& light, std::span<const std::string> objects,
                                      const std::string& object) {
  std::vector<std::string> linked;
  for (const std::string& each : objects) {
    if (lights_object(light, each) != (each == object)) linked.push_back(each);
  }
  if (linked.empty()) return {object};
  if (linked.size() == objects.size()) linked.clear();
  return linked;
}

std::string link_words(const Light& light) {
  return light.objects.empty() ? "everything" : fmt::format("{}", fmt::join(light.objects, ", "));
}

}  // namespace luminist
