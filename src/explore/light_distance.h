#pragma once
// explore/light_distance.h -- how differently two rigs light the same picture.
#include <vector>

#include "base/result.h"
#include "explore/light_walk.h"
#include "render/renderer.h"
#include "solve/sample_cells.h"

namespace luminist {

/// A distance in light space between states that differ in the values of their free lights only.
///
/// Lights of one type may have changed roles: those go together whose walks (light_walk) are shortest in sum. A pair is
/// as far apart as the root of the sum over its walk of v d^2, d being the difference of a step in light space and v,
/// in [0,1], how much of the light's part of the picture changes with that step: what does not show does not count. The
/// mean of the walk there and the walk back is taken. The distance of the rigs is the root mean square over the pairs,
/// each with the strength of its part of the picture as weight. 0 for equal lights, hardly ever above 1.
///
/// The picture is looked at on a few hundred samples of the target. The renderer must outlive it. thread: its.
class LightDistance {
 public:
  LightDistance(Renderer& renderer, const Target& target);

  /// errors the renderer's. cost about 8 evaluations of the samples for each free light.
  Result<double> between(const ParamState& a, const ParamState& b);

  /// Where the picture counts, world.
  [[nodiscard]] const Vec3& focus() const { return focus_; }
  [[nodiscard]] const SampleCells& cells() const { return cells_; }

 private:
  struct Pair {
    double strength = 0.0;  ///< of the light's part of the picture
    double squared = 0.0;   ///< distance
  };
  Result<Pair> walk(const ParamState& from, std::size_t light, const Light& to);

  Renderer* renderer_;
  SampleCells cells_;
  Vec3 focus_{0.0F};
};

/// Which light of b takes the part of which of a, among free lights of equal type; others keep their own. [lights]
std::vector<std::size_t> light_pairs(const LightRig& a, const LightRig& b, const SceneFrame& frame, const Vec3& focus);

}  // namespace luminist
