#include "scene/deform.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "params/param_block.h"
#include "scene/scene.h"

namespace luminist {
namespace {

/// Unit normals of the faces around each vertex, by area; zero where there is no face.
std::vector<Vec3> face_normals(const std::vector<Vec3>& positions, const Mesh& mesh) {
  std::vector<Vec3> normals(positions.size(), Vec3(0.0F));
  for (const auto& t : mesh.triangles) {
    const Vec3 across = glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
    for (const std::uint32_t corner : t) normals[corner] += across;
  }
  for (Vec3& normal : normals) normal = unit_direction(normal).value_or(Vec3(0.0F));
  return normals;
}

void add_targets(const Deformer& deformer, std::span<const float> weights, Mesh& mesh) {
  bool turned = true;
  for (std::size_t k = 0; k < deformer.targets.size() && k < weights.size(); ++k) {
    const MorphTarget& target = deformer.targets[k];
    if (weights[k] == 0.0F) continue;
    for (std::size_t i = 0; i < target.positions.size(); ++i) mesh.positions[i] += weights[k] * target.positions[i];
    for (std::size_t i = 0; i < target.normals.size(); ++i) mesh.normals[i] += weights[k] * target.normals[i];
    turned &= !target.normals.empty();
  }
  if (!turned) {
    const std::vector<Vec3> before = face_normals(deformer.positions, mesh);
    const std::vector<Vec3> after = face_normals(mesh.positions, mesh);
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) mesh.normals[i] += after[i] - before[i];
  }
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    mesh.normals[i] = unit_direction(mesh.normals[i]).value_or(deformer.normals[i]);
  }
}

/// What normals are turned by: the inverse transpose, but for a positive factor.
Mat3 cofactors(const Mat3& m) {
  const float side = glm::determinant(m) < 0.0F ? -1.0F : 1.0F;
  return side * Mat3(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
}

void go_with_joints(const Deformer& deformer, std::span<const Mat4> worlds, Mesh& mesh) {
  std::vector<Mat4> world_from_mesh;
  for (std::size_t j = 0; j < deformer.joints.size(); ++j) {
    world_from_mesh.push_back(worlds[static_cast<std::size_t>(deformer.joints[j])] * deformer.joint_from_mesh[j]);
  }
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    Mat4 moved(0.0F);
    for (int k = 0; k < 4; ++k) {
      const float weight = deformer.vertex_weights[i][k];
      if (weight != 0.0F) moved += weight * world_from_mesh[deformer.vertex_joints[i][static_cast<std::size_t>(k)]];
    }
    mesh.positions[i] = Vec3(moved * Vec4(mesh.positions[i], 1.0F));
    mesh.normals[i] = unit_direction(cofactors(Mat3(moved)) * mesh.normals[i]).value_or(mesh.normals[i]);
    if (mesh.tangents.empty()) continue;
    const Vec3 along(mesh.tangents[i]);
    mesh.tangents[i] = Vec4(unit_direction(Mat3(moved) * along).value_or(along), mesh.tangents[i].w);
  }
}

using Place = std::tuple<float, float, float>;

Place place_of(const Vec3& v) {
  return {v.x + 0.0F, v.y + 0.0F, v.z + 0.0F};  // -0 is 0
}

/// For each vertex of a mesh the one of the file, or -1.
std::vector<int> origins(const std::vector<Vec3>& file, const std::vector<Vec3>& mesh) {
  std::map<Place, int> first;
  for (std::size_t i = 0; i < file.size(); ++i) {
    // What is not a number has no order.
    if (std::isfinite(file[i].x + file[i].y + file[i].z)) first.emplace(place_of(file[i]), static_cast<int>(i));
  }
  std::vector<int> from;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const auto found = first.find(place_of(mesh[i]));
    const bool same = i < file.size() && file[i] == mesh[i];
    from.push_back(same ? static_cast<int>(i) : found != first.end() ? found->second : -1);
  }
  return from;
}

template <class Value>
std::vector<Value> taken(const std::vector<Value>& values, const std::vector<int>& from, const Value& otherwise) {
  if (values.empty()) return {};
  std::vector<Value> result;
  result.reserve(from.size());
  for (const int i : from) result.push_back(i >= 0 ? values[static_cast<std::size_t>(i)] : otherwise);
  return result;
}

}  // namespace

void settle_deformers(Scene& scene) {
  for (const Object& object : scene.objects) {
    if (object.deformer < 0) continue;
    Deformer& deformer = scene.deformers[static_cast<std::size_t>(object.deformer)];
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
    const std::vector<int> from = origins(deformer.positions, mesh.positions);
    for (MorphTarget& target : deformer.targets) {
      target.positions = taken(target.positions, from, Vec3(0.0F));
      target.normals = taken(target.normals, from, Vec3(0.0F));
    }
    deformer.vertex_joints = taken(deformer.vertex_joints, from, {});
    deformer.vertex_weights = taken(deformer.vertex_weights, from, Vec4(1.0F, 0.0F, 0.0F, 0.0F));
    deformer.positions = mesh.positions;
    deformer.normals = mesh.normals;
    deformer.tangents = mesh.tangents;
  }
}

void deform(Scene& scene, std::span<const Mat4> worlds, std::span<const std::vector<float>> weights_of) {
  for (const Object& object : scene.objects) {
    if (object.deformer < 0) continue;
    const Deformer& deformer = scene.deformers[static_cast<std::size_t>(object.deformer)];
    Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
    mesh.positions = deformer.positions;
    mesh.normals = deformer.normals;
    mesh.tangents = deformer.tangents;
    const auto node = static_cast<std::size_t>(std::max(deformer.node, 0));
    const bool moved = deformer.node >= 0 && node < weights_of.size() && !weights_of[node].empty();
    if (!deformer.targets.empty()) add_targets(deformer, moved ? weights_of[node] : deformer.weights, mesh);
    if (!deformer.joints.empty()) go_with_joints(deformer, worlds, mesh);
  }
}

Deformer mirrored(const Deformer& deformer) {
  Deformer result = deformer;
  const auto mirror = [](std::vector<Vec3>& vectors) {
    for (Vec3& v : vectors) v.x = -v.x;
  };
  mirror(result.positions);
  for (MorphTarget& target : result.targets) {
    mirror(target.positions);
    mirror(target.normals);
  }
  return result;
}

}  // namespace luminist
