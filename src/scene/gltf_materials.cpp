#include "scene/gltf_materials.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "image_io/image_io.h"
#include "scene/gltf_document.h"
#include "scene/texture_image.h"

namespace luminist {
namespace {

constexpr const char* kLineWidthField = ".extras.luminist.line_width_texture";

/// Collects which pictures are wanted in which encoding, reads them together, and makes textures of them.
class Textures {
 public:
  Textures(const tinygltf::Model& model, std::string path, Diagnostics& diagnostics)
      : model_(&model), path_(std::move(path)), diagnostics_(&diagnostics) {}

  [[nodiscard]] const std::string& path() const { return path_; }

  /// Asks for a texture; returns its index in the scene, or -1.
  Result<int> want(int texture, bool color, const std::string& field) {
    if (texture == -1) return -1;
    if (!inside(texture, model_->textures.size())) {
      return Error{ErrorKind::kBadContent, fmt::format("there is no texture {}", texture), path_, field, ""};
    }
    const int image = model_->textures[static_cast<std::size_t>(texture)].source;
    if (!inside(image, model_->images.size())) {
      diagnostics_->warn(path_, fmt::format("textures[{}] has no picture that can be read and is left out", texture));
      return -1;
    }
    LUM_TRY(const std::string_view bytes, bytes_of(image));
    if (bytes.empty()) return -1;
    const auto [entry, is_new] = index_.try_emplace({texture, color}, static_cast<int>(wanted_.size()));
    if (is_new) wanted_.push_back({texture, source({image, color}, bytes)});
    return entry->second;
  }

  /// errors kBadContent naming the picture.
  Result<void> read(Scene& scene) {
    std::vector<Result<Image>> images = read_images(sources_);
    for (const Result<Image>& image : images) {
      if (!image) return image.error();
    }
    for (const Wanted& wanted : wanted_) {
      const tinygltf::Texture& texture = model_->textures[static_cast<std::size_t>(wanted.texture)];
      const tinygltf::Image& image = model_->images[static_cast<std::size_t>(texture.source)];
      Texture made{texture.name.empty() ? image.name : texture.name, as_color(*images[wanted.source]), true, true};
      if (inside(texture.sampler, model_->samplers.size())) {
        const tinygltf::Sampler& sampler = model_->samplers[static_cast<std::size_t>(texture.sampler)];
        made.repeat_u = sampler.wrapS != TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
        made.repeat_v = sampler.wrapT != TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
      }
      scene.textures.push_back(std::move(made));
    }
    return {};
  }

 private:
  struct Wanted {
    int texture = 0;
    std::size_t source = 0;
  };

  /// Nothing, with a warning, for a picture that is not there.
  Result<std::string_view> bytes_of(int index) {
    const tinygltf::Image& image = model_->images[static_cast<std::size_t>(index)];
    if (image.bufferView >= 0) {
      LUM_TRY(const std::string_view bytes, gltf_view(*model_, image.bufferView, path_));
      if (bytes.empty())
        return Error{ErrorKind::kBadContent, "the picture is empty", path_, fmt::format("images[{}]", index), ""};
      return bytes;
    }
    if (image.image.empty() && missing_.insert(index).second) {
      diagnostics_->warn(path_, fmt::format("the texture \"{}\" is not there and is left out", image.uri));
    }
    return std::string_view(reinterpret_cast<const char*>(image.image.data()), image.image.size());
  }
  std::size_t source(std::pair<int, bool> image_and_color, std::string_view bytes) {
    const auto [entry, is_new] = source_.try_emplace(image_and_color, sources_.size());
    if (is_new) {
      const Encoding encoding = image_and_color.second ? Encoding::kAuto : Encoding::kLinear;
      sources_.push_back({fmt::format("{} (images[{}])", path_, image_and_color.first), bytes, encoding});
    }
    return entry->second;
  }

