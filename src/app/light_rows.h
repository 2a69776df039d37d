#pragma once
// app/light_rows.h -- the list of lights as it is shown: groups as headings, and what a click on an object links.
#include <set>
#include <span>
#include <string>
#include <vector>

#include "rig/light_rig.h"

namespace luminist {

/// A line of the list: a light, or the heading of a group.
struct LightRow {
  std::string group;             ///< of the heading or the light; "" for a light that is in none
  const Light* light = nullptr;  ///< null: the heading
};

/// In rig order; a group stands where its first light does, with its lights below the heading unless it is folded.
/// Pointers into the rig.
std::vector<LightRow> light_rows(const LightRig& rig, const std::set<std::string>& folded);

/// The names of all groups, in the order of their first lights.
std::vector<std::string> group_names(const LightRig& rig);
/// "group", "group-2", ...: one that no light is in.
std::string unused_group(const LightRig& rig);

/// What a light's patterns become when one object is taken in or out: names of objects, none where it lights all of
/// them. An only object stays: what lights nothing is muted, not linked.
std::vector<std::string> toggled_link(const Light& light, std::span<const std::string> objects,
                                      const std::string& object);
/// "everything", or the patterns.
std::string link_words(const Light& light);

}  // namespace luminist
