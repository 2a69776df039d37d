#pragma once
// rig/light_list.h -- the lights of a rig as a list: names, groups, copies.
#include <string>
#include <vector>

#include "rig/light_rig.h"

namespace luminist {

/// Another name for a light, everywhere: its constraints and those that name it, its keys, a shadow map that others
/// share. errors kUsage: no such light (nearest name), a bad name, the name of another light.
Result<void> rename_light(LightRig& rig, const std::string& from, const std::string& to);

/// A second light with everything that the first has, its keys and its constraints too, right behind it in the list.
/// returns its name: `wanted`, or the first one's with a number. errors as above.
Result<std::string> duplicate_light(LightRig& rig, const std::string& name, const std::string& wanted);

/// Puts lights, or all of "group:NAME", into a group; "" takes them out of theirs. A group is there as long as a light
/// is in it, so that this renames one and dissolves one, too. errors kUsage: no such light or group, a bad name.
Result<void> group_lights(LightRig& rig, const std::vector<std::string>& names, const std::string& group);

/// Mutes all lights but these; none of them is there: nothing is muted.
void solo_lights(LightRig& rig, const std::vector<std::string>& names);

}  // namespace luminist
