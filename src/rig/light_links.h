#pragma once
// rig/light_links.h -- which light lights which object, and which one is an object's key.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rig/light_rig.h"

namespace luminist {

/// Lights of this group are an object's key before others.
inline constexpr std::string_view kKeyGroup = "key";

/// The light of that name, or with "group:NAME" all lights of that group, in rig order; pointers into the rig.
/// errors kUsage if there are none (nearest name).
Result<std::vector<Light*>> lights_named(LightRig& rig, std::string_view name);

/// Whether a light lights an object: it has no patterns, or one that matches. Shadows are not linked: an object that a
/// light does not light still stands in its way.
bool lights_object(const Light& light, std::string_view object);

/// The one light that is an object's key: of those that light it, one of the group "key" before others, then one that
/// is linked to it by a pattern before one that lights everything, then the first. Muted lights keep their place, so
/// that muting a light takes away what it did and nothing else.
/// returns its place in rig.lights, -1 if no light lights the object. cost O(patterns).
int key_light(const LightRig& rig, std::string_view object);

/// Equal for rigs whose lights light the same objects and are their keys, whatever objects there are.
std::string link_signature(const LightRig& rig);

/// errors kUsage at `where` for the first pattern that matches none of the objects, with the nearest name.
Result<void> check_links(const LightRig& rig, std::span<const std::string> objects, const std::string& where);

/// A light, or "group:NAME" for all lights of a group, lights only what the patterns match from now on; no patterns, or
/// "*" alone: everything. errors kUsage for a light or group that is not there (nearest name), and as check_links().
Result<void> link_light(LightRig& rig, std::string_view name, const std::vector<std::string>& patterns,
                        std::span<const std::string> objects);

/// A link in words: "key=creature*,floor" or "group:rim=*". errors kUsage with the words as the field.
struct LinkWords {
  std::string light;
  std::vector<std::string> patterns;
};
Result<LinkWords> parse_link(const std::string& words);

/// link_light() for each of some links in words, all or none. errors those of both.
Result<void> link_lights(LightRig& rig, const std::vector<std::string>& words, std::span<const std::string> objects);

}  // namespace luminist
