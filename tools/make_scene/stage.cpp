#include "make_scene/stage.h"

#include <cmath>
#include <utility>

#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "base/check.h"

namespace luminist {
namespace {

float rounded(float x, float steps) {
  return std::round(x * steps) / steps;
}

Vec3 rounded(const Vec3& v, float steps) {
  return {rounded(v.x, steps), rounded(v.y, steps), rounded(v.z, steps)};
}

}  // namespace

int Stage::add_texture(const std::string& name, Image image) {
  scene_.textures.push_back({name, std::move(image), true, true});
  return static_cast<int>(scene_.textures.size()) - 1;
}

int Stage::add_material(Material material) {
  scene_.materials.push_back(std::move(material));
  return static_cast<int>(scene_.materials.size()) - 1;
}

int Stage::add_plain(const std::string& name, const Vec3& color, float roughness, float metallic) {
  Material material;
  material.name = name;
  material.base_color = color;
  material.roughness = roughness;
  material.metallic = metallic;
  return add_material(std::move(material));
}

int Stage::add_textured(const std::string& name, Image picture, float roughness, int relief) {
  Material material;
  material.name = name;
  material.base_color = Vec3(1.0F);
  material.base_color_texture = add_texture(name, std::move(picture));
  material.roughness = roughness;
  material.normal_texture = relief;
  return add_material(std::move(material));
}

int Stage::add_mesh(Mesh mesh) {
  for (Vec3& p : mesh.positions) p = rounded(p, 131072.0F);
  for (Vec3& n : mesh.normals) n = rounded(n, 16384.0F);
  for (Vec2& t : mesh.uvs) t = {rounded(t.x, 65536.0F), rounded(t.y, 65536.0F)};
  scene_.meshes.push_back(std::move(mesh));
  return static_cast<int>(scene_.meshes.size()) - 1;
}

void Stage::add_object(const std::string& name, int mesh, int material, const Mat4& world_from_object) {
  LUM_CHECK(mesh < static_cast<int>(scene_.meshes.size()) && material < static_cast<int>(scene_.materials.size()),
            "meshes and materials are added first");
  scene_.objects.push_back({name, mesh, material, world_from_object, false});
}

void Stage::add_object(const std::string& name, Mesh mesh, int material, const Mat4& world_from_object) {
  add_object(name, add_mesh(std::move(mesh)), material, world_from_object);
}

void Stage::mark_backdrop() {
  scene_.objects.back().backdrop = true;
}

void Stage::add_camera(const std::string& name, const Vec3& eye, const Vec3& look_at, float fov_y) {
  Camera camera;
  camera.name = name;
  camera.world_from_camera = glm::inverse(glm::lookAt(eye, look_at, Vec3(0.0F, 1.0F, 0.0F)));
  camera.fov_y = fov_y;
  camera.near_plane = 0.02F;
  camera.far_plane = 50.0F;
  scene_.cameras.push_back(camera);
}

}  // namespace luminist
