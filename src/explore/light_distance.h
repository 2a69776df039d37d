#pragma once
// explore/light_distance.h -- how differently two rigs light a scene.
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "explore/light_place.h"
#include "render/renderer.h"
#include "solve/sample_cells.h"

namespace luminist {

/// One light as the scene knows it: where its light comes from and what it does to the picture.
struct LightLook {
  std::string type;
  std::optional<LightPlace> place;
  CellField part;         ///< what the picture loses without it
  double strength = 0.0;  ///< mean length of that
};

/// [0, sqrt(2)]: the difference of the places, together with |a - b| / (|a| + |b|) of the parts. So parameters count as
/// far as they show: colour, shape, aim, distance and shadow alike.
double look_distance(const LightLook& a, const LightLook& b);

/// Root mean square over pairs of lights, each with the strength of its part as weight. Lights of one type may have
/// changed roles: those are paired whose squared distances are least in sum. Both have as many lights of each type.
/// cost O(lights^2 cells + lights^3).
double look_distance(const std::vector<LightLook>& a, const std::vector<LightLook>& b);

/// Looks at the free lights of states, one after another. All pixels of a scene that show something count alike, for
/// what paint leaves open is where solutions differ.
class LightEye {
 public:
  /// focus: where lights are seen from, world. The renderer must outlive it. thread: its.
  LightEye(Renderer& renderer, const Vec3& focus);

  /// The unmuted lights that have something unlocked, in rig order. errors the renderer's.
  /// cost an evaluation of a few hundred samples for each.
  Result<std::vector<LightLook>> look(const ParamState& state);

 private:
  Renderer* renderer_;
  Vec3 focus_;
  SampleCells cells_;
};

}  // namespace luminist
