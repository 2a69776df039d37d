#include "trace/mesh_emitters.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luminist {
namespace {

constexpr std::size_t kDark = ~std::size_t{0};

float luminance(const Vec3& color) {
  return glm::dot(color, Vec3(0.2126F, 0.7152F, 0.0722F));
}

/// Of a triangle, from its corners and its middle.
float mean_radiance(const SceneSurfaces& surfaces, std::uint32_t object, std::uint32_t triangle) {
  constexpr std::array<Vec2, 4> kPlaces{Vec2(0.1F, 0.1F), Vec2(0.8F, 0.1F), Vec2(0.1F, 0.8F), Vec2(1.0F / 3.0F)};
  float sum = 0.0F;
  for (const Vec2& place : kPlaces) sum += luminance(surfaces.emissive(object, triangle, place.x, place.y));
  return sum / static_cast<float>(kPlaces.size());
}

}  // namespace

MeshEmitters::MeshEmitters(const SceneSurfaces& surfaces) : surfaces_(&surfaces) {
  const Scene& scene = surfaces.scene();
  std::vector<double> areas;
  for (std::uint32_t object = 0; object < scene.objects.size(); ++object) {
    const Object& placed = scene.objects[object];
    const Material& material = scene.materials[static_cast<std::size_t>(placed.material)];
    const bool shines = luminance(material.emissive) > 0.0F;
    first_.push_back(shines ? triangles_.size() : kDark);
    if (!shines) continue;
    const std::size_t count = scene.meshes[static_cast<std::size_t>(placed.mesh)].triangles.size();
    for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
      Vec3 a;
      Vec3 b;
      Vec3 c;
      surfaces.corners(object, triangle, a, b, c);
      const auto area = static_cast<double>(0.5F * glm::length(glm::cross(b - a, c - a)));
      // A texture's dark triangles keep a little chance, since four places do not tell all.
      const double radiance = static_cast<double>(
          std::max(mean_radiance(surfaces, object, triangle), 0.02F * luminance(material.emissive)));
      total_ += std::isfinite(area) ? area * radiance : 0.0;
      sums_.push_back(total_);
      areas.push_back(area);
      triangles_.push_back({object, triangle, static_cast<float>(radiance)});
    }
  }
  for (Triangle& each : triangles_) each.area_pdf = total_ > 0.0 ? each.area_pdf / static_cast<float>(total_) : 0.0F;
}

float MeshEmitters::area_pdf(std::uint32_t object, std::uint32_t triangle) const {
  const std::size_t first = first_[object];
  return first == kDark ? 0.0F : triangles_[first + triangle].area_pdf;
}

EmitterPoint MeshEmitters::sample(float choice, const Vec2& place) const {
  const auto found = std::upper_bound(sums_.begin(), sums_.end(), static_cast<double>(choice) * total_);
  const auto index = std::min(static_cast<std::size_t>(found - sums_.begin()), triangles_.size() - 1);
  const Triangle& triangle = triangles_[index];
  Vec3 a;
  Vec3 b;
  Vec3 c;
  surfaces_->corners(triangle.object, triangle.triangle, a, b, c);
  const float root = std::sqrt(place.x);
  const float u = root * (1.0F - place.y);
  const float v = root * place.y;
  const Vec3 across = glm::cross(b - a, c - a);
  const float length = glm::length(across);
  EmitterPoint point;
  point.position = a * (1.0F - u - v) + b * u + c * v;
  point.normal = length > 0.0F ? across / length : Vec3(0.0F);
  point.radiance = surfaces_->emissive(triangle.object, triangle.triangle, u, v);
  point.area_pdf = triangle.area_pdf;
  return point;
}

}  // namespace luminist
