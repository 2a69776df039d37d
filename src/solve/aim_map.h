#pragma once
// solve/aim_map.h -- unit coordinates in which a light that moves goes on pointing where it pointed.
#include <span>
#include <vector>

#include "render/param_state.h"

namespace luminist {

/// The unlocked degrees of freedom of a state in [0,1], as a UnitMap has them, with one difference: a step in the
/// position of a light keeps what it shines on. Its direction turns so that it still aims at the same place; its shape
/// (tangents), falloff distance and cutoffs follow its distance from there. Without that a light loses its place with
/// the first long step, and position, direction and shape can only creep along together.
///
/// A light takes part if its position (role "position") and both angles of its direction (role "direction") are free;
/// of the roles "shape", "falloff_distance" and "cutoff" what is free follows.
class AimMap {
 public:
  /// focus: where the picture counts, world; a light's aim is the point of its axis nearest to it.
  AimMap(const ParamState& state, const SceneFrame& frame, const Vec3& focus);

  [[nodiscard]] const UnitMap& units() const { return units_; }
  [[nodiscard]] int dofs() const { return units_.dofs(); }
  /// The state's own coordinates, moved into [0,1] where a value is out of its range. [dofs()]
  [[nodiscard]] const std::vector<double>& origin() const { return origin_; }
  /// Constraints hold in it.
  [[nodiscard]] ParamState at(std::span<const double> x) const;

 private:
  struct AimedLight {
    std::size_t light = 0;
    int position = 0;  ///< parameters
    int direction = 0;
    Vec3 place{0.0F};  ///< at the origin
    Vec3 way{0.0F};    ///< unit, at the origin
    float distance = 1.0F;
  };
  SceneFrame frame_;
  ParamState base_;
  UnitMap units_;
  std::vector<double> origin_;
  std::vector<AimedLight> aimed_;
};

/// The state with free values that are out of their ranges moved to the nearest end; the state itself if there are
/// none.
ParamState in_range(const ParamState& state, const SceneFrame& frame, const Vec3& focus);

/// A light whose distance from what it shines on changes keeps its footprint there: free half sizes and edges (role
/// "shape") shrink or grow, free "falloff_distance" and the starts of free "cutoff"s follow, all within their ranges.
void keep_footprint(ParamBlock& params, const SceneFrame& frame, float before, float now);

/// The rotation that takes unit vector a to unit vector b the short way, applied to v; v unchanged if they are
/// opposite.
Vec3 rotate_between(const Vec3& a, const Vec3& b, const Vec3& v);

}  // namespace luminist
