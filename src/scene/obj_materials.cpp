#include "scene/obj_materials.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <istream>
#include <utility>

#include <fmt/format.h>

#include "base/files.h"
#include "image_io/image_io.h"
#include "scene/obj_lines.h"
#include "scene/texture_image.h"

namespace luminist {
namespace {

/// Writers on Windows put backslashes there.
std::string portable(const std::string& reference) {
  std::string result = trimmed(reference);
  std::replace(result.begin(), result.end(), '\\', '/');
  return result;
}

float finite_or(float value, float otherwise) {
  return std::isfinite(value) ? value : otherwise;
}

Vec3 color_of(const float (&rgb)[3]) {
  return {std::max(finite_or(rgb[0], 0.0F), 0.0F), std::max(finite_or(rgb[1], 0.0F), 0.0F),
          std::max(finite_or(rgb[2], 0.0F), 0.0F)};
}

ObjMaterial converted(const tinyobj::material_t& from) {
  ObjMaterial to;
  Material& m = to.material;
  m.name = trimmed(from.name);
  m.base_color = color_of(from.diffuse);
  m.emissive = color_of(from.emission);
  const float shininess = finite_or(from.shininess, 1.0F);
  if (from.roughness > 0.0F || from.metallic > 0.0F) {  // the physically based extension: Pr, Pm
    m.roughness = std::clamp(from.roughness, 0.0F, 1.0F);
    m.metallic = std::clamp(from.metallic, 0.0F, 1.0F);
  } else if (shininess > 1.0F) {  // 1 is the parser's default
    // The Blinn-Phong lobe of exponent n is as wide as a microfacet lobe of alpha = roughness^2 = sqrt(2 / (n + 2)).
    m.roughness = std::clamp(std::sqrt(std::sqrt(2.0F / (shininess + 2.0F))), 0.05F, 1.0F);
  }
  to.base_color = portable(from.diffuse_texname);
  to.roughness = portable(from.roughness_texname);
  to.metallic = portable(from.metallic_texname);
  to.normal = portable(from.normal_texname);
  to.emissive = portable(from.emissive_texname);
  // Many writers leave the factor black when a texture gives the colour.
  if (!to.base_color.empty() && m.base_color == Vec3(0.0F)) m.base_color = Vec3(1.0F);
  if (!to.emissive.empty() && m.emissive == Vec3(0.0F)) m.emissive = Vec3(1.0F);
  if (!to.roughness.empty()) m.roughness = 1.0F;
  if (!to.metallic.empty()) m.metallic = 1.0F;
  return to;
}

/// The texture files of some materials, each read once.
class TextureFiles {
 public:
  TextureFiles(std::string obj_path, Diagnostics& diagnostics)
      : obj_path_(std::move(obj_path)), diagnostics_(&diagnostics) {}

  /// Asks for a file; returns its number, or -1 if there is none.
  Result<int> want(const std::string& reference, Encoding encoding) {
    if (reference.empty()) return -1;
    const auto resolved = resolve_beside(obj_path_, reference);
    if (!resolved && resolved.error().kind == ErrorKind::kMissing) {
      diagnostics_->warn(obj_path_, fmt::format("the texture \"{}\" is not there and is left out", reference));
      return -1;
    }
    if (!resolved) return resolved.error();
    const ImageSource source{resolved->string(), {}, encoding};
    const auto same = [&](const ImageSource& s) { return s.name == source.name && s.encoding == encoding; };
    const auto found = std::find_if(sources_.begin(), sources_.end(), same);
    if (found != sources_.end()) return static_cast<int>(found - sources_.begin());
    sources_.push_back(source);
    return static_cast<int>(sources_.size()) - 1;
  }

  Result<void> read() {
    for (Result<Image>& image : read_images(sources_)) {
      if (!image) return std::move(image).error();
      images_.push_back(std::move(image).value());
    }
    return {};
  }
  [[nodiscard]] std::string name(int file) const {
    return std::filesystem::path(sources_[static_cast<std::size_t>(file)].name).stem().string();
  }
  [[nodiscard]] const Image& image(int file) const { return images_[static_cast<std::size_t>(file)]; }

