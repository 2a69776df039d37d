#pragma once
// project/constraint_json.h -- a rig's constraints as one value of a document.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rig/light_rig.h"

namespace luminist {

/// [{"light": "key", "on_plane": {"point": [0,2,0], "normal": [0,-1,0]}}, ...], the names of rig files; "" for none.
/// What is read back has the same bits.
std::string constraints_to_json(std::span<const Constraint> constraints);

/// "" is none. Whether a rig can keep them is find_fault()'s to say. errors kBadContent at "rig/constraints".
Result<std::vector<Constraint>> constraints_from_json(std::string_view text);

}  // namespace luminist
