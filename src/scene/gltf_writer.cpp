#include <tiny_gltf.h>

#include <exception>
#include <map>
#include <new>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/files.h"
#include "image_io/image_io.h"
#include "scene/scene.h"

namespace luminist {
namespace {

constexpr int kNoMaterial = -1;  // as glTF has it

/// Fills a tinygltf::Model whose one buffer becomes the binary chunk. Everything is added in the scene's order, so that
/// equal scenes give equal bytes.
class GltfWriter {
 public:
  explicit GltfWriter(const Scene& scene) : scene_(&scene) {}
  Result<std::string> write();

 private:
  template <class Vector>
  int add_vectors(const std::vector<Vector>& values, int type, int target = TINYGLTF_TARGET_ARRAY_BUFFER);
  int add_view(const void* bytes, std::size_t size, int target);
  Result<void> add_textures();
  void add_materials();
  void use_extension(const std::string& name);
  int mesh_index(int mesh, int material);
  void add_objects();
  void add_cameras();
  void add_lights();
  /// A thing's own node, in the world or under the one it hangs from.
  int add_node(const std::string& name, const Mat4& world_from_node, const Mount& mount);
  /// Under another node, or with -1 in the world. returns its index.
  int hang_node(tinygltf::Node node, int parent);
  void add_moving_nodes();
  void add_tracks();

  /// The accessors of one mesh, shared by the glTF meshes that show it in different materials.
  struct Accessors {
    std::map<std::string, int> attributes;
    int indices = -1;
  };

