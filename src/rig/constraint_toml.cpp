#include "rig/constraint_toml.h"

#include <array>
#include <limits>

#include <fmt/format.h>

#include "params/param_text.h"
#include "params/param_toml.h"

namespace luminist {
namespace {

Vec3 read_vector(TomlReader& read, const char* key) {
  const TomlValue& value = read.required_value(key);
  Vec3 vector(std::numeric_limits<float>::quiet_NaN());
  for (std::size_t c = 0; c < 3 && value.items.size() == 3; ++c) {
    if (value.items[c].is_number()) vector[static_cast<int>(c)] = static_cast<float>(value.items[c].number);
  }
  if (!is_finite(vector)) read.fail(key, "this is no place or direction", "give three numbers, as [0, 2.5, 0]");
  return vector;
}

Plane read_plane(TomlReader& read) {
  Plane plane;
  plane.point = read_vector(read, "point");
  plane.normal = read_vector(read, "normal");
  return plane;
}

/// Of the table behind one of kRuleNames.
Result<Constraint> read_rule(const std::string& light, std::string_view rule, const TomlValue& table,
                             const std::string& path) {
  TomlReader read(table, path, ErrorKind::kBadContent);
  Constraint constraint{light, {}};
  if (rule == "on_plane") {
    constraint.rule = OnPlane{read_plane(read)};
  } else if (rule == "at_distance") {
    const auto distance = static_cast<float>(read.number("distance"));
    constraint.rule = AtDistance{distance, read_vector(read, "from")};
  } else if (rule == "mirror_of") {
    const std::string other = read.string("light");
    constraint.rule = MirrorOf{other, read_plane(read)};
  } else if (rule == "between") {
    const std::string param = read.string("param");
    const auto low = static_cast<float>(read.number("low"));
    constraint.rule = Between{param, low, static_cast<float>(read.number("high"))};
  } else {
    const std::string other = read.string("light");
    constraint.rule = SameColor{other, static_cast<float>(read.number("factor", 1.0))};
  }
  LUM_TRY_VOID(read.finish());
  return constraint;
}

Result<Constraint> read_constraint(const TomlValue& table, const std::string& path) {
  TomlReader read(table, path, ErrorKind::kBadContent);
  const std::string light = read.string("light");
  const char* rule = nullptr;
  const TomlValue* body = nullptr;
  for (const char* each : kRuleNames) {
    const TomlValue* found = read.table(each);
    if (found != nullptr && body != nullptr) {
      read.fail(each, fmt::format("there is {} already", rule), "write a [[constraint]] for each");
    }
    if (found != nullptr) rule = each, body = found;
  }
  LUM_TRY_VOID(read.finish());
  if (body == nullptr) {
    read.fail("light", "nothing is said of this light", fmt::format("give one of {}", fmt::join(kRuleNames, ", ")));
    LUM_TRY_VOID(read.status());
  }
  return read_rule(light, rule, *body, path);
}

std::string vector_toml(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", number_text(shortest_double(v.x)), number_text(shortest_double(v.y)),
                     number_text(shortest_double(v.z)));
}

std::string plane_toml(const Plane& plane) {
  return fmt::format("point = {}, normal = {}", vector_toml(plane.point), vector_toml(plane.normal));
}

std::string rule_toml(const Constraint& constraint) {
  if (const auto* on = std::get_if<OnPlane>(&constraint.rule)) return plane_toml(on->plane);
  if (const auto* at = std::get_if<AtDistance>(&constraint.rule)) {
    return fmt::format("distance = {}, from = {}", number_text(shortest_double(at->distance)), vector_toml(at->from));
  }
  if (const auto* image = std::get_if<MirrorOf>(&constraint.rule)) {
    return fmt::format("light = {}, {}", toml_string(image->light), plane_toml(image->plane));
  }
  if (const auto* range = std::get_if<Between>(&constraint.rule)) {
    return fmt::format("param = {}, low = {}, high = {}", toml_string(range->param),
                       number_text(shortest_double(range->low)), number_text(shortest_double(range->high)));
  }
  const auto& same = std::get<SameColor>(constraint.rule);
  return fmt::format("light = {}, factor = {}", toml_string(same.light), number_text(shortest_double(same.factor)));
}

}  // namespace

Result<void> read_constraints(std::span<const TomlValue> tables, const std::string& path, LightRig& rig) {
  for (const TomlValue& table : tables) {
    LUM_TRY(Constraint constraint, read_constraint(table, path));
    rig.constraints.push_back(std::move(constraint));
  }
  if (const auto fault = find_fault(rig)) {
    TomlReader read(tables[fault->index], path, ErrorKind::kBadContent);
    read.fail(fault->field, fault->what, fault->hint);
    return read.status();
  }
  keep_constraints(rig);
  return {};
}

std::string constraints_to_toml(const LightRig& rig) {
  std::string text;
  for (const Constraint& constraint : rig.constraints) {
    text += fmt::format("\n[[constraint]]\nlight = {}\n{} = {{ {} }}\n", toml_string(constraint.light),
                        rule_name(constraint), rule_toml(constraint));
  }
  return text;
}

}  // namespace luminist
