#include "scene/material_params.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/check.h"

namespace luminist {
namespace {

constexpr const char* kManifest = "shaders/material.toml";

/// The parameter of a role; the schema was checked when it was read.
int param_of(const ParamSchema& schema, std::string_view role) {
  const std::optional<int> param = schema.by_role(role);
  LUM_CHECK(param.has_value(), "the schema is that of materials");
  return *param;
}

/// Bytes of the UTF-8 sequence that begins a text, or 0 if none does.
std::size_t utf8_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) return 0;
  }
  // Too long for what they say, surrogates, beyond the last character.
  const auto second = length > 1 ? static_cast<unsigned char>(text[1]) : 0U;
  const bool wrong = (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) ||
                     (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F);
  return wrong ? 0 : length;
}

/// Documents and JSON hold UTF-8; meshes hold whatever their makers' machines wrote.
std::string path_name(std::string_view name) {
  constexpr std::size_t kLongest = 255;
  std::string word;
  while (!name.empty()) {
    const std::size_t length = utf8_length(name);
    const auto byte = static_cast<unsigned char>(name.front());
    const bool good = length > 0 && byte >= 0x20 && byte != 0x7F &&
                      std::string_view("/*=:").find(name.front()) == std::string_view::npos;
    const std::string_view next = good ? name.substr(0, length) : std::string_view("-");
    if (word.size() + next.size() > kLongest) break;
    word += next;
    name.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return word.empty() ? "material" : word;
}

/// The default of a role becomes what the material has.
void start_at(std::vector<ParamSpec>& specs, std::string_view role, float value) {
  for (ParamSpec& spec : specs) {
    if (spec.role != role) continue;
    spec.default_value.assign(1, value);
    spec.range_min[0] = std::min(spec.range_min[0], static_cast<double>(value));
    spec.range_max[0] = std::max(spec.range_max[0], static_cast<double>(value));
  }
}

/// A tint of a plain colour ends where all light is reflected: beyond, a solver would find no slope.
void end_tint(std::vector<ParamSpec>& specs, const Material& material) {
  if (material.base_color_texture >= 0) return;  // a texel may be dark
  for (ParamSpec& spec : specs) {
    if (spec.role != "tint") continue;
    for (int c = 0; c < 3; ++c) {
      double& most = spec.range_max[static_cast<std::size_t>(c)];
      most = std::min(most, std::max(1.0, 1.0 / std::max(1e-6, static_cast<double>(material.base_color[c]))));
    }
  }
}

/// How a value stands to the material's own one.
void relate(float now, float own, float& scale, float& shift) {
  if (now == own) return;
  if (own > 0.0F) {
    scale = now / own;
  } else {
    scale = 0.0F;
    shift = now;
  }
}

float own_value(const ParamSchema& schema, int param) {
  return static_cast<float>(schema[param].default_value[0]);
}

/// A tint as a factor of the material, or as a texture of its own where a factor would have to be above 1.
void bake_tint(Scene& scene, Material& material, const Vec3& tint) {
  const Vec3 wanted = material.base_color * glm::max(tint, Vec3(0.0F));
  if (material.base_color_texture < 0 || largest(wanted) <= 1.0F) {
    material.base_color = glm::min(wanted, glm::max(Vec3(1.0F), material.base_color));
    return;
  }
  Texture own = scene.textures[static_cast<std::size_t>(material.base_color_texture)];
  own.name = fmt::format("{} {}", own.name, material.name);
  const auto channels = static_cast<std::size_t>(own.image.channels);
  for (std::size_t i = 0; i < own.image.pixels(); ++i) {
    for (int c = 0; c < 3; ++c) {
      float& value = own.image.data[i * channels + static_cast<std::size_t>(c)];
      value = std::min(value * wanted[c], 1.0F);
    }
  }
  material.base_color = Vec3(1.0F);
  material.base_color_texture = static_cast<int>(scene.textures.size());
  scene.textures.push_back(std::move(own));
}

}  // namespace

