#include "rig/light_type.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "params/toml_reader.h"

namespace luminist {
namespace {

constexpr const char* kFolder = "shaders/light";

/// Keys of a light in a rig file that are no parameters.
constexpr std::array<std::string_view, 5> kRigKeys = {"name", "type", "group", "muted", "unlocked"};

bool is_type_name(std::string_view name) {
  return !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string_view::npos &&
         std::islower(static_cast<unsigned char>(name[0])) != 0 && name.find("__") == std::string_view::npos;
}

ShadowKind read_shadow(TomlReader& read) {
  const std::string word = read.string("shadow");
  if (word == "none") return ShadowKind::kNone;
  if (word == "spot") return ShadowKind::kSpot;
  if (word == "cube") return ShadowKind::kCube;
  if (word == "sun") return ShadowKind::kSun;
  read.fail("shadow", fmt::format("unknown shadow \"{}\"", word), "one of none, spot, cube, sun");
  return ShadowKind::kNone;
}

/// Reads everything but the GLSL's path. is_type: the manifest declares a light type, not the ambient block.
Result<LightType> read_manifest(const std::filesystem::path& path, bool is_type) {
  LUM_TRY(const std::string text, read_file(path));
  LightType type;
  type.name = path.stem().string();
  LUM_TRY(type.schema, ParamSchema::parse(text, path.string()));
  LUM_TRY(const TomlValue document, parse_toml(text, path.string(), ErrorKind::kStyle));
  TomlReader read(document, path.string(), ErrorKind::kStyle);
  type.doc = read.string("doc");
  if (is_type) type.shadow = read_shadow(read);
  const std::span<const TomlValue> params = read.tables("param");
  for (int i = 0; i < type.schema->size(); ++i) {
    const std::string& name = (*type.schema)[i].name;
    if (std::find(kRigKeys.begin(), kRigKeys.end(), name) == kRigKeys.end()) continue;
    read.fail_at(params[static_cast<std::size_t>(i)], name, "rig files use this name for a key of their own",
                 "rename the parameter");
  }
  LUM_TRY_VOID(read.finish());
  return type;
}

}  // namespace

std::string LightType::struct_name() const {
  std::string camel;
  bool start = true;
  for (const char c : name) {
    if (c != '_') camel += start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    start = c == '_';
  }
  return camel;
}

Result<LightTypes> LightTypes::load(const AssetRoots& roots) {
  LightTypes types;
  for (const std::string& file : roots.list(kFolder, ".toml")) {
    const std::filesystem::path relative = std::filesystem::path(kFolder) / file;
    LUM_TRY(const std::filesystem::path path, roots.find(relative));
    const bool is_type = file != "ambient.toml";
    LUM_TRY(LightType type, read_manifest(path, is_type));
    if (!is_type) {
      types.ambient_ = type.schema;
      continue;
    }
    if (!is_type_name(type.name)) {
      return Error{ErrorKind::kStyle, fmt::format("\"{}\" is no name for a light type", type.name), path.string(), "",
                   "use lower-case letters, digits and single underscores, a letter first"};
    }
    LUM_TRY(const std::filesystem::path glsl, roots.find(std::filesystem::path(relative).replace_extension(".glsl")));
    type.glsl_path = glsl.string();
    types.types_.push_back(std::move(type));
  }
  if (types.types_.empty() || types.ambient_ == nullptr) {
    return Error{ErrorKind::kMissing, types.types_.empty() ? "there are no light types" : "ambient.toml is missing",
                 kFolder, "", "set LUMINIST_ROOT to the program's own files"};
  }
  return types;
}

const LightType* LightTypes::find(const std::string& name) const {
  const int position = index(name);
  return position < 0 ? nullptr : &types_[static_cast<std::size_t>(position)];
}

int LightTypes::index(const std::string& name) const {
  const auto hit = std::find_if(types_.begin(), types_.end(), [&](const LightType& type) { return type.name == name; });
  return hit == types_.end() ? -1 : static_cast<int>(hit - types_.begin());
}

std::vector<std::string> LightTypes::names() const {
  std::vector<std::string> list;
  for (const LightType& type : types_) list.push_back(type.name);
  return list;
}

}  // namespace luminist
