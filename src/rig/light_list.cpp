#include "rig/light_list.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "rig/light_links.h"

namespace luminist {
namespace {

Error bad_name(const std::string& name, const char* noun, const char* field) {
  return {ErrorKind::kUsage, fmt::format("\"{}\" is no name for a {}", name, noun), "", field,
          "use 1 to 255 characters, none of them / * = :"};
}

/// The one light of that name; a group is none.
Result<Light*> one_light(LightRig& rig, const std::string& name) {
  if (Light* light = rig.find(name)) return light;
  LUM_TRY(const std::vector<Light*> lights, lights_named(rig, name));
  return Error{ErrorKind::kUsage, fmt::format("\"{}\" is not one light", name), "", "light",
               fmt::format("name one of its lights, as \"{}\"", lights.front()->name)};
}

Result<void> check_new_name(const LightRig& rig, const std::string& name) {
  if (!is_light_name(name)) return bad_name(name, "light", "name");
  if (rig.find(name) == nullptr) return {};
  return Error{ErrorKind::kUsage, fmt::format("another light is named \"{}\"", name), "", "name",
               fmt::format("\"{}\" is free", rig.unused_name(name))};
}

/// leader(), to be changed.
std::string* led_by(Constraint& constraint) {
  if (MirrorOf* mirror = std::get_if<MirrorOf>(&constraint.rule)) return &mirror->light;
  if (SameColor* same = std::get_if<SameColor>(&constraint.rule)) return &same->light;
  return nullptr;
}

}  // namespace

Result<void> rename_light(LightRig& rig, const std::string& from, const std::string& to) {
  LUM_TRY(Light * light, one_light(rig, from));
  if (from == to) return {};
  LUM_TRY_VOID(check_new_name(rig, to));
  light->name = to;
  if (rig.shadow_light == from) rig.shadow_light = to;
  for (Constraint& constraint : rig.constraints) {
    if (constraint.light == from) constraint.light = to;
    if (std::string* led = led_by(constraint); led != nullptr && *led == from) *led = to;
  }
  for (KeyTrack& track : rig.keys) {
    if (track.light == from) track.light = to;
  }
  return {};
}

Result<std::string> duplicate_light(LightRig& rig, const std::string& name, const std::string& wanted) {
  LUM_TRY(const Light* light, one_light(rig, name));
  if (!wanted.empty()) LUM_TRY_VOID(check_new_name(rig, wanted));
  Light copy = *light;
  copy.name = wanted.empty() ? rig.unused_name(name) : wanted;
  const std::string given = copy.name;
  rig.lights.insert(rig.lights.begin() + (light - rig.lights.data()) + 1, std::move(copy));
  const auto copy_of = [&](auto& all) {
    for (std::size_t i = 0, count = all.size(); i < count; ++i) {
      if (all[i].light != name) continue;
      auto second = all[i];
      second.light = given;
      all.push_back(std::move(second));
    }
  };
  copy_of(rig.constraints);
  copy_of(rig.keys);
  return given;
}

Result<void> group_lights(LightRig& rig, const std::vector<std::string>& names, const std::string& group) {
  if (!group.empty() && !is_light_name(group)) return bad_name(group, "group", "group");
  std::vector<Light*> lights;
  for (const std::string& name : names) {
    LUM_TRY(const std::vector<Light*> named, lights_named(rig, name));
    std::ranges::copy(named, std::back_inserter(lights));
  }
  for (Light* light : lights) light->group = group;
  return {};
}

void solo_lights(LightRig& rig, const std::vector<std::string>& names) {
  const auto heard = [&](const Light& light) { return std::ranges::find(names, light.name) != names.end(); };
  if (std::ranges::none_of(rig.lights, heard)) return;
  for (Light& light : rig.lights) light.muted = light.muted || !heard(light);
}

}  // namespace luminist
