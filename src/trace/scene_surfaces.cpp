#include "trace/scene_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/matrix.hpp>

namespace luminist {
namespace {

constexpr float kClearance = 1e-5F;  // of the scene's extent

template <class T>
T between(const std::vector<T>& values, const std::array<std::uint32_t, 3>& corners, float u, float v) {
  return values[corners[0]] * (1.0F - u - v) + values[corners[1]] * u + values[corners[2]] * v;
}

Vec3 normalized_or(const Vec3& v, const Vec3& fallback) {
  const float length = glm::length(v);
  return length > 1e-12F && std::isfinite(length) ? v / length : fallback;
}

int wrapped(int i, int size, bool repeat) {
  if (!repeat) return std::clamp(i, 0, size - 1);
  const int rest = i % size;
  return rest < 0 ? rest + size : rest;
}

}  // namespace

Vec3 texture_color(const Texture& texture, const Vec2& uv) {
  const Image& image = texture.image;
  if (image.empty() || !std::isfinite(uv.x) || !std::isfinite(uv.y)) return Vec3(1.0F);
  // What an int cannot hold any more repeats like anything else.
  const auto place = [](float t, int size) { return std::clamp(t, -1e4F, 1e4F) * static_cast<float>(size) - 0.5F; };
  const float x = place(uv.x, image.width);
  const float y = place(uv.y, image.height);
  const float left = std::floor(x);
  const float top = std::floor(y);
  const float fx = x - left;
  const float fy = y - top;
  const std::array<int, 2> columns{wrapped(static_cast<int>(left), image.width, texture.repeat_u),
                                   wrapped(static_cast<int>(left) + 1, image.width, texture.repeat_u)};
  const std::array<int, 2> rows{wrapped(static_cast<int>(top), image.height, texture.repeat_v),
                                wrapped(static_cast<int>(top) + 1, image.height, texture.repeat_v)};
  const auto texel = [&](std::size_t dx, std::size_t dy) {
    const float* data =
        image.data.data() + image.index(columns[dx], rows[dy]) * static_cast<std::size_t>(image.channels);
    return image.channels >= 3 ? Vec3(data[0], data[1], data[2]) : Vec3(data[0]);
  };
  const Vec3 above = texel(0, 0) * (1.0F - fx) + texel(1, 0) * fx;
  const Vec3 below = texel(0, 1) * (1.0F - fx) + texel(1, 1) * fx;
  return above * (1.0F - fy) + below * fy;
}

SceneSurfaces::SceneSurfaces(Scene scene) : scene_(std::move(scene)) {
  float reach = 0.0F;
  for (const Object& object : scene_.objects) {
    Place place;
    const Mat3 linear(object.world_from_object);
    const float determinant = glm::determinant(linear);
    place.side = determinant < 0.0F ? -1.0F : 1.0F;
    // The adjugate is the inverse transpose up to scale, and has sense where that has none.
    place.normal_from_object = place.side * Mat3(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                                 glm::cross(linear[0], linear[1]));
    places_.push_back(place);
  }
  const Box box = scene_.bounds(true);
  if (!box.empty()) {
    const Vec3 far = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    reach = std::max(largest(far), box.radius());
  }
  clearance_ = kClearance * (reach > 0.0F ? reach : 1.0F);
}

void SceneSurfaces::turn(std::vector<MaterialTurn> turns) {
  turns_ = std::move(turns);
  turns_.resize(turns_.empty() ? 0 : scene_.materials.size());
}

Vec3 SceneSurfaces::color_at(int texture, const Vec2& uv) const {
  return texture_color(scene_.textures[static_cast<std::size_t>(texture)], uv);
}

void SceneSurfaces::corners(std::uint32_t object, std::uint32_t triangle, Vec3& a, Vec3& b, Vec3& c) const {
  const Object& placed = scene_.objects[object];
  const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(placed.mesh)];
  const auto& corner = mesh.triangles[triangle];
  a = Vec3(placed.world_from_object * Vec4(mesh.positions[corner[0]], 1.0F));
  b = Vec3(placed.world_from_object * Vec4(mesh.positions[corner[1]], 1.0F));
  c = Vec3(placed.world_from_object * Vec4(mesh.positions[corner[2]], 1.0F));
}