 private:
  std::string obj_path_;
  Diagnostics* diagnostics_;
  std::vector<ImageSource> sources_;
  std::vector<Image> images_;
};

/// One picture with roughness in green and metallic in blue; a missing one is white.
Image packed(const Image* roughness, const Image* metallic) {
  const Image& size = roughness != nullptr ? *roughness : *metallic;
  Image result(size.width, size.height, 3, 1.0F);
  const Image other = metallic != nullptr ? resized(*metallic, size.width, size.height) : Image();
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (roughness != nullptr) result.at(x, y, 1) = roughness->at(x, y, 0);
      if (metallic != nullptr) result.at(x, y, 2) = other.at(x, y, 0);
    }
  }
  return result;
}

}  // namespace

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

Result<void> read_mtl(const std::string& obj_path, const std::string& reference,
                      std::map<std::string, ObjMaterial>& materials) {
  LUM_TRY(const auto path, resolve_beside(obj_path, portable(reference)));
  LUM_TRY(std::string text, read_file(path));
  ObjLines lines(std::move(text));
  std::istream stream(&lines);
  std::map<std::string, int> names;
  std::vector<tinyobj::material_t> parsed;
  std::string warnings, errors;
  tinyobj::LoadMtl(&names, &parsed, &stream, &warnings, &errors);
  for (const tinyobj::material_t& material : parsed) {
    ObjMaterial converted_material = converted(material);
    const std::string name = converted_material.material.name;
    materials.insert_or_assign(name, std::move(converted_material));
  }
  return {};
}

Result<void> add_obj_materials(const std::string& obj_path, const std::vector<ObjMaterial>& used, Scene& scene,
                               Diagnostics& diagnostics) {
  struct Files {
    int base_color, roughness, metallic, normal, emissive;
  };
  TextureFiles files(obj_path, diagnostics);
  std::vector<Files> wanted;
  for (const ObjMaterial& material : used) {
    LUM_TRY(const int base_color, files.want(material.base_color, Encoding::kAuto));
    LUM_TRY(const int roughness, files.want(material.roughness, Encoding::kLinear));
    LUM_TRY(const int metallic, files.want(material.metallic, Encoding::kLinear));
    LUM_TRY(const int normal, files.want(material.normal, Encoding::kLinear));
    LUM_TRY(const int emissive, files.want(material.emissive, Encoding::kAuto));
    wanted.push_back({base_color, roughness, metallic, normal, emissive});
  }
  LUM_TRY_VOID(files.read());

  std::map<std::pair<int, int>, int> textures;  // file, or pair of files packed into one -> index
  const auto texture = [&](int first, int second, auto make_image) {
    const auto [entry, is_new] = textures.try_emplace({first, second}, static_cast<int>(scene.textures.size()));
    if (is_new) scene.textures.push_back({files.name(first >= 0 ? first : second), make_image(), true, true});
    return entry->second;
  };
  constexpr int kAlone = -2;
  for (std::size_t i = 0; i < used.size(); ++i) {
    Material material = used[i].material;
    const Files& f = wanted[i];
    const auto color = [&](int file) {
      return file < 0 ? -1 : texture(file, kAlone, [&] { return as_color(files.image(file)); });
    };
    material.base_color_texture = color(f.base_color);
    material.normal_texture = color(f.normal);
    material.emissive_texture = color(f.emissive);
    if (f.roughness >= 0 || f.metallic >= 0) {
      material.metallic_roughness_texture = texture(f.roughness, f.metallic, [&] {
        return packed(f.roughness >= 0 ? &files.image(f.roughness) : nullptr,
                      f.metallic >= 0 ? &files.image(f.metallic) : nullptr);
      });
    }
    scene.materials.push_back(material);
  }
  return {};
}

}  // namespace luminist
