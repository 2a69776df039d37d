#include <tiny_gltf.h>

#include <algorithm>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include "base/files.h"
#include "scene/gltf_animation.h"
#include "scene/gltf_deform.h"
#include "scene/gltf_document.h"
#include "scene/gltf_lights.h"
#include "scene/gltf_materials.h"
#include "scene/gltf_triangles.h"
#include "scene/readers.h"

namespace luminist {
namespace {

constexpr int kDeepestNode = 64;

class GltfReader {
 public:
  GltfReader(std::string path, const tinygltf::Model& model, Diagnostics& diagnostics)
      : path_(std::move(path)), model_(&model), diagnostics_(&diagnostics), place_of_(model.nodes.size(), -1) {}

  Result<Scene> read();

 private:
  [[nodiscard]] Error bad(std::string what, std::string field) const {
    return {ErrorKind::kBadContent, std::move(what), path_, std::move(field), ""};
  }
  void warn(std::string what) { diagnostics_->warn(path_, std::move(what)); }

  Result<void> refuse_unknown_compression() const;
  [[nodiscard]] std::vector<int> roots() const;
  Result<void> add_node(int index, int parent, const Mat4& world_from_parent, int depth);
  Result<Node> local_frame(int index) const;
  Result<void> add_objects(const tinygltf::Node& node, int place, const Mat4& world_from_node);
  Result<int> mesh_index(int mesh, std::size_t primitive);
  /// The mesh of a primitive that deforms, whose deformer is then the last of the scene's; -1: it is no surface.
  Result<int> own_mesh(const tinygltf::Node& node, std::size_t primitive);
  void hang_deformer(const tinygltf::Node& node, int place, Object& object);
  /// What extras.luminist.shadow_mesh of a node names, or -1.
  Result<int> shadow_mesh(const tinygltf::Node& node);
  Result<std::optional<Mesh>> read_primitive(const tinygltf::Primitive& primitive, const std::string& field);
  Result<void> read_attributes(const tinygltf::Primitive& primitive, const std::string& field, Mesh& mesh) const;
  void add_camera(const tinygltf::Node& node, int place, const Mat4& world_from_node);
  void find_joints();
  int default_material();

