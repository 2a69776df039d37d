#include "params/param_schema.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/check.h"
#include "params/spec_rules.h"

namespace luminist {
namespace {

/// What follows from a type alone.
struct TypeRow {
  std::string_view name;
  std::string_view glsl;
  int components;
  int dofs;
  std::size_t align;  ///< std140 base alignment, OpenGL 4.5 core, section 7.6.2.2
  std::size_t size;
};

/// Indexed by ParamType.
constexpr std::array<TypeRow, 8> kTypes = {{
    {"float", "float", 1, 1, 4, 4},
    {"int", "int", 1, 0, 4, 4},
    {"bool", "uint", 1, 0, 4, 4},
    {"vec2", "vec2", 2, 2, 8, 8},
    {"vec3", "vec3", 3, 3, 16, 12},
    {"color", "vec3", 3, 3, 16, 12},
    {"direction", "vec3", 3, 2, 16, 12},
    {"choice", "int", 1, 0, 4, 4},
}};

const TypeRow& row(ParamType type) {
  return kTypes[static_cast<std::size_t>(type)];
}

std::size_t rounded_up(std::size_t bytes, std::size_t align) {
  return (bytes + align - 1) / align * align;
}

/// Where the scene's scale starts counting: its centre for a position, zero for a length.
double origin(const ParamSpec& spec, int component, const SceneFrame& frame) {
  return spec.role == "position" && spec.type == ParamType::kVec3 ? static_cast<double>(frame.center[component]) : 0.0;
}

}  // namespace

std::string_view type_name(ParamType type) {
  return row(type).name;
}

int ParamSpec::components() const {
  return row(type).components;
}

int ParamSpec::dofs() const {
  return quality ? 0 : row(type).dofs;
}

double ParamSpec::stored(int component, double written, const SceneFrame& frame) const {
  if (scale != ParamScale::kScene) return written;
  return origin(*this, component, frame) + static_cast<double>(frame.radius) * written;
}

double ParamSpec::written(int component, double stored, const SceneFrame& frame) const {
  if (scale != ParamScale::kScene) return stored;
  return (stored - origin(*this, component, frame)) / static_cast<double>(frame.radius);
}

Result<std::shared_ptr<const ParamSchema>> ParamSchema::create(std::vector<ParamSpec> specs, const std::string& where) {
  if (auto fault = find_list_fault(specs)) {
    return Error{ErrorKind::kStyle, fault->what, where, fault->param + "." + fault->key, fault->hint};
  }
  auto schema = std::make_shared<ParamSchema>();
  std::size_t end = 0;
  for (ParamSpec& spec : specs) {
    const TypeRow& type = row(spec.type);
    spec.offset = rounded_up(end, type.align);
    end = spec.offset + type.size;
    spec.first_dof = schema->dofs_;
    schema->dofs_ += spec.dofs();
  }
  schema->specs_ = std::move(specs);
  schema->byte_size_ = std::max<std::size_t>(16, rounded_up(end, 16));
  return std::shared_ptr<const ParamSchema>(std::move(schema));
}

std::optional<int> ParamSchema::find(std::string_view name) const {
  const auto hit = std::find_if(specs_.begin(), specs_.end(), [&](const ParamSpec& spec) { return spec.name == name; });
  if (hit == specs_.end()) return std::nullopt;
  return static_cast<int>(hit - specs_.begin());
}

std::optional<int> ParamSchema::by_role(std::string_view role) const {
  const auto hit = std::find_if(specs_.begin(), specs_.end(), [&](const ParamSpec& spec) { return spec.role == role; });
  if (hit == specs_.end()) return std::nullopt;
  return static_cast<int>(hit - specs_.begin());
}

std::vector<std::string> ParamSchema::names() const {
  std::vector<std::string> list;
  for (const ParamSpec& spec : specs_) list.push_back(spec.name);
  return list;
}

std::string ParamSchema::glsl_struct(std::string_view type_name) const {
  std::string text = fmt::format("struct {} {{\n", type_name);
  for (const ParamSpec& spec : specs_) text += fmt::format("  {} {};\n", row(spec.type).glsl, spec.name);
  if (specs_.empty()) text += "  float unused;\n";
  return text + "};\n";
}

}  // namespace luminist
