#include "studio/solid_scene.h"

#include <algorithm>

#include "params/param_block.h"

namespace luminist {
namespace {

/// The mean of a texture over a grid of its texels, so that large ones cost no more than small ones.
Vec3 mean_color(const Image& image) {
  constexpr int kGrid = 64;
  Vec3 sum(0.0F);
  const int columns = std::min(kGrid, image.width);
  const int rows = std::min(kGrid, image.height);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const std::size_t texel =
          image.index((2 * x + 1) * image.width / (2 * columns), (2 * y + 1) * image.height / (2 * rows));
      const float* value = &image.data[texel * static_cast<std::size_t>(image.channels)];
      sum += Vec3(value[0], value[1], value[2]);
    }
  }
  return columns * rows > 0 ? sum / static_cast<float>(columns * rows) : Vec3(1.0F);
}

Vec3 plain_color(const Scene& scene, const Material& material) {
  constexpr float kDarkest = 0.1F;
  Vec3 color = material.base_color;
  if (material.base_color_texture >= 0) {
    color *= mean_color(scene.textures[static_cast<std::size_t>(material.base_color_texture)].image);
  }
  return glm::max(color, Vec3(kDarkest));
}

}  // namespace

SolidScene solid_scene(const Scene& scene) {
  SolidScene solid;
  for (const Object& object : scene.objects) {
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
    const Mat3 turn = glm::transpose(glm::inverse(Mat3(object.world_from_object)));
    const auto base = static_cast<std::uint32_t>(solid.positions.size());
    SolidPart part{object.name, static_cast<std::uint32_t>(solid.corners.size()),
                   static_cast<std::uint32_t>(3 * mesh.triangles.size()),
                   plain_color(scene, scene.materials[static_cast<std::size_t>(object.material)])};
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      solid.positions.emplace_back(object.world_from_object * Vec4(mesh.positions[i], 1.0F));
      solid.normals.push_back(unit_direction(turn * mesh.normals[i]).value_or(Vec3(0.0F, 1.0F, 0.0F)));
    }
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) solid.corners.push_back(base + corner);
    }
    solid.parts.push_back(std::move(part));
  }
  return solid;
}

std::optional<float> first_hit(const SolidScene& solid, const Vec3& origin, const Vec3& way) {
  std::optional<float> nearest;
  for (std::size_t i = 0; i + 2 < solid.corners.size(); i += 3) {
    const Vec3& a = solid.positions[solid.corners[i]];
    const Vec3 ab = solid.positions[solid.corners[i + 1]] - a;
    const Vec3 ac = solid.positions[solid.corners[i + 2]] - a;
    const Vec3 side = glm::cross(way, ac);
    const float volume = glm::dot(ab, side);
    if (volume == 0.0F) continue;
    const Vec3 from = origin - a;
    const float u = glm::dot(from, side) / volume;
    const Vec3 other = glm::cross(from, ab);
    const float v = glm::dot(way, other) / volume;
    const float t = glm::dot(ac, other) / volume;
    if (u >= 0.0F && v >= 0.0F && u + v <= 1.0F && t > 0.0F && (!nearest || t < *nearest)) nearest = t;
  }
  return nearest;
}

}  // namespace luminist
