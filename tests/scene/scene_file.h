#pragma once
// tests/scene/scene_file.h -- a file that is loaded as a scene, and what must hold afterwards.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "base/files.h"
#include "sample_files.h"
#include "scene/scene.h"
#include "support/fixtures.h"

namespace luminist {

/// A scene file in a folder of its own, and what loading it said.
class SceneFile {
 public:
  explicit SceneFile(const std::string& name, const std::string& bytes) : name_(folder_.file(name)) {
    put(name, bytes);
  }
  /// Neither synced nor truncated, which some file systems take for a sync: thousands of damaged files would wait for
  /// it.
  void put(const std::string& name, const std::string& bytes) const {
    std::filesystem::remove(folder_.file(name));
    std::ofstream file(folder_.file(name), std::ios::binary);
    file << bytes;
    EXPECT_TRUE(file.flush());
  }
  Result<Scene> load(const SceneOptions& options = {}) {
    diagnostics_ = Diagnostics();
    return load_scene(name_, options, diagnostics_);
  }
  /// The only warning; "" if there is not exactly one.
  [[nodiscard]] std::string warning() const {
    return diagnostics_.warnings().size() == 1 ? diagnostics_.warnings()[0].what : "";
  }
  [[nodiscard]] std::string warned_at() const {
    return diagnostics_.warnings().size() == 1 ? diagnostics_.warnings()[0].where : "";
  }
  [[nodiscard]] const std::string& path() const { return name_; }
  [[nodiscard]] std::size_t warnings() const { return diagnostics_.warnings().size(); }
  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
  std::string name_;
  Diagnostics diagnostics_;
};

/// Six times the enclosed volume is 1 for the tetrahedron, with its faces looking outwards.
inline double six_volumes(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    sum += glm::dot(glm::dvec3(mesh.positions[t[0]]),
                    glm::cross(glm::dvec3(mesh.positions[t[1]]), glm::dvec3(mesh.positions[t[2]])));
  }
  return sum;
}

/// What every loaded scene promises: indices inside, unit normals, unique names, a camera with sound planes.
inline void expect_sound(const Scene& scene) {
  EXPECT_FALSE(scene.materials.empty());
  EXPECT_FALSE(scene.cameras.empty());
  for (const Camera& camera : scene.cameras)
    EXPECT_TRUE(0.0F < camera.near_plane && camera.near_plane < camera.far_plane);
  for (const Mesh& mesh : scene.meshes) {
    EXPECT_FALSE(mesh.triangles.empty());
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_TRUE(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
    EXPECT_TRUE(mesh.tangents.empty() || mesh.tangents.size() == mesh.positions.size());
    for (const Vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1.0F, 2e-5F);
    for (const auto& t : mesh.triangles) {
      for (const std::uint32_t index : t) {
        ASSERT_LT(index, mesh.positions.size());
        ASSERT_TRUE(is_finite(mesh.positions[index]));
      }
    }
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    EXPECT_LT(static_cast<std::size_t>(object.mesh), scene.meshes.size());
    EXPECT_LT(static_cast<std::size_t>(object.material), scene.materials.size());
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(object.name, scene.objects[k].name);
  }
}

/// With normals at its edges.
inline Mesh tetrahedron_with_uvs() {
  Mesh mesh;
  mesh.positions = tetrahedron_points();
  mesh.triangles = tetrahedron_faces();
  for (const Vec3& p : mesh.positions) mesh.uvs.emplace_back(p.x, p.y);
  compute_normals(mesh, 0.5);
  return mesh;
}

}  // namespace luminist