  std::string path_;
  const tinygltf::Model* model_;
  Diagnostics* diagnostics_;
  Scene scene_;
  std::vector<int> place_of_;  ///< of each glTF node among the scene's; -1: not met yet
  std::map<std::pair<int, std::size_t>, int> mesh_of_primitive_;  ///< -1: nothing to show
  std::map<int, int> shadow_mesh_of_;                             ///< of a glTF mesh of several primitives, joined
  int default_material_ = -1;
};

Result<void> GltfReader::refuse_unknown_compression() const {
  for (const std::string& extension : model_->extensionsRequired) {
    if (extension == "KHR_draco_mesh_compression" || extension == "EXT_meshopt_compression") {
      return Error{ErrorKind::kBadContent, "the file needs the extension " + extension, path_, "extensionsRequired",
                   "export it without compression"};
    }
  }
  return {};
}

std::vector<int> GltfReader::roots() const {
  if (!model_->scenes.empty()) {
    const int scene = inside(model_->defaultScene, model_->scenes.size()) ? model_->defaultScene : 0;
    return model_->scenes[static_cast<std::size_t>(scene)].nodes;
  }
  std::vector<bool> has_parent(model_->nodes.size());
  for (const tinygltf::Node& node : model_->nodes) {
    for (const int child : node.children) {
      if (inside(child, has_parent.size())) has_parent[static_cast<std::size_t>(child)] = true;
    }
  }
  std::vector<int> result;
  for (std::size_t i = 0; i < has_parent.size(); ++i) {
    if (!has_parent[i]) result.push_back(static_cast<int>(i));
  }
  return result;
}

Result<Node> GltfReader::local_frame(int index) const {
  const tinygltf::Node& from = model_->nodes[static_cast<std::size_t>(index)];
  const auto has_size = [](const std::vector<double>& v, std::size_t size) { return v.empty() || v.size() == size; };
  if (!has_size(from.matrix, 16) || !has_size(from.translation, 3) || !has_size(from.rotation, 4) ||
      !has_size(from.scale, 3)) {
    return bad("a transform has a wrong number of values", fmt::format("nodes[{}]", index));
  }
  Node node;
  if (!from.matrix.empty()) {
    glm::dmat4 m(1.0);
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = from.matrix[static_cast<std::size_t>(i)];
    node.matrix = Mat4(m);
    return node;
  }
  if (!from.rotation.empty()) {
    const glm::dquat q(from.rotation[3], from.rotation[0], from.rotation[1], from.rotation[2]);
    if (glm::length(q) > 0.0) node.rotation = glm::quat(glm::normalize(q));
  }
  for (int i = 0; i < 3 && !from.scale.empty(); ++i) {
    node.scale[i] = static_cast<float>(from.scale[static_cast<std::size_t>(i)]);
  }
  for (int i = 0; i < 3 && !from.translation.empty(); ++i) {
    node.translation[i] = static_cast<float>(from.translation[static_cast<std::size_t>(i)]);
  }
  return node;
}

Result<void> GltfReader::add_node(int index, int parent, const Mat4& world_from_parent, int depth) {
  const std::string field = fmt::format("nodes[{}]", index);
  if (!inside(index, model_->nodes.size())) return bad("there is no such node", field);
  if (depth > kDeepestNode) return bad(fmt::format("nodes nest deeper than {} levels", kDeepestNode), field);
  int& place = place_of_[static_cast<std::size_t>(index)];
  if (place >= 0) return bad("a node has two parents or is its own ancestor", field);
  LUM_TRY(Node frame, local_frame(index));
  const Mat4 world = world_from_parent * local_matrix(frame);
  const float volume = std::abs(glm::determinant(Mat3(world)));
  if (!std::isfinite(volume) || !is_finite(Vec3(world[3]))) return bad("the transform is not finite", field);
  const int here = place = static_cast<int>(scene_.animation.nodes.size());
  frame.parent = parent;
  frame.name = model_->nodes[static_cast<std::size_t>(index)].name;
  scene_.animation.nodes.push_back(frame);
  const tinygltf::Node& node = model_->nodes[static_cast<std::size_t>(index)];
  if (volume > 0.0F) {
    if (node.mesh >= 0) LUM_TRY_VOID(add_objects(node, here, world));
    if (node.camera >= 0) add_camera(node, here, world);
    add_gltf_light(*model_, node, here, world, path_, scene_, *diagnostics_);
  } else {
    warn(fmt::format("{} is scaled to nothing and is left out", field));
  }
  for (const int child : node.children) LUM_TRY_VOID(add_node(child, here, world, depth + 1));
  return {};
}

int GltfReader::default_material() {
  if (default_material_ < 0) {
    default_material_ = static_cast<int>(scene_.materials.size());
    scene_.materials.push_back({.name = "default"});
  }
  return default_material_;
}

Result<void> GltfReader::add_objects(const tinygltf::Node& node, int place, const Mat4& world_from_node) {
  if (!inside(node.mesh, model_->meshes.size()))
    return bad("there is no such mesh", fmt::format("meshes[{}]", node.mesh));
  const tinygltf::Mesh& mesh = model_->meshes[static_cast<std::size_t>(node.mesh)];
  LUM_TRY(const int shadow, shadow_mesh(node));
  for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
    const bool deforms = gltf_deforms(*model_, node, mesh.primitives[i]);
    LUM_TRY(const int index, deforms ? own_mesh(node, i) : mesh_index(node.mesh, i));
    if (index < 0) continue;
    Object object;
    object.name = node.name.empty() ? mesh.name : node.name;
    object.mesh = index;
    const int material = mesh.primitives[i].material;
    object.material = inside(material, model_->materials.size()) ? material : default_material();
    object.world_from_object = world_from_node;
    object.mount.node = place;
    object.backdrop =
        node.extras.Has("backdrop") && node.extras.Get("backdrop").IsBool() && node.extras.Get("backdrop").Get<bool>();
    object.shadow_mesh = deforms ? -1 : shadow;
    if (deforms) hang_deformer(node, place, object);
    scene_.objects.push_back(std::move(object));
  }
  return {};
}

Result<int> GltfReader::mesh_index(int mesh, std::size_t primitive) {
  const auto [entry, is_new] = mesh_of_primitive_.try_emplace({mesh, primitive}, -1);
  if (!is_new) return entry->second;
  const std::string field = fmt::format("meshes[{}].primitives[{}]", mesh, primitive);
  LUM_TRY(std::optional<Mesh> made,
          read_primitive(model_->meshes[static_cast<std::size_t>(mesh)].primitives[primitive], field));
  if (made) {
    entry->second = static_cast<int>(scene_.meshes.size());
    scene_.meshes.push_back(std::move(*made));
  }
  return entry->second;
}

Result<int> GltfReader::own_mesh(const tinygltf::Node& node, std::size_t primitive) {
  const std::string field = fmt::format("meshes[{}].primitives[{}]", node.mesh, primitive);
  const tinygltf::Primitive& from = model_->meshes[static_cast<std::size_t>(node.mesh)].primitives[primitive];
  LUM_TRY(std::optional<Mesh> made, read_primitive(from, field));
  if (!made) return -1;
  LUM_TRY(Deformer deformer, gltf_deformer(*model_, node, from, *made, path_, field, *diagnostics_));
  scene_.deformers.push_back(std::move(deformer));
  scene_.meshes.push_back(std::move(*made));
  return static_cast<int>(scene_.meshes.size()) - 1;
}

void GltfReader::hang_deformer(const tinygltf::Node& node, int place, Object& object) {
  object.deformer = static_cast<int>(scene_.deformers.size()) - 1;
  scene_.deformers.back().node = place;
  if (!scene_.deformers.back().joints.empty()) {
    object.world_from_object = Mat4(1.0F);  // joints place it
    object.mount.node = -1;
  }
  if (node.extras.Has("luminist") && node.extras.Get("luminist").Has("shadow_mesh")) {
    warn(fmt::format("node \"{}\" deforms; its own mesh casts its shadow", node.name));
  }
}

/// The deformers' joints among the scene's nodes; a skin that hangs from elsewhere is as stiff as its mesh.
void GltfReader::find_joints() {
  for (Object& object : scene_.objects) {
    if (object.deformer < 0) continue;
    Deformer& deformer = scene_.deformers[static_cast<std::size_t>(object.deformer)];
    if (place_joints(deformer, place_of_)) continue;
    warn(fmt::format("the skin of \"{}\" hangs from a node that is not in the scene, and does not move", object.name));
    deformer.joints.clear();
  }
}

Result<int> GltfReader::shadow_mesh(const tinygltf::Node& node) {
  if (!node.extras.Has("luminist") || !node.extras.Get("luminist").Has("shadow_mesh")) return -1;
  const tinygltf::Value& reference = node.extras.Get("luminist").Get("shadow_mesh");
  const int mesh = reference.IsInt() ? reference.GetNumberAsInt() : -1;
  if (!inside(mesh, model_->meshes.size())) {
    warn(fmt::format("node \"{}\" names a shadow mesh that is not there; its own mesh casts its shadow", node.name));
    return -1;
  }
  const std::size_t primitives = model_->meshes[static_cast<std::size_t>(mesh)].primitives.size();
  if (primitives == 1) return mesh_index(mesh, 0);
  const auto [entry, is_new] = shadow_mesh_of_.try_emplace(mesh, -1);
  if (!is_new) return entry->second;
  Mesh joined;
  for (std::size_t i = 0; i < primitives; ++i) {
    LUM_TRY(const int part, mesh_index(mesh, i));
    if (part >= 0) append(scene_.meshes[static_cast<std::size_t>(part)], joined);
  }
  entry->second = static_cast<int>(scene_.meshes.size());
  scene_.meshes.push_back(std::move(joined));
  return entry->second;
}

Result<std::optional<Mesh>> GltfReader::read_primitive(const tinygltf::Primitive& primitive, const std::string& field) {
  const int mode = primitive.mode == -1 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
  if (mode != TINYGLTF_MODE_TRIANGLES && mode != TINYGLTF_MODE_TRIANGLE_STRIP && mode != TINYGLTF_MODE_TRIANGLE_FAN) {
    warn(field + " holds points or lines and is left out");
    return std::optional<Mesh>();
  }
  if (primitive.extensions.count("KHR_draco_mesh_compression") > 0 && primitive.indices < 0) {
    return bad("the mesh is compressed", field);
  }
  Mesh mesh;
  LUM_TRY_VOID(read_attributes(primitive, field, mesh));
  std::vector<std::uint32_t> corners;
  if (primitive.indices >= 0) {
    LUM_TRY(corners, gltf_indices(*model_, primitive.indices, path_, field + ".indices"));
  } else {
    corners.resize(mesh.positions.size());
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<std::uint32_t>(i);
  }
  mesh.triangles = triangles_of(corners, mode);
  return std::optional<Mesh>(std::move(mesh));
}

/// Floats in groups of a vector's length, as that vector.
template <class Vector>
std::vector<Vector> grouped(const std::vector<float>& numbers) {
  constexpr auto kLength = static_cast<std::size_t>(Vector::length());
  std::vector<Vector> result(numbers.size() / kLength);
  for (std::size_t i = 0; i < numbers.size(); ++i) result[i / kLength][static_cast<int>(i % kLength)] = numbers[i];
  return result;
}

/// Whether the mesh has vertex colours with an alpha.
bool has_alpha(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
  const auto found = primitive.attributes.find("COLOR_0");
  return found != primitive.attributes.end() && inside(found->second, model.accessors.size()) &&
         model.accessors[static_cast<std::size_t>(found->second)].type == TINYGLTF_TYPE_VEC4;
}

Result<void> GltfReader::read_attributes(const tinygltf::Primitive& primitive, const std::string& field,
                                         Mesh& mesh) const {
  const auto read = [&](const std::string& name, int components) -> Result<std::vector<float>> {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) return std::vector<float>();
    return gltf_floats(*model_, found->second, components, path_, field + "." + name);
  };
  if (primitive.attributes.count("POSITION") == 0) return bad("a mesh needs positions", field + ".POSITION");
  LUM_TRY(const std::vector<float> positions, read("POSITION", 3));
  LUM_TRY(const std::vector<float> normals, read("NORMAL", 3));
  LUM_TRY(const std::vector<float> tangents, read("TANGENT", 4));
  LUM_TRY(const std::vector<float> uvs, read(fmt::format("TEXCOORD_{}", gltf_uv_set(*model_, primitive.material)), 2));
  std::vector<float> colors;
  if (has_alpha(*model_, primitive)) {
    LUM_TRY(colors, read("COLOR_0", 4));
  }
  for (std::size_t i = 3; i < colors.size(); i += 4) {
    mesh.line_widths.push_back(colors[i] > 0.0F ? std::min(colors[i], 1.0F) : 0.0F);
  }
  mesh.positions = grouped<Vec3>(positions);
  mesh.normals = grouped<Vec3>(normals);
  mesh.tangents = grouped<Vec4>(tangents);
  mesh.uvs = grouped<Vec2>(uvs);
  const std::size_t count = mesh.positions.size();
  for (const auto& [size, name] :
       {std::pair(mesh.normals.size(), "NORMAL"), std::pair(mesh.tangents.size(), "TANGENT"),
        std::pair(mesh.uvs.size(), "TEXCOORD"), std::pair(mesh.line_widths.size(), "COLOR_0")}) {
    if (size != 0 && size != count) {
      return bad(fmt::format("{} values for {} vertices", size, count), field + "." + name);
    }
  }
  return {};
}

