#include "params/param_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace luminist {

std::string wanted_form(const ParamSpec& spec) {
  switch (spec.type) {
    case ParamType::kFloat:
      return "give a number, as 0.3";
    case ParamType::kInt:
      return "give a whole number";
    case ParamType::kBool:
      return "give true or false";
    case ParamType::kVec2:
      return "give 2 numbers, as 0.3,0.1";
    case ParamType::kVec3:
      return "give 3 numbers, as 0.3,0.3,0.1";
    case ParamType::kColor:
      return "give 3 linear numbers, as 1,0.8,0.6, or #rrggbb";
    case ParamType::kDirection:
      return "give 3 numbers that are not all 0, as 0,-1,0";
    case ParamType::kChoice:
      return fmt::format("give one of {}", fmt::join(spec.choices, ", "));
  }
  return "";
}

std::optional<std::vector<double>> choice_index(const ParamSpec& spec, std::string_view name) {
  const auto hit = std::find(spec.choices.begin(), spec.choices.end(), name);
  if (hit == spec.choices.end()) return std::nullopt;
  return std::vector{static_cast<double>(hit - spec.choices.begin())};
}

bool store_values(ParamBlock& block, int param, const std::optional<std::vector<double>>& values) {
  const ParamSpec& spec = block.schema()[param];
  if (!values || values->size() != static_cast<std::size_t>(spec.components())) return false;
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (!std::all_of(values->begin(), values->end(), [](double v) { return std::abs(v) <= kLargest; })) return false;
  if (spec.type == ParamType::kDirection) {
    const auto unit = unit_direction(Vec3((*values)[0], (*values)[1], (*values)[2]));
    if (!unit) return false;
    block.set_vec3(param, *unit);
    return true;
  }
  if (spec.type == ParamType::kInt && (*values)[0] != std::floor((*values)[0])) return false;
  for (std::size_t c = 0; c < values->size(); ++c) block.set(param, static_cast<int>(c), (*values)[c]);
  return true;
}

}  // namespace luminist
