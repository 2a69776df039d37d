#pragma once
// trace/path_tracer.h -- walks from the eye through the scene (Kajiya 1986), with samples of what shines in it.
#include <cstdint>
#include <memory>
#include <utility>

#include "base/result.h"
#include "rays/ray_scene.h"
#include "rays/surface_rays.h"
#include "render/surface_buffer.h"
#include "scene/scene.h"
#include "trace/light_paths.h"
#include "trace/mesh_emitters.h"

namespace luminist {

struct PathOptions {
  int bounces = 6;        ///< surfaces at which light is reflected on its way; 1: direct light only
  float specular = 1.0F;  ///< factor of every highlight and mirror
  /// Whether smooth surfaces throw light on others. If not, what is seen by way of a rough surface is itself taken as
  /// rough, or matte if it is no metal: light that few paths find, each of them bright, is spread out (path
  /// regularization, Kaplanyan and Dachsbacher 2013).
  bool caustics = true;
  std::uint32_t seed = 1;
  bool operator==(const PathOptions&) const = default;
};

/// One camera of one scene. thread any, const calls are concurrent.
class PathTracer {
 public:
  /// errors kLimit if memory runs out.
  static Result<PathTracer> create(Scene scene, const Camera& camera, int width, int height);

  /// Materials as SceneSurfaces::turn() says. Paths that were traced before are of other surfaces.
  void turn(std::vector<MaterialTurn> turns) { surfaces_->turn(std::move(turns)); }

  /// Appends path `sample` of a pixel (linear index). Same arguments, same bits. Light carried on from the second
  /// surface on is a matter of chance (Russian roulette), which keeps its mean.
  /// source of the sum over the ways to find an emitter: Veach 1997.
  void trace(std::uint32_t pixel, std::uint32_t sample, const PathOptions& options, LightPaths& paths) const;

  /// What is seen at the centres of the pixels.
  [[nodiscard]] SurfaceBuffer surface_buffer() const;
  [[nodiscard]] const RayScene& rays() const { return *rays_; }
  [[nodiscard]] const SceneSurfaces& surfaces() const { return *surfaces_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  struct Walk;  // one path, as far as it has come
  PathTracer() = default;
  /// From the near plane through a place of the picture, in pixels from the upper left corner; unit direction.
  [[nodiscard]] Ray eye_ray(const Vec2& place) const;
  /// Where the walk's way ends: sums what shines there, and chooses the way on. returns whether there is one.
  bool arrive(Walk& walk, const RayHit& hit) const;
  void ask_emitters(Walk& walk, const PathVertex& vertex) const;
  [[nodiscard]] bool survives(const Walk& walk, PathVertex& vertex, float chance) const;

  std::unique_ptr<SceneSurfaces> surfaces_;
  std::unique_ptr<const RayScene> rays_;     ///< what blocks light
  std::unique_ptr<const SurfaceRays> seen_;  ///< what paths meet
  std::unique_ptr<const MeshEmitters> emitters_;
  Mat4 world_from_camera_{1.0F};
  Vec2 half_extent_{1.0F};  ///< tangents of half the angles of view
  float near_ = 0.0F;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace luminist