  const tinygltf::Model* model_;
  std::string path_;
  Diagnostics* diagnostics_;
  std::map<std::pair<int, bool>, int> index_;           ///< texture, is colour -> index into wanted_
  std::map<std::pair<int, bool>, std::size_t> source_;  ///< image, is colour -> index into sources_
  std::set<int> missing_;
  std::vector<Wanted> wanted_;
  std::vector<ImageSource> sources_;
};

Vec3 color_of(const std::vector<double>& values, const Vec3& otherwise) {
  if (values.size() < 3) return otherwise;
  return glm::max(Vec3(glm::dvec3(values[0], values[1], values[2])), Vec3(0.0F));
}

float emissive_strength(const tinygltf::Material& material) {
  const auto extension = material.extensions.find("KHR_materials_emissive_strength");
  if (extension == material.extensions.end() || !extension->second.Has("emissiveStrength")) return 1.0F;
  return std::max(static_cast<float>(extension->second.Get("emissiveStrength").GetNumberAsDouble()), 0.0F);
}

/// The factor of the reflectance at normal incidence, up to that of a perfect mirror; its colour counts as its mean.
float specular_factor(const tinygltf::Material& material) {
  const auto extension = material.extensions.find("KHR_materials_specular");
  if (extension == material.extensions.end()) return 1.0F;
  double factor = 1.0;
  if (extension->second.Has("specularFactor")) {
    factor = std::clamp(extension->second.Get("specularFactor").GetNumberAsDouble(), 0.0, 1.0);
  }
  if (!extension->second.Has("specularColorFactor")) return static_cast<float>(factor);
  const tinygltf::Value& color = extension->second.Get("specularColorFactor");
  double sum = 0.0;
  for (int c = 0; c < 3; ++c) {
    const tinygltf::Value value = c < static_cast<int>(color.ArrayLen()) ? color.Get(c) : tinygltf::Value(1.0);
    sum += value.IsNumber() ? std::clamp(value.GetNumberAsDouble(), 0.0, 1.0 / kDielectric) : 1.0;
  }
  return static_cast<float>(factor * sum / 3.0);
}

float unit(double value) {
  return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

/// The texture that extras name, or -1.
Result<int> line_width_texture(const tinygltf::Material& material, const std::string& field, const std::string& path) {
  const tinygltf::Value& extras = material.extras;
  if (!extras.IsObject() || !extras.Has("luminist")) return -1;
  const tinygltf::Value& ours = extras.Get("luminist");
  if (!ours.IsObject() || !ours.Has("line_width_texture")) return -1;
  const tinygltf::Value& index = ours.Get("line_width_texture");
  if (index.IsInt() && index.GetNumberAsInt() >= 0) return index.GetNumberAsInt();
  return Error{ErrorKind::kBadContent, "this is no texture's index", path, field + kLineWidthField,
               "give the place of one in the file's textures, from 0"};
}

Result<Material> material_of(const tinygltf::Material& from, const std::string& field, Textures& textures) {
  Material to;
  to.name = from.name;
  to.base_color = color_of(from.pbrMetallicRoughness.baseColorFactor, Vec3(1.0F));
  to.metallic = unit(from.pbrMetallicRoughness.metallicFactor);
  to.roughness = unit(from.pbrMetallicRoughness.roughnessFactor);
  to.specular = specular_factor(from);
  to.emissive = color_of(from.emissiveFactor, Vec3(0.0F)) * emissive_strength(from);
  to.normal_scale = static_cast<float>(from.normalTexture.scale);
  to.double_sided = from.doubleSided;
  LUM_TRY(to.base_color_texture,
          textures.want(from.pbrMetallicRoughness.baseColorTexture.index, true, field + ".baseColorTexture"));
  LUM_TRY(to.metallic_roughness_texture, textures.want(from.pbrMetallicRoughness.metallicRoughnessTexture.index, false,
                                                       field + ".metallicRoughnessTexture"));
  LUM_TRY(to.normal_texture, textures.want(from.normalTexture.index, false, field + ".normalTexture"));
  LUM_TRY(to.emissive_texture, textures.want(from.emissiveTexture.index, true, field + ".emissiveTexture"));
  LUM_TRY(const int mask, line_width_texture(from, field, textures.path()));
  LUM_TRY(to.line_width_texture, textures.want(mask, false, field + kLineWidthField));
  return to;
}

}  // namespace

Result<void> add_gltf_materials(const tinygltf::Model& model, const std::string& path, Scene& scene,
                                Diagnostics& diagnostics) {
  Textures textures(model, path, diagnostics);
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    LUM_TRY(Material material, material_of(model.materials[i], fmt::format("materials[{}]", i), textures));
    scene.materials.push_back(std::move(material));
  }
  return textures.read(scene);
}

int gltf_uv_set(const tinygltf::Model& model, int material) {
  if (!inside(material, model.materials.size())) return 0;
  const tinygltf::Material& m = model.materials[static_cast<std::size_t>(material)];
  if (m.pbrMetallicRoughness.baseColorTexture.index >= 0) return m.pbrMetallicRoughness.baseColorTexture.texCoord;
  if (m.normalTexture.index >= 0) return m.normalTexture.texCoord;
  return m.pbrMetallicRoughness.metallicRoughnessTexture.texCoord;
}

}  // namespace luminist