void GltfReader::add_camera(const tinygltf::Node& node, int place, const Mat4& world_from_node) {
  if (!inside(node.camera, model_->cameras.size())) return warn(fmt::format("there is no camera {}", node.camera));
  const tinygltf::Camera& from = model_->cameras[static_cast<std::size_t>(node.camera)];
  const bool sound = from.perspective.yfov > 0.0 && from.perspective.yfov < kPi;
  if (from.type != "perspective" || !sound) {
    return warn(
        fmt::format("cameras[{}] is not a perspective camera with a field of view and is left out", node.camera));
  }
  Camera camera;
  camera.name = !node.name.empty() ? node.name : (!from.name.empty() ? from.name : "camera");
  for (int n = 2; scene_.find_camera(camera.name) != nullptr; ++n) {
    camera.name = fmt::format("{}-{}", node.name.empty() ? "camera" : node.name, n);
  }
  camera.world_from_camera = without_scale(world_from_node);
  camera.mount.node = place;
  camera.fov_y = static_cast<float>(from.perspective.yfov);
  camera.near_plane = static_cast<float>(std::max(from.perspective.znear, 0.0));
  camera.far_plane = static_cast<float>(std::max(from.perspective.zfar, 0.0));
  scene_.cameras.push_back(std::move(camera));
}