  const Scene* scene_;
  tinygltf::Model model_;
  std::map<int, Accessors> accessors_;
  std::map<std::pair<int, int>, int> mesh_of_;  ///< mesh, material -> glTF mesh
};

int GltfWriter::add_view(const void* bytes, std::size_t size, int target) {
  std::vector<unsigned char>& data = model_.buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = data.size();
  view.byteLength = size;
  view.target = target;
  const auto* first = static_cast<const unsigned char*>(bytes);
  data.insert(data.end(), first, first + size);
  while (data.size() % 4 != 0) data.push_back(0);
  model_.bufferViews.push_back(std::move(view));
  return static_cast<int>(model_.bufferViews.size()) - 1;
}

template <class Vector>
int GltfWriter::add_vectors(const std::vector<Vector>& values, int type, int target) {
  tinygltf::Accessor accessor;
  accessor.bufferView = add_view(values.data(), values.size() * sizeof(Vector), target);
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  accessor.type = type;
  accessor.count = values.size();
  model_.accessors.push_back(std::move(accessor));
  return static_cast<int>(model_.accessors.size()) - 1;
}

/// A texture is data (a normal map, roughness, line widths) or colour by who uses it; only colour is stored with a
/// transfer curve.
Result<void> GltfWriter::add_textures() {
  std::vector<bool> is_data(scene_->textures.size());
  for (const Material& m : scene_->materials) {
    for (const int index : {m.normal_texture, m.metallic_roughness_texture, m.line_width_texture}) {
      if (index >= 0) is_data[static_cast<std::size_t>(index)] = true;
    }
  }
  for (std::size_t i = 0; i < scene_->textures.size(); ++i) {
    const Texture& texture = scene_->textures[i];
    LUM_TRY(const std::string png, encode_png(texture.image, is_data[i] ? Encoding::kLinear : Encoding::kSrgb));
    tinygltf::Image image;
    image.name = texture.name;
    image.mimeType = "image/png";
    image.bufferView = add_view(png.data(), png.size(), 0);
    model_.images.push_back(std::move(image));
    tinygltf::Sampler sampler;
    sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
    sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
    sampler.wrapS = texture.repeat_u ? TINYGLTF_TEXTURE_WRAP_REPEAT : TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    sampler.wrapT = texture.repeat_v ? TINYGLTF_TEXTURE_WRAP_REPEAT : TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    model_.samplers.push_back(sampler);
    tinygltf::Texture reference;
    reference.name = texture.name;
    reference.source = reference.sampler = static_cast<int>(i);
    model_.textures.push_back(std::move(reference));
  }
  return {};
}

void GltfWriter::use_extension(const std::string& name) {
  std::vector<std::string>& used = model_.extensionsUsed;
  if (std::ranges::find(used, name) == used.end()) used.push_back(name);
}

void GltfWriter::add_materials() {
  for (const Material& from : scene_->materials) {
    tinygltf::Material to;
    to.name = from.name;
    to.pbrMetallicRoughness.baseColorFactor = {from.base_color.x, from.base_color.y, from.base_color.z, 1.0};
    to.pbrMetallicRoughness.metallicFactor = from.metallic;
    to.pbrMetallicRoughness.roughnessFactor = from.roughness;
    to.pbrMetallicRoughness.baseColorTexture.index = from.base_color_texture;
    to.pbrMetallicRoughness.metallicRoughnessTexture.index = from.metallic_roughness_texture;
    to.normalTexture.index = from.normal_texture;
    to.normalTexture.scale = from.normal_scale;
    to.emissiveTexture.index = from.emissive_texture;
    // Factors above 1 need the extension.
    const float strength = std::max({1.0F, from.emissive.x, from.emissive.y, from.emissive.z});
    const Vec3 emissive = from.emissive / strength;
    to.emissiveFactor = {emissive.x, emissive.y, emissive.z};
    if (strength > 1.0F) {
      tinygltf::Value::Object value{{"emissiveStrength", tinygltf::Value(static_cast<double>(strength))}};
      to.extensions["KHR_materials_emissive_strength"] = tinygltf::Value(std::move(value));
      use_extension("KHR_materials_emissive_strength");
    }
    if (from.specular != 1.0F) {
      // The colour may exceed 1, and leaves the reflectance at grazing angles alone.
      const tinygltf::Value factor(static_cast<double>(from.specular));
      tinygltf::Value::Object value{{"specularColorFactor", tinygltf::Value(tinygltf::Value::Array(3, factor))}};
      to.extensions["KHR_materials_specular"] = tinygltf::Value(std::move(value));
      use_extension("KHR_materials_specular");
    }
    to.doubleSided = from.double_sided;
    if (from.line_width_texture >= 0) {
      tinygltf::Value::Object mask{{"line_width_texture", tinygltf::Value(from.line_width_texture)}};
      tinygltf::Value::Object ours{{"luminist", tinygltf::Value(std::move(mask))}};
      to.extras = tinygltf::Value(std::move(ours));
    }
    model_.materials.push_back(std::move(to));
  }
}

int GltfWriter::mesh_index(int mesh, int material) {
  const auto [entry, is_new] = mesh_of_.try_emplace({mesh, material}, static_cast<int>(model_.meshes.size()));
  if (!is_new) return entry->second;
  const auto [shared, is_first] = accessors_.try_emplace(mesh);
  Accessors& accessors = shared->second;
  if (is_first) {
    const Mesh& from = scene_->meshes[static_cast<std::size_t>(mesh)];
    const int positions = add_vectors(from.positions, TINYGLTF_TYPE_VEC3);
    const Box box = from.bounds();  // the format wants it of positions
    model_.accessors.back().minValues = {box.lo.x, box.lo.y, box.lo.z};
    model_.accessors.back().maxValues = {box.hi.x, box.hi.y, box.hi.z};
    accessors.attributes["POSITION"] = positions;
    if (!from.normals.empty()) accessors.attributes["NORMAL"] = add_vectors(from.normals, TINYGLTF_TYPE_VEC3);
    if (!from.tangents.empty()) accessors.attributes["TANGENT"] = add_vectors(from.tangents, TINYGLTF_TYPE_VEC4);
    if (!from.line_widths.empty()) {
      std::vector<Vec4> colors;
      for (const float width : from.line_widths) colors.emplace_back(1.0F, 1.0F, 1.0F, width);
      accessors.attributes["COLOR_0"] = add_vectors(colors, TINYGLTF_TYPE_VEC4);
    }
    if (!from.uvs.empty()) accessors.attributes["TEXCOORD_0"] = add_vectors(from.uvs, TINYGLTF_TYPE_VEC2);
    tinygltf::Accessor indices;
    indices.bufferView = add_view(from.triangles.data(), from.triangles.size() * sizeof(from.triangles[0]),
                                  TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    indices.type = TINYGLTF_TYPE_SCALAR;
    indices.count = 3 * from.triangles.size();
    model_.accessors.push_back(std::move(indices));
    accessors.indices = static_cast<int>(model_.accessors.size()) - 1;
  }
  tinygltf::Primitive primitive;
  primitive.attributes = accessors.attributes;
  primitive.indices = accessors.indices;
  primitive.material = material;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  tinygltf::Mesh made;
  made.primitives.push_back(std::move(primitive));
  model_.meshes.push_back(std::move(made));
  return entry->second;
}

int GltfWriter::add_node(const std::string& name, const Mat4& world_from_node, const Mount& mount) {
  const Mat4& matrix = mount.node >= 0 ? mount.node_from_thing : world_from_node;
  tinygltf::Node node;
  node.name = name;
  if (matrix != Mat4(1.0F)) {
    for (int i = 0; i < 16; ++i) node.matrix.push_back(matrix[i / 4][i % 4]);
  }
  return hang_node(std::move(node), mount.node);
}

int GltfWriter::hang_node(tinygltf::Node node, int parent) {
  const auto index = static_cast<int>(model_.nodes.size());
  model_.nodes.push_back(std::move(node));
  auto& siblings = parent >= 0 ? model_.nodes[static_cast<std::size_t>(parent)].children : model_.scenes[0].nodes;
  siblings.push_back(index);
  return index;
}

/// First of all nodes, so that a mount's node is its index in the file.
void GltfWriter::add_moving_nodes() {
  for (const Node& from : scene_->animation.nodes) {
    tinygltf::Node node;
    node.name = from.name;
    if (from.matrix) {
      for (int i = 0; i < 16; ++i) node.matrix.push_back((*from.matrix)[i / 4][i % 4]);
    } else {
      node.translation = {from.translation.x, from.translation.y, from.translation.z};
      node.rotation = {from.rotation.x, from.rotation.y, from.rotation.z, from.rotation.w};
      node.scale = {from.scale.x, from.scale.y, from.scale.z};
    }
    hang_node(std::move(node), from.parent);
  }
}

void GltfWriter::add_tracks() {
  if (scene_->animation.tracks.empty()) return;
  tinygltf::Animation animation;
  for (const Track& track : scene_->animation.tracks) {
    tinygltf::AnimationSampler sampler;
    sampler.interpolation = track.interpolation == Track::Interpolation::kStep     ? "STEP"
                            : track.interpolation == Track::Interpolation::kLinear ? "LINEAR"
                                                                                   : "CUBICSPLINE";
    sampler.input = add_vectors(track.times, TINYGLTF_TYPE_SCALAR, 0);
    model_.accessors.back().minValues = {track.times.front()};
    model_.accessors.back().maxValues = {track.times.back()};
    if (track.property == Track::Property::kRotation) {
      sampler.output = add_vectors(track.values, TINYGLTF_TYPE_VEC4, 0);
    } else {
      sampler.output = add_vectors(std::vector<Vec3>(track.values.begin(), track.values.end()), TINYGLTF_TYPE_VEC3, 0);
    }
    tinygltf::AnimationChannel channel;
    channel.sampler = static_cast<int>(animation.samplers.size());
    channel.target_node = track.node;
    channel.target_path = track.property == Track::Property::kTranslation ? "translation"
                          : track.property == Track::Property::kRotation  ? "rotation"
                                                                          : "scale";
    animation.samplers.push_back(std::move(sampler));
    animation.channels.push_back(std::move(channel));
  }
  model_.animations.push_back(std::move(animation));
}

void GltfWriter::add_objects() {
  for (const Object& object : scene_->objects) {
    const int mesh = mesh_index(object.mesh, object.material);
    const int index = add_node(object.name, object.world_from_object, object.mount);
    model_.nodes[static_cast<std::size_t>(index)].mesh = mesh;
    tinygltf::Value::Object extras;
    if (object.backdrop) extras["backdrop"] = tinygltf::Value(true);
    if (object.shadow_mesh >= 0) {
      const tinygltf::Value shadow(mesh_index(object.shadow_mesh, kNoMaterial));
      extras["luminist"] = tinygltf::Value(tinygltf::Value::Object{{"shadow_mesh", shadow}});
    }
    if (!extras.empty()) model_.nodes[static_cast<std::size_t>(index)].extras = tinygltf::Value(extras);
  }
}

void GltfWriter::add_cameras() {
  for (const Camera& from : scene_->cameras) {
    tinygltf::Camera camera;
    camera.type = "perspective";
    camera.name = from.name;
    camera.perspective.yfov = from.fov_y;
    camera.perspective.znear = from.near_plane;
    camera.perspective.zfar = from.far_plane;
    model_.cameras.push_back(std::move(camera));
    model_.nodes[static_cast<std::size_t>(add_node(from.name, from.world_from_camera, from.mount))].camera =
        static_cast<int>(model_.cameras.size()) - 1;
  }
}

void GltfWriter::add_lights() {
  for (const PunctualLight& from : scene_->lights) {
    tinygltf::Light light;
    light.name = from.name;
    light.type = from.kind == PunctualLight::Kind::kPoint
                     ? "point"
                     : (from.kind == PunctualLight::Kind::kSpot ? "spot" : "directional");
    light.color = {from.color.x, from.color.y, from.color.z};
    light.intensity = from.intensity;
    light.range = from.range;
    light.spot.innerConeAngle = from.inner_angle;
    light.spot.outerConeAngle = from.outer_angle;
    model_.lights.push_back(std::move(light));
    const int place = add_node(from.name, from.world_from_light(), from.mount);
    tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(place)];
    const auto index = static_cast<int>(model_.lights.size()) - 1;
    node.extensions["KHR_lights_punctual"] =
        tinygltf::Value(tinygltf::Value::Object{{"light", tinygltf::Value(index)}});
  }
}

Result<std::string> GltfWriter::write() {
  model_.asset.version = "2.0";
  model_.asset.generator = "Luminist";
  model_.buffers.resize(1);
  model_.scenes.resize(1);
  model_.defaultScene = 0;
  LUM_TRY_VOID(add_textures());
  add_materials();
  add_moving_nodes();
  add_objects();
  add_cameras();
  add_lights();
  add_tracks();
  if (model_.buffers[0].data.empty()) model_.buffers.clear();
  std::ostringstream stream(std::ios::binary);
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToStream(&model_, stream, false, true)) {
    return Error{ErrorKind::kUnwritable, "the scene cannot be written as a GLB", "", "", ""};
  }
  return std::move(stream).str();
}

}  // namespace

Result<void> save_scene(const Scene& scene, const std::string& path) {
  try {
    auto bytes = GltfWriter(scene).write();
    if (!bytes) {
      Error error = bytes.error();
      error.where = path;
      return error;
    }
    return write_file_atomic(path, *bytes);
  } catch (const std::bad_alloc&) {
    throw;  // not the file's fault: the command line reports it as its own kind
  } catch (const std::exception& e) {
    return Error{ErrorKind::kUnwritable, fmt::format("the scene cannot be written: {}", e.what()), path, "", ""};
  }
}

}  // namespace luminist
