#pragma once
// project/peak_json.h -- the peak of a gradient as JSON: [kind, x, y, z].
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "paint/gradient.h"

namespace luminist {

nlohmann::json peak_to_json(const Peak& peak);
/// errors kBadContent naming the path.
Result<Peak> peak_from_json(const nlohmann::json& value, const std::string& path);

}  // namespace luminist
