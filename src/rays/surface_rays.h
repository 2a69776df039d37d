#pragma once
// rays/surface_rays.h -- what a ray meets of what is seen of a scene (Embree).
#include <cstdint>
#include <limits>
#include <memory>

#include "base/math.h"
#include "base/result.h"
#include "scene/scene.h"

namespace luminist {

/// origin + t direction, least <= t <= most; world space, direction of any length.
struct Ray {
  Vec3 origin{0.0F};
  Vec3 direction{0.0F, 0.0F, -1.0F};
  float least = 0.0F;
  float most = std::numeric_limits<float>::infinity();
};

/// The first triangle that a ray meets, from either side.
struct RayHit {
  static constexpr std::uint32_t kNothing = 0xFFFFFFFFU;
  float distance = std::numeric_limits<float>::infinity();  ///< in lengths of the ray's direction
  std::uint32_t object = kNothing;                          ///< index of the scene's object
  std::uint32_t triangle = 0;                               ///< of its mesh
  float u = 0.0F;                                           ///< weight of the triangle's second corner
  float v = 0.0F;                                           ///< and of its third

  [[nodiscard]] bool hit() const { return object != kNothing; }
  [[nodiscard]] Vec3 weights() const { return {1.0F - u - v, u, v}; }  ///< of the triangle's corners
};

/// The triangles that a camera sees, of both sides, where the scene stands at the time; proxies that only block light
/// are not among them. Copies what it needs. Movable. thread any, const calls are concurrent.
class SurfaceRaysImpl;
class SurfaceRays {
 public:
  static constexpr int kAnyObject = -1;

  /// errors kLimit if memory runs out. cost O(n log n) of the triangles.
  static Result<SurfaceRays> create(const Scene& scene);
  SurfaceRays(SurfaceRays&&) noexcept;
  SurfaceRays& operator=(SurfaceRays&&) noexcept;
  ~SurfaceRays();

  /// What the ray meets first, of all objects or of one alone (its index in the scene). Same input, same bits. A ray
  /// that is not finite meets nothing. cost about a microsecond.
  [[nodiscard]] RayHit first(const Ray& ray, int only = kAnyObject) const;

 private:
  explicit SurfaceRays(std::unique_ptr<SurfaceRaysImpl> impl);
  std::unique_ptr<SurfaceRaysImpl> impl_;
};

}  // namespace luminist
