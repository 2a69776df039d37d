#pragma once
// tests/raster/mesh_scenes.h -- scenes of which geometry tells the picture.
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/scene.h"

namespace luminist::test {

/// Around the origin, from rows of latitude; true normals.
inline Mesh sphere_mesh(float radius, int rows = 96) {
  Mesh mesh;
  const int columns = 2 * rows;
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j <= columns; ++j) {
      const double theta = kPi * i / rows;
      const double phi = 2.0 * kPi * j / columns;
      const Vec3 n(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi));
      mesh.positions.push_back(radius * n);
      mesh.normals.push_back(n);
    }
  }
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const auto a = static_cast<std::uint32_t>(i * (columns + 1) + j);
      const auto below = a + static_cast<std::uint32_t>(columns) + 1;
      mesh.triangles.push_back({a, below, below + 1});
      mesh.triangles.push_back({a, below + 1, a + 1});
    }
  }
  return mesh;
}

/// 2 x 2 in the plane z = 0, facing +z; u to the right (+x), v down (-y): a texture lies upright.
inline Mesh quad_mesh() {
  Mesh mesh;
  mesh.positions = {Vec3(-1, 1, 0), Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0)};
  mesh.normals.assign(4, Vec3(0, 0, 1));
  mesh.uvs = {Vec2(0, 0), Vec2(0, 1), Vec2(1, 1), Vec2(1, 0)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// The cube of half side 1, flat faces.
inline Mesh box_mesh() {
  Mesh mesh;
  for (int face = 0; face < 6; ++face) {
    Vec3 n(0.0F);
    n[face / 2] = face % 2 == 0 ? 1.0F : -1.0F;
    Vec3 t;
    Vec3 b;
    tangent_frame(n, t, b);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& [x, y] :
         {std::pair(-1.0F, -1.0F), std::pair(1.0F, -1.0F), std::pair(1.0F, 1.0F), std::pair(-1.0F, 1.0F)}) {
      mesh.positions.push_back(n + x * t + y * b);
      mesh.normals.push_back(n);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  return mesh;
}

/// Triangles between points of a grid that are drawn at random, some of them at one place; smooth normals.
inline Mesh heap_mesh(unsigned seed, std::uint32_t points, unsigned grid, int triangles) {
  std::mt19937 random(seed);
  Mesh mesh;
  for (std::uint32_t i = 0; i < points; ++i) {
    mesh.positions.emplace_back(random() % grid, random() % grid, random() % grid);
  }
  const auto any = [&] { return static_cast<std::uint32_t>(random() % points); };
  for (int i = 0; i < triangles; ++i) mesh.triangles.push_back({any(), any(), any()});
  compute_normals(mesh, kPi);
  return mesh;
}

/// Adds a mesh as an object of its own, with a material of its own.
inline Object& add(Scene& scene, Mesh mesh, const std::string& name, const Mat4& world_from_object = Mat4(1.0F)) {
  Material material;
  material.name = name;
  scene.meshes.push_back(std::move(mesh));
  scene.materials.push_back(material);
  Object object;
  object.name = name;
  object.mesh = static_cast<int>(scene.meshes.size()) - 1;
  object.material = static_cast<int>(scene.materials.size()) - 1;
  object.world_from_object = world_from_object;
  scene.objects.push_back(object);
  return scene.objects.back();
}

inline Mat4 moved(const Vec3& by, const Vec3& scale = Vec3(1.0F)) {
  return glm::scale(glm::translate(Mat4(1.0F), by), scale);
}

/// The quad laid down: the plane y = height of half side `half`, facing up.
inline Mat4 laid_down(float height, float half) {
  const Mat4 turned =
      glm::rotate(glm::translate(Mat4(1.0F), Vec3(0, height, 0)), static_cast<float>(-0.5 * kPi), Vec3(1, 0, 0));
  return glm::scale(turned, Vec3(half, half, 1.0F));
}

inline Camera looking(const Vec3& from, const Vec3& at, float fov_y = 0.7F, const Vec3& up = Vec3(0, 1, 0)) {
  Camera camera;
  camera.world_from_camera = glm::inverse(glm::lookAt(from, at, up));
  camera.fov_y = fov_y;
  return camera;
}

/// Where a world point falls in the picture, pixels from its top left corner.
inline Vec2 pixel_of(const Camera& camera, const Vec3& p, int width, int height) {
  const Vec4 clip = camera.clip_from_world(static_cast<float>(width) / static_cast<float>(height)) * Vec4(p, 1.0F);
  return {(0.5F + 0.5F * clip.x / clip.w) * static_cast<float>(width),
          (0.5F - 0.5F * clip.y / clip.w) * static_cast<float>(height)};
}

}  // namespace luminist::test
