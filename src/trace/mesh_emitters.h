#pragma once
// trace/mesh_emitters.h -- triangles that shine by themselves.
#include <cstdint>
#include <vector>

#include "trace/scene_surfaces.h"

namespace luminist {

/// A point on an emitter.
struct EmitterPoint {
  Vec3 position{0.0F};
  Vec3 normal{0.0F};  ///< unit; emitters shine to both sides
  Vec3 radiance{0.0F};
  float area_pdf = 0.0F;  ///< density per area of having been chosen
};

/// All triangles of a scene whose material emits, chosen in proportion to area and (mean) radiance.
class MeshEmitters {
 public:
  explicit MeshEmitters(const SceneSurfaces& surfaces);

  [[nodiscard]] bool empty() const { return !(total_ > 0.0); }
  /// choice in [0,1), place in [0,1)^2. Only of emitters that are not empty.
  [[nodiscard]] EmitterPoint sample(float choice, const Vec2& place) const;
  /// Density per area with which sample() chooses a point of that triangle.
  [[nodiscard]] float area_pdf(std::uint32_t object, std::uint32_t triangle) const;

 private:
  struct Triangle {
    std::uint32_t object = 0;
    std::uint32_t triangle = 0;
    float area_pdf = 0.0F;
  };
  const SceneSurfaces* surfaces_;
  std::vector<Triangle> triangles_;
  std::vector<double> sums_;        ///< [triangles] of area times radiance, up to and with each
  std::vector<std::size_t> first_;  ///< [objects] of an object's triangles in triangles_; kDark: it does not shine
  double total_ = 0.0;
};

/// The share of an estimate that goes to the strategy with density `own`, when `other` could have found the same
/// (power heuristic, Veach 1997).
inline float mis_weight(float own, float other) {
  const float ratio = other / own;
  return own > 0.0F ? 1.0F / (1.0F + ratio * ratio) : 0.0F;
}

}  // namespace luminist