Result<std::shared_ptr<const ParamSchema>> load_material_schema(const AssetRoots& roots) {
  LUM_TRY(const std::filesystem::path path, roots.find(kManifest));
  LUM_TRY(const std::string text, read_file(path));
  LUM_TRY(auto schema, ParamSchema::parse(text, path.string()));
  const std::array<std::pair<const char*, ParamType>, 3> wanted{
      {{"tint", ParamType::kColor}, {"specular", ParamType::kFloat}, {"roughness", ParamType::kFloat}}};
  for (const auto& [role, type] : wanted) {
    const std::optional<int> param = schema->by_role(role);
    if (param && (*schema)[*param].type == type && (*schema)[*param].scale != ParamScale::kScene) continue;
    return Error{ErrorKind::kStyle, fmt::format("there is no parameter of the role \"{}\"", role), path.string(), role,
                 fmt::format("declare one of the type {}", type_name(type))};
  }
  return schema;
}

std::vector<std::string> material_names(const std::vector<Material>& materials) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  std::map<std::string, int> last;  // the number that a name got
  for (const Material& material : materials) {
    const std::string wanted = path_name(material.name);
    std::string name = wanted;
    for (int& number = last.try_emplace(wanted, 1).first->second; !taken.insert(name).second;) {
      name = fmt::format("{}-{}", wanted, ++number);
    }
    names.push_back(std::move(name));
  }
  return names;
}

std::vector<MaterialParams> material_params(const std::vector<Material>& materials, const ParamSchema& schema) {
  const std::vector<std::string> names = material_names(materials);
  std::vector<MaterialParams> params;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    std::vector<ParamSpec> specs = schema.specs();
    start_at(specs, "specular", materials[i].specular);
    start_at(specs, "roughness", materials[i].roughness);
    end_tint(specs, materials[i]);
    auto own = ParamSchema::create(std::move(specs), kManifest);
    LUM_CHECK(own, "a schema with other defaults in its ranges is one");
    params.push_back({names[i], ParamBlock(std::move(own).value(), {})});
  }
  return params;
}

MaterialTurn turn_of(const ParamBlock& params) {
  const ParamSchema& schema = params.schema();
  const int specular = param_of(schema, "specular");
  const int roughness = param_of(schema, "roughness");
  MaterialTurn turn;
  turn.tint = params.vec3(param_of(schema, "tint"));
  relate(params.scalar(roughness), own_value(schema, roughness), turn.roughness_scale, turn.roughness_shift);
  relate(params.scalar(specular), own_value(schema, specular), turn.specular_scale, turn.specular_shift);
  turn.specular_shift *= kDielectric;
  const bool same = params.scalar(roughness) == own_value(schema, roughness) &&
                    params.scalar(specular) == own_value(schema, specular) && turn.tint == Vec3(1.0F);
  turn.turns = same ? 0.0F : 1.0F;
  return turn;
}

SurfaceColors turned(const MaterialTurn& turn, const SurfaceColors& colors) {
  if (turn.nothing()) return colors;
  const Vec3 metal = colors.specular - colors.dielectric;
  const Vec3 base = colors.albedo + metal;  // a metal's part and the other are shares of one base colour
  const Vec3 most = 1.0F / glm::clamp(base, Vec3(1e-6F), Vec3(1.0F));
  const Vec3 tint = glm::clamp(turn.tint, Vec3(0.0F), most);
  SurfaceColors result;
  result.albedo = colors.albedo * tint;
  result.dielectric = std::clamp(colors.dielectric * turn.specular_scale + turn.specular_shift, 0.0F, 1.0F);
  result.specular = metal * tint + result.dielectric;
  result.roughness = std::clamp(colors.roughness * turn.roughness_scale + turn.roughness_shift, 0.0F, 1.0F);
  return result;
}

Scene with_materials(Scene scene, const std::vector<MaterialParams>& params) {
  LUM_CHECK(params.empty() || params.size() == scene.materials.size(), "the parameters are of this scene");
  for (std::size_t i = 0; i < params.size(); ++i) {
    const ParamBlock& block = params[i].params;
    if (turn_of(block).nothing()) continue;
    const ParamSchema& schema = block.schema();
    Material& material = scene.materials[i];
    material.roughness = std::clamp(block.scalar(param_of(schema, "roughness")), 0.0F, 1.0F);
    material.specular = std::clamp(block.scalar(param_of(schema, "specular")), 0.0F, 1.0F / kDielectric);
    bake_tint(scene, material, block.vec3(param_of(schema, "tint")));
  }
  return scene;
}

}  // namespace luminist
