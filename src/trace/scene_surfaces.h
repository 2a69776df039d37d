#pragma once
// trace/scene_surfaces.h -- what a ray finds where it meets the scene: geometry and material, as the raster engine
// reads them (shaders/raster/deep.frag).
#include <cstdint>
#include <vector>

#include "rays/surface_rays.h"
#include "scene/material_params.h"
#include "scene/scene.h"

namespace luminist {

/// A place on a surface, seen from one side. World space, linear colour.
struct SurfacePoint {
  Vec3 position{0.0F};
  Vec3 face{0.0F};      ///< unit, of the triangle, towards the side that is seen
  Vec3 normal{0.0F};    ///< unit, shading, leans towards the viewer
  Vec3 albedo{0.0F};    ///< diffuse reflectance
  Vec3 specular{0.0F};  ///< reflectance at normal incidence
  Vec3 emissive{0.0F};  ///< radiance, the same from both sides
  float roughness = 1.0F;
};

/// A scene, ready for such questions. thread any, const calls are concurrent.
class SceneSurfaces {
 public:
  explicit SceneSurfaces(Scene scene);

  /// Materials are as these say from now on; turns: one per material of the scene; those that have none stay as they
  /// are. Not beside other calls.
  void turn(std::vector<MaterialTurn> turns);

  /// direction: unit, of the ray that hit. cost three corners and up to four texture lookups.
  [[nodiscard]] SurfacePoint at(const RayHit& hit, const Vec3& direction) const;
  /// Radiance alone; u, v as in RayHit.
  [[nodiscard]] Vec3 emissive(std::uint32_t object, std::uint32_t triangle, float u, float v) const;
  /// The corners of a triangle, world.
  void corners(std::uint32_t object, std::uint32_t triangle, Vec3& a, Vec3& b, Vec3& c) const;

  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// How far rays start from a surface, world units: beyond what single precision confuses, below what anyone sees.
  [[nodiscard]] float clearance() const { return clearance_; }

 private:
  struct Place {
    Mat3 normal_from_object{1.0F};
    float side = 1.0F;  ///< -1 for an object that is mirrored
  };
  [[nodiscard]] Vec3 mapped_normal(const Mesh& mesh, const Material& material, const Object& object, const RayHit& hit,
                                   const Vec3& normal, const Vec2& uv) const;
  [[nodiscard]] Vec3 color_at(int texture, const Vec2& uv) const;

  Scene scene_;
  std::vector<Place> places_;  ///< [objects]
  std::vector<MaterialTurn> turns_;
  float clearance_ = 0.0F;
};

/// Bilinear, texel centres at half numbers, repeated or clamped as the texture says; 3 channels.
Vec3 texture_color(const Texture& texture, const Vec2& uv);

}  // namespace luminist
