// Constraints that cannot be kept, and constraints in words (rig/constraint.h).
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/files.h"
#include "params/param_text.h"
#include "rig/light_rig.h"

namespace luminist {
namespace {

using Fault = std::optional<ConstraintFault>;

const Plane* plane_of(const Constraint& constraint) {
  if (const auto* on = std::get_if<OnPlane>(&constraint.rule)) return &on->plane;
  if (const auto* image = std::get_if<MirrorOf>(&constraint.rule)) return &image->plane;
  return nullptr;
}

bool is_position(const Constraint& constraint) {
  return std::holds_alternative<OnPlane>(constraint.rule) || std::holds_alternative<AtDistance>(constraint.rule);
}

Fault unknown_light(const LightRig& rig, const std::string& name, const char* field) {
  if (rig.find(name) != nullptr) return std::nullopt;
  std::vector<std::string> names;
  for (const Light& light : rig.lights) names.push_back(light.name);
  const std::string nearest = nearest_name(name, names);
  return ConstraintFault{0, field, fmt::format("there is no light \"{}\"", name),
                         !nearest.empty() ? fmt::format("did you mean \"{}\"?", nearest) : "name a light of this rig"};
}

Fault missing_role(const Light& light, const char* role, const char* field) {
  if (light.params.schema().by_role(role)) return std::nullopt;
  return ConstraintFault{0, field, fmt::format("\"{}\" has no {}: it is of type {}", light.name, role, light.type), ""};
}

/// Numbers that mean nothing.
Fault bad_numbers(const Constraint& constraint) {
  const char* field = rule_name(constraint);
  if (const Plane* plane = plane_of(constraint)) {
    const float length = glm::length(plane->normal);
    if (!is_finite(plane->point) || !std::isfinite(length) || !(length > 1e-6F)) {
      return ConstraintFault{0, field, "this is no plane", "give a point and a normal that is not 0"};
    }
  }
  if (const auto* at = std::get_if<AtDistance>(&constraint.rule)) {
    if (!is_finite(at->from) || !std::isfinite(at->distance) || !(at->distance > 0.0F)) {
      return ConstraintFault{0, field, "this is no distance",
                             "give a number above 0 and the point it is measured from"};
    }
  }
  if (const auto* range = std::get_if<Between>(&constraint.rule)) {
    if (!std::isfinite(range->low) || !std::isfinite(range->high) || !(range->low < range->high)) {
      return ConstraintFault{0, field, "this is no range", "give a number and a larger one; a lock holds one value"};
    }
  }
  if (const auto* same = std::get_if<SameColor>(&constraint.rule)) {
    if (!std::isfinite(same->factor) || same->factor < 0.0F) {
      return ConstraintFault{0, field, "this is no factor for a colour", "give a number from 0"};
    }
  }
  return std::nullopt;
}

/// A range of what the light has not, or of what has none.
Fault no_numbers(const Light& light, const Between& range) {
  const ParamSchema& schema = light.params.schema();
  const auto numbers = limited_numbers(light, range.param);
  if (!numbers) {
    std::vector<std::string> names;
    for (const ParamSpec& spec : schema.specs()) {
      if (spec.type == ParamType::kDirection) continue;
      if (spec.dofs() > 0) names.push_back(spec.name);
      for (int c = 0; c < spec.dofs() && spec.components() > 1; ++c) names.push_back(dof_name(spec, c));
    }
    const std::string nearest = nearest_name(range.param, names);
    return ConstraintFault{0, "between", fmt::format("\"{}\" has no number \"{}\" to turn", light.name, range.param),
                           !nearest.empty() ? fmt::format("did you mean \"{}\"?", nearest)
                                            : fmt::format("there are: {}", fmt::join(names, ", "))};
  }
  if (schema[numbers->param].scale == ParamScale::kLog && !(range.low > 0.0F)) {
    return ConstraintFault{0, "between", fmt::format("\"{}\" is never 0 or below", range.param),
                           "begin the range above 0"};
  }
  return std::nullopt;
}

/// What the lights' types and names say against it.
Fault wrong_lights(const LightRig& rig, const Constraint& constraint) {
  const char* field = rule_name(constraint);
  if (Fault fault = unknown_light(rig, constraint.light, "light")) return fault;
  const Light& light = *rig.find(constraint.light);
  if (is_position(constraint)) return missing_role(light, "position", field);
  if (const auto* range = std::get_if<Between>(&constraint.rule)) return no_numbers(light, *range);
  const std::string& name = *leader(constraint);
  if (Fault fault = unknown_light(rig, name, field)) return fault;
  const Light& followed = *rig.find(name);
  if (&followed == &light) {
    return ConstraintFault{0, field, fmt::format("\"{}\" cannot follow itself", name), "name another light"};
  }
  if (std::holds_alternative<SameColor>(constraint.rule)) {
    if (Fault fault = missing_role(light, "color", field)) return fault;
    return missing_role(followed, "color", field);
  }
  if (light.type == followed.type) return std::nullopt;
  return ConstraintFault{
      0, field, fmt::format("a light of type {} is no mirror image of one of type {}", light.type, followed.type),
      "make both of one type"};
}

/// A range of what the other constraint of the light decides, or that two ranges share.
Fault decided_twice(const Light& light, const Between& range, const Constraint& other, const char* field) {
  const LimitedNumbers numbers = *limited_numbers(light, range.param);
  const auto covers = [&](int c) { return c >= numbers.first && c < numbers.first + numbers.count; };
  const auto fault = [&](std::string what, std::string hint) {
    return ConstraintFault{0, field, std::move(what), std::move(hint)};
  };
  const std::string& role = light.params.schema()[numbers.param].role;
  if (const auto* second = std::get_if<Between>(&other.rule)) {
    const LimitedNumbers both = *limited_numbers(light, second->param);
    if (both.param != numbers.param) return std::nullopt;
    for (int c = both.first; c < both.first + both.count; ++c) {
      if (covers(c)) return fault(fmt::format("\"{}\" has two ranges", range.param), "keep one of them");
    }
  }
  if (std::holds_alternative<SameColor>(other.rule) && role == "color") {
    return fault(fmt::format("\"{}\" has the colour of another light", light.name), "hold that one in a range");
  }
  if (std::holds_alternative<AtDistance>(other.rule) && role == "position") {
    return fault("where a light stands at a distance says its place", "give it a range or a distance, not both");
  }
  return std::nullopt;
}

/// Ranges of all coordinates that lead to the light's plane, with this constraint and those before it.
Fault no_way_to_plane(const LightRig& rig, std::size_t index) {
  const Light& light = *rig.find(rig.constraints[index].light);
  const Plane* plane = nullptr;
  Vec3 ways(1.0F);
  for (std::size_t i = 0; i <= index; ++i) {
    const Constraint& each = rig.constraints[i];
    if (each.light != light.name) continue;
    if (const auto* on = std::get_if<OnPlane>(&each.rule)) plane = &on->plane;
    const auto* range = std::get_if<Between>(&each.rule);
    const auto numbers = range != nullptr ? limited_numbers(light, range->param) : std::nullopt;
    if (!numbers || light.params.schema()[numbers->param].role != "position") continue;
    for (int c = numbers->first; c < numbers->first + numbers->count; ++c) ways[c] = 0.0F;
  }
  if (plane == nullptr) return std::nullopt;
  const Vec3 along = ways * glm::normalize(plane->normal);
  if (glm::dot(along, along) > 1e-4F) return std::nullopt;
  return ConstraintFault{0, rule_name(rig.constraints[index]), "the plane decides that coordinate",
                         "hold coordinates along the plane in a range"};
}

/// Two constraints of one light that no rig can keep together.
Fault contradiction(const LightRig& rig, const Constraint& earlier, const Constraint& constraint) {
  if (earlier.light != constraint.light) return std::nullopt;
  const char* field = rule_name(constraint);
  const auto* range = std::get_if<Between>(&constraint.rule);
  const auto* range_before = std::get_if<Between>(&earlier.rule);
  if (range != nullptr || range_before != nullptr) {
    const Constraint& other = range != nullptr ? earlier : constraint;
    const Light& light = *rig.find(constraint.light);
    if (Fault fault = decided_twice(light, range != nullptr ? *range : *range_before, other, field)) return fault;
  } else if (earlier.rule.index() == constraint.rule.index()) {
    return ConstraintFault{0, field, fmt::format("\"{}\" has two constraints of this kind", constraint.light),
                           "keep one of them"};
  }
  if (std::holds_alternative<MirrorOf>(earlier.rule) || std::holds_alternative<MirrorOf>(constraint.rule)) {
    return ConstraintFault{0, field,
                           fmt::format("\"{}\" is a mirror image and has nothing of its own", constraint.light),
                           "constrain the light that it mirrors"};
  }
  if (!is_position(earlier) || !is_position(constraint)) return std::nullopt;
  const Constraint& on = std::holds_alternative<OnPlane>(earlier.rule) ? earlier : constraint;
  const Plane& plane = std::get<OnPlane>(on.rule).plane;
  const auto& at = std::get<AtDistance>((&on == &earlier ? constraint : earlier).rule);
  const float gap = std::abs(glm::dot(at.from - plane.point, glm::normalize(plane.normal)));
  if (gap <= at.distance) return std::nullopt;
  return ConstraintFault{0, field, "no place on the plane is at that distance",
                         fmt::format("give a distance of {} or more", number_text(shortest_double(gap)))};
}

/// Whether who follows whom from this constraint on comes back to its light. Each light follows one other at most.
Fault circle(const LightRig& rig, const Constraint& constraint) {
  const std::string* at = leader(constraint);
  for (std::size_t steps = 0; at != nullptr && steps <= rig.constraints.size(); ++steps) {
    if (*at == constraint.light) {
      return ConstraintFault{0, rule_name(constraint), "the lights follow each other in a circle",
                             "let one of them stand on its own"};
    }
    const auto next = std::find_if(rig.constraints.begin(), rig.constraints.end(), [&](const Constraint& each) {
      return each.light == *at && leader(each) != nullptr;
    });
    at = next == rig.constraints.end() ? nullptr : leader(*next);
  }
  return std::nullopt;
}

Fault fault_of(const LightRig& rig, std::size_t index) {
  const Constraint& constraint = rig.constraints[index];
  if (Fault fault = bad_numbers(constraint)) return fault;
  if (Fault fault = wrong_lights(rig, constraint)) return fault;
  for (std::size_t earlier = 0; earlier < index; ++earlier) {
    if (Fault fault = contradiction(rig, rig.constraints[earlier], constraint)) return fault;
  }
  if (Fault fault = no_way_to_plane(rig, index)) return fault;
  return circle(rig, constraint);
}

std::string vector_text(const Vec3& v) {
  return fmt::format("{},{},{}", number_text(shortest_double(v.x)), number_text(shortest_double(v.y)),
                     number_text(shortest_double(v.z)));
}

std::string plane_text(const Plane& plane) {
  return fmt::format("plane {} {}", vector_text(plane.point), vector_text(plane.normal));
}

}  // namespace

std::optional<ConstraintFault> find_fault(const LightRig& rig) {
  for (std::size_t index = 0; index < rig.constraints.size(); ++index) {
    if (Fault fault = fault_of(rig, index)) {
      fault->index = index;
      return fault;
    }
  }
  return std::nullopt;
}

Result<void> check_constraints(const LightRig& rig) {
  const auto fault = find_fault(rig);
  if (!fault) return {};
  return Error{ErrorKind::kUsage, fault->what, "", to_text(rig.constraints[fault->index]), fault->hint};
}

std::string to_text(const Constraint& constraint) {
  const std::string light = light_path(constraint.light);
  if (const auto* on = std::get_if<OnPlane>(&constraint.rule)) return light + " on " + plane_text(on->plane);
  if (const auto* at = std::get_if<AtDistance>(&constraint.rule)) {
    return fmt::format("{} at distance {} from {}", light, number_text(shortest_double(at->distance)),
                       vector_text(at->from));
  }
  if (const auto* image = std::get_if<MirrorOf>(&constraint.rule)) {
    return fmt::format("{} mirror of lights/{} across {}", light, image->light, plane_text(image->plane));
  }
  if (const auto* range = std::get_if<Between>(&constraint.rule)) {
    return fmt::format("{} {} between {} and {}", light, range->param, number_text(shortest_double(range->low)),
                       number_text(shortest_double(range->high)));
  }
  const auto& same = std::get<SameColor>(constraint.rule);
  const std::string text = fmt::format("{} same color as lights/{}", light, same.light);
  return same.factor == 1.0F ? text : fmt::format("{} times {}", text, number_text(shortest_double(same.factor)));
}

}  // namespace luminist
