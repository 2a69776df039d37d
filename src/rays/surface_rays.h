#pragma once
// rays/surface_rays.h -- what a ray meets of what is seen of a scene (Embree).
#include <cstdint>
#include <memory>
#include <optional>

#include "base/math.h"
#include "base/result.h"
#include "scene/scene.h"

namespace luminist {

/// origin + t way, least <= t <= most; world space, way of any length.
struct SurfaceRay {
  Vec3 origin{0.0F};
  Vec3 way{0.0F, 0.0F, -1.0F};
  float least = 0.0F;
  float most = 1.0F;
};

/// A place on the mesh of an object.
struct SurfaceHit {
  int object = 0;              ///< index of the scene's object
  std::uint32_t triangle = 0;  ///< of its mesh
  Vec3 weights{0.0F};          ///< of the triangle's corners; sum 1
  float t = 0.0F;              ///< along the ray
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
  [[nodiscard]] std::optional<SurfaceHit> first(const SurfaceRay& ray, int only = kAnyObject) const;

 private:
  explicit SurfaceRays(std::unique_ptr<SurfaceRaysImpl> impl);
  std::unique_ptr<SurfaceRaysImpl> impl_;
};

}  // namespace luminist
