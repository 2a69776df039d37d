#include "params/spec_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include <fmt/format.h>

namespace luminist {
namespace {

constexpr std::size_t kMaxParams = 1000;
constexpr std::size_t kMaxNameLength = 64;

/// Words of lower-case letters that GLSL 4.50 keeps for itself (section 3.6), apart from those with a digit.
constexpr std::string_view kReserved =
    " active asm atomic_uint attribute bool break buffer case cast centroid class coherent common const continue "
    "default"
    " discard do double else enum extern external false filter fixed flat float for goto half highp if in inline inout"
    " input int interface invariant isampler layout long lowp mediump namespace noinline noperspective out output"
    " partition patch precise precision public readonly resource restrict return sample shared short sizeof smooth "
    "static"
    " struct subroutine superp switch template this true typedef uint uniform union unsigned using varying void "
    "volatile"
    " while writeonly ";

bool is_reserved(std::string_view name) {
  if (kReserved.find(fmt::format(" {} ", name)) != std::string_view::npos) return true;
  // vec2, dmat3x4, hvec4...: a type's name and its size.
  const std::size_t digit = name.find_first_of("0123456789");
  if (digit == std::string_view::npos) return false;
  static constexpr std::string_view kSized = " vec bvec dvec fvec hvec ivec uvec mat dmat ";
  return kSized.find(fmt::format(" {} ", name.substr(0, digit))) != std::string_view::npos &&
         name.find_first_not_of("234x", digit) == std::string_view::npos;
}

std::optional<SpecFault> fault(const ParamSpec& spec, std::string key, std::string what, std::string hint = "") {
  return SpecFault{0, spec.name, std::move(key), std::move(what), std::move(hint)};
}

std::optional<SpecFault> name_fault(const ParamSpec& spec) {
  const std::string& name = spec.name;
  static constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";
  const bool good = !name.empty() && name.size() <= kMaxNameLength &&
                    kLetters.find(name[0]) != std::string_view::npos &&
                    name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos &&
                    name.find("__") == std::string::npos && name.rfind("gl_", 0) != 0;
  if (!good) {
    return fault(spec, "name", fmt::format("\"{}\" is no parameter name", name),
                 "use lower-case letters, digits and single underscores, at most 64, a letter first");
  }
  if (is_reserved(name)) {
    return fault(spec, "name", fmt::format("\"{}\" is a reserved word of GLSL", name), "choose another name");
  }
  return std::nullopt;
}

bool all_finite(const std::vector<double>& values) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return std::all_of(values.begin(), values.end(), [](double v) { return std::abs(v) <= kLargest; });
}

std::optional<SpecFault> scale_fault(const ParamSpec& spec) {
  const bool length = spec.type == ParamType::kFloat || spec.type == ParamType::kVec2 || spec.type == ParamType::kVec3;
  if (spec.scale == ParamScale::kScene && !length) {
    return fault(spec, "scale", fmt::format("a {} has no length in the scene", type_name(spec.type)),
                 "use scale = \"linear\"");
  }
  const bool number = length || spec.type == ParamType::kInt || spec.type == ParamType::kColor;
  if (spec.scale == ParamScale::kLog && !number) {
    return fault(spec, "scale", fmt::format("a {} has no logarithm", type_name(spec.type)), "use scale = \"linear\"");
  }
  if (spec.solve && spec.dofs() == 0) {
    return fault(spec, "solve",
                 spec.quality ? "a quality has no degree of freedom"
                              : fmt::format("a {} has no degree of freedom", type_name(spec.type)),
                 "use solve = false");
  }
  return std::nullopt;
}

std::optional<SpecFault> range_fault(const ParamSpec& spec) {
  const auto count = static_cast<std::size_t>(spec.components());
  if (spec.range_min.size() != count || spec.range_max.size() != count) {
    return fault(spec, "range", fmt::format("a {} needs a range of {} numbers each", type_name(spec.type), count));
  }
  if (!all_finite(spec.range_min) || !all_finite(spec.range_max))
    return fault(spec, "range", "the range is not finite");
  for (std::size_t c = 0; c < count; ++c) {
    const double lo = spec.range_min[c];
    const double hi = spec.range_max[c];
    if (!(lo < hi)) {
      return fault(spec, "range", fmt::format("the range [{}, {}] does not rise", lo, hi),
                   "put the smaller number first");
    }
    if (spec.scale == ParamScale::kLog && lo <= 0.0) {
      return fault(spec, "range", fmt::format("a logarithmic range cannot start at {}", lo), "start it above 0");
    }
  }
  return std::nullopt;
}

std::optional<SpecFault> default_fault(const ParamSpec& spec) {
  const auto count = static_cast<std::size_t>(spec.components());
  const std::vector<double>& values = spec.default_value;
  if (values.size() != count) {
    return fault(spec, "default",
                 fmt::format("a {} has {} {}, not {}", type_name(spec.type), count, count == 1 ? "number" : "numbers",
                             values.size()));
  }
  if (!all_finite(values)) return fault(spec, "default", "the default is not finite");
  if (spec.type == ParamType::kDirection) {
    const bool zero = std::hypot(values[0], values[1], values[2]) < 1e-6;
    return zero ? fault(spec, "default", "a direction cannot be zero") : std::nullopt;
  }
  const bool whole = spec.type == ParamType::kInt || spec.type == ParamType::kBool || spec.type == ParamType::kChoice;
  for (std::size_t c = 0; c < count; ++c) {
    if (values[c] < spec.range_min[c] || values[c] > spec.range_max[c]) {
      return fault(
          spec, "default",
          fmt::format("the default {} is outside the range [{}, {}]", values[c], spec.range_min[c], spec.range_max[c]));
    }
    if (whole && values[c] != std::floor(values[c])) return fault(spec, "default", "a whole number is wanted here");
  }
  return std::nullopt;
}

std::optional<SpecFault> choice_fault(const ParamSpec& spec) {
  if (spec.type != ParamType::kChoice) {
    if (spec.choices.empty()) return std::nullopt;
    return fault(spec, "choices", fmt::format("a {} has no choices", type_name(spec.type)), "use type = \"choice\"");
  }
  if (spec.choices.size() < 2) return fault(spec, "choices", "a choice needs two names or more");
  std::set<std::string> seen;
  for (const std::string& choice : spec.choices) {
    if (choice.empty()) return fault(spec, "choices", "a choice has an empty name");
    if (!seen.insert(choice).second) return fault(spec, "choices", fmt::format("\"{}\" is listed twice", choice));
  }
  return std::nullopt;
}

}  // namespace

std::optional<SpecFault> find_fault(const ParamSpec& spec) {
  for (auto* rule : {name_fault, choice_fault, scale_fault, range_fault, default_fault}) {
    if (auto broken = rule(spec)) return broken;
  }
  return std::nullopt;
}

std::optional<SpecFault> find_list_fault(const std::vector<ParamSpec>& specs) {
  if (specs.size() > kMaxParams) {
    return SpecFault{kMaxParams, specs[kMaxParams].name, "name",
                     fmt::format("there are more than {} parameters", kMaxParams), "drop some"};
  }
  std::set<std::string> seen;
  for (std::size_t i = 0; i < specs.size(); ++i) {
    std::optional<SpecFault> broken = find_fault(specs[i]);
    if (!broken && !seen.insert(specs[i].name).second) {
      broken =
          fault(specs[i], "name", fmt::format("the name \"{}\" is used twice", specs[i].name), "rename one of them");
    }
    if (broken) {
      broken->index = i;
      return broken;
    }
  }
  return std::nullopt;
}

}  // namespace luminist
