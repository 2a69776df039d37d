#pragma once
// trace/light_paths.h -- paths from the eye, kept: where light may arrive on its way into a pixel, so that other lights
// can be looked at without tracing anew (a deep path buffer).
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "rays/surface_rays.h"
#include "trace/reflection.h"

namespace luminist {

/// A place on a path, and the straight way on from there. The first one is the eye itself.
struct PathVertex {
  static constexpr float kNoWay = 0.0F;
  Vec3 position{0.0F};    ///< a hair off the surface
  Vec3 throughput{1.0F};  ///< what arrives here in the direction of the eye is multiplied by
  Reflection surface;
  std::uint32_t object = RayHit::kNothing;  ///< index of the scene's; kNothing at the eye
  bool scatters = false;      ///< light from anywhere is reflected here; not so at the eye and on bare mirrors
  Vec2 place{0.0F};           ///< in [0,1)^2, which point of a light is asked
  Vec3 way{0.0F};             ///< unit, where the path goes on
  float way_length = kNoWay;  ///< up to the next surface; infinity if there is none; kNoWay: the path ends here
  float way_pdf = 0.0F;       ///< density of having gone there; 0: there was no choice
  Vec3 way_throughput{0.0F};
};

/// Paths of some pixels, one after another. What does not depend on the rig's lights is summed already.
struct LightPaths {
  std::vector<PathVertex> vertices;
  std::vector<std::uint32_t> first{0};  ///< [paths + 1] path i owns vertices first[i] .. first[i + 1]
  std::vector<Vec3> emitted;            ///< [paths] radiance of what shines in the scene
  std::vector<Vec3> emitted_later;      ///< [paths] the part of it that arrives by way of another surface
  std::vector<Vec3> escaped;            ///< [paths] what a radiance of 1 all around would add

  [[nodiscard]] std::size_t size() const { return emitted.size(); }
  void clear();
};

}  // namespace luminist
