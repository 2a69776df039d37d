#pragma once
// rays/ray_scene.h -- who sees whom: exact visibility on the scene's triangles (Embree).
#include <memory>
#include <span>

#include "base/math.h"
#include "base/result.h"
#include "scene/scene.h"

namespace luminist {

/// A segment from `from` to `to`, world space; it is blocked by anything strictly between its ends (what lies within
/// 1e-5 of its length of an end belongs to that end: that is where single precision can no longer tell). What lies
/// outside of the bounds of all that blocks light is no part of that length: a sun's segments are as exact as a lamp's.
struct Segment {
  Vec3 from;
  Vec3 to;
};

/// The triangles of a scene that block light, indexed; those of shadow meshes as surface/shadow_caster.h says, for
/// light that comes from `from`. Copies what it needs. Movable. thread any, const calls are concurrent.
class RaySceneImpl;
class RayScene {
 public:
  /// errors kLimit if memory runs out.
  static Result<RayScene> create(const Scene& scene);
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;
  ~RayScene();

  /// blocked [segments.size()] := 1 where something lies between, else 0. Same input, same bits.
  /// Non-finite segments are not blocked. cost about 30 ns a segment and core on 70k triangles.
  void occluded(std::span<const Segment> segments, std::span<unsigned char> blocked) const;
  /// The same for one segment, for those that have no company going their way. cost about 150 ns.
  [[nodiscard]] bool blocked(const Segment& segment) const;

  /// world_slack() of the mesh that blocks light in an object's stead; 0 if its own does.
  [[nodiscard]] float shadow_slack(std::size_t object) const;

 private:
  explicit RayScene(std::unique_ptr<RaySceneImpl> impl);
  std::unique_ptr<RaySceneImpl> impl_;
};

}  // namespace luminist