Result<Scene> GltfReader::read() {
  LUM_TRY_VOID(refuse_unknown_compression());
  LUM_TRY_VOID(add_gltf_materials(*model_, path_, scene_, *diagnostics_));
  for (const int root : roots()) LUM_TRY_VOID(add_node(root, -1, Mat4(1.0F), 1));
  find_joints();
  LUM_TRY(scene_.animation.tracks, gltf_tracks(*model_, place_of_, path_, *diagnostics_));
  LUM_TRY(scene_.animation.weight_tracks, gltf_weight_tracks(*model_, place_of_, path_, *diagnostics_));
  return std::move(scene_);
}

}  // namespace

Result<Scene> read_gltf(const std::string& path, Diagnostics& diagnostics) {
  std::unique_ptr<tinygltf::Model> model;
  {
    LUM_TRY(const std::string bytes, read_file(path));
    LUM_TRY(model, parse_gltf(path, bytes));
  }
  try {
    return GltfReader(path, *model, diagnostics).read();
  } catch (const std::bad_alloc&) {
    throw;  // not the file's fault: the command line reports it as its own kind
  } catch (const std::exception& e) {
    return Error{ErrorKind::kBadContent, fmt::format("the glTF file makes no sense: {}", e.what()), path, "", ""};
  }
}

}  // namespace luminist