Vec3 SceneSurfaces::emissive(std::uint32_t object, std::uint32_t triangle, float u, float v) const {
  const Object& placed = scene_.objects[object];
  const Material& material = scene_.materials[static_cast<std::size_t>(placed.material)];
  if (material.emissive_texture < 0) return material.emissive;
  const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(placed.mesh)];
  const Vec2 uv = mesh.uvs.empty() ? Vec2(0.0F) : between(mesh.uvs, mesh.triangles[triangle], u, v);
  return material.emissive * color_at(material.emissive_texture, uv);
}

Vec3 SceneSurfaces::mapped_normal(const Mesh& mesh, const Material& material, const Object& object, const RayHit& hit,
                                  const Vec3& normal, const Vec2& uv) const {
  if (material.normal_texture < 0 || mesh.tangents.empty()) return normal;
  const Vec4 tangent = between(mesh.tangents, mesh.triangles[hit.triangle], hit.u, hit.v);
  Vec3 t = Mat3(object.world_from_object) * Vec3(tangent);
  t -= normal * glm::dot(normal, t);
  if (!(glm::dot(t, t) > 1e-12F)) return normal;
  t = glm::normalize(t);
  const Vec3 b = glm::cross(normal, t) * tangent.w;
  const Vec3 m = color_at(material.normal_texture, uv) * 2.0F - 1.0F;
  return glm::normalize(material.normal_scale * (t * m.x + b * m.y) + normal * std::max(m.z, 1e-3F));
}

SurfacePoint SceneSurfaces::at(const RayHit& hit, const Vec3& direction) const {
  const Object& object = scene_.objects[hit.object];
  const Place& place = places_[hit.object];
  const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(object.mesh)];
  const Material& material = scene_.materials[static_cast<std::size_t>(object.material)];
  const auto& corner = mesh.triangles[hit.triangle];
  Vec3 a;
  Vec3 b;
  Vec3 c;
  corners(hit.object, hit.triangle, a, b, c);

  SurfacePoint point;
  point.position = a * (1.0F - hit.u - hit.v) + b * hit.u + c * hit.v;
  const Vec3 front = place.side * normalized_or(glm::cross(b - a, c - a), -direction);
  const float seen = glm::dot(front, direction) <= 0.0F ? 1.0F : -1.0F;
  point.face = seen * front;
  const Vec2 uv = mesh.uvs.empty() ? Vec2(0.0F) : between(mesh.uvs, corner, hit.u, hit.v);
  const Vec3 smooth = place.normal_from_object * between(mesh.normals, corner, hit.u, hit.v);
  point.normal = seen * mapped_normal(mesh, material, object, hit, normalized_or(smooth, front), uv);
  // What still leans away from the viewer is bent back to the silhouette.
  const float away = std::min(-glm::dot(point.normal, direction) - 1e-3F, 0.0F);
  point.normal = glm::normalize(point.normal + away * direction);

  Vec3 base = material.base_color;
  float metallic = material.metallic;
  point.roughness = material.roughness;
  if (material.base_color_texture >= 0) base *= color_at(material.base_color_texture, uv);
  if (material.metallic_roughness_texture >= 0) {
    const Vec3 texel = color_at(material.metallic_roughness_texture, uv);
    point.roughness *= texel.y;
    metallic *= texel.z;
  }
  const float dielectric = kDielectric * material.specular * (1.0F - metallic);
  point.albedo = base * (1.0F - metallic);
  point.specular = dielectric + base * metallic;
  if (!turns_.empty()) {
    const MaterialTurn& turn = turns_[static_cast<std::size_t>(object.material)];
    const SurfaceColors colors = turned(turn, {point.albedo, point.specular, dielectric, point.roughness});
    point.albedo = colors.albedo;
    point.specular = colors.specular;
    point.roughness = colors.roughness;
  }
  point.emissive = material.emissive;
  if (material.emissive_texture >= 0) point.emissive *= color_at(material.emissive_texture, uv);
  return point;
}

}  // namespace luminist
