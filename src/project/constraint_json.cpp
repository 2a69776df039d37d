#include "project/constraint_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "params/param_text.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

Json vector_json(const Vec3& v) {
  return Json::array({shortest_double(v.x), shortest_double(v.y), shortest_double(v.z)});
}

Json rule_json(const Constraint& constraint) {
  if (const auto* on = std::get_if<OnPlane>(&constraint.rule)) {
    return {{"point", vector_json(on->plane.point)}, {"normal", vector_json(on->plane.normal)}};
  }
  if (const auto* at = std::get_if<AtDistance>(&constraint.rule)) {
    return {{"distance", shortest_double(at->distance)}, {"from", vector_json(at->from)}};
  }
  if (const auto* image = std::get_if<MirrorOf>(&constraint.rule)) {
    return {{"light", image->light},
            {"point", vector_json(image->plane.point)},
            {"normal", vector_json(image->plane.normal)}};
  }
  if (const auto* range = std::get_if<Between>(&constraint.rule)) {
    return {{"param", range->param}, {"low", shortest_double(range->low)}, {"high", shortest_double(range->high)}};
  }
  const auto& same = std::get<SameColor>(constraint.rule);
  return {{"light", same.light}, {"factor", shortest_double(same.factor)}};
}

Vec3 vector_from(const Json& json) {
  return {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

Plane plane_from(const Json& json) {
  return {vector_from(json.at("point")), vector_from(json.at("normal"))};
}

/// Throws the library's exceptions for what is missing or of another kind.
Constraint constraint_from(const Json& json) {
  Constraint constraint{json.at("light").get<std::string>(), {}};
  if (json.contains("on_plane")) {
    constraint.rule = OnPlane{plane_from(json.at("on_plane"))};
  } else if (json.contains("at_distance")) {
    const Json& at = json.at("at_distance");
    constraint.rule = AtDistance{at.at("distance").get<float>(), vector_from(at.at("from"))};
  } else if (json.contains("mirror_of")) {
    const Json& image = json.at("mirror_of");
    constraint.rule = MirrorOf{image.at("light").get<std::string>(), plane_from(image)};
  } else if (json.contains("between")) {
    const Json& range = json.at("between");
    constraint.rule =
        Between{range.at("param").get<std::string>(), range.at("low").get<float>(), range.at("high").get<float>()};
  } else {
    const Json& same = json.at("same_color");
    constraint.rule = SameColor{same.at("light").get<std::string>(), same.at("factor").get<float>()};
  }
  return constraint;
}

}  // namespace

std::string constraints_to_json(std::span<const Constraint> constraints) {
  if (constraints.empty()) return "";
  Json list = Json::array();
  for (const Constraint& constraint : constraints) {
    list.push_back({{"light", constraint.light}, {rule_name(constraint), rule_json(constraint)}});
  }
  return list.dump();
}

Result<std::vector<Constraint>> constraints_from_json(std::string_view text) {
  std::vector<Constraint> constraints;
  if (text.empty()) return constraints;
  try {
    const Json list = Json::parse(text);
    for (const Json& json : list) constraints.push_back(constraint_from(json));
  } catch (const Json::exception& error) {
    return Error{ErrorKind::kBadContent, fmt::format("no list of constraints: {}", error.what()), "", "rig/constraints",
                 "undo the change, or restore the project from a copy"};
  }
  return constraints;
}

}  // namespace luminist
