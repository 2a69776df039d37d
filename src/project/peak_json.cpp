#include "project/peak_json.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "project/tile_planes.h"

namespace luminist {

using Json = nlohmann::json;

Json peak_to_json(const Peak& peak) {
  const Vec3& d = peak.direction;
  return std::array<double, 4>{peak.kind == PeakKind::kDiffuse ? 0.0 : 1.0, d.x, d.y, d.z};
}

Result<Peak> peak_from_json(const Json& value, const std::string& path) {
  const bool numbers = value.is_array() && value.size() == 4 &&
                       std::all_of(value.begin(), value.end(), [](const Json& v) { return v.is_number(); });
  if (!numbers) return wrong_paint(path, "four numbers are wanted");
  const auto number = [&](std::size_t i) { return static_cast<float>(value[i].get<double>()); };
  Peak peak;
  peak.kind = number(0) == 0.0F ? PeakKind::kDiffuse : PeakKind::kSpecular;
  peak.direction = Vec3(number(1), number(2), number(3));
  if (!(std::abs(glm::length(peak.direction) - 1.0F) < 1e-3F)) return wrong_paint(path, "a unit vector is wanted");
  return peak;
}

}  // namespace luminist
