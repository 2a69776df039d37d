#pragma once
// solve/objective.h -- how far a picture is from what the artist painted (paper, section 5).
#include <span>
#include <vector>

#include "base/result.h"
#include "render/renderer.h"

namespace luminist {

/// epsilon(x) = sum_i I_i |T_i - R_i(x)| / sum_i I_i  +  sum_k max(0, (2 x_k - 1)^2 - 1)
///
/// x is [dofs()], the unlocked degrees of freedom of a state in UnitMap order, mapped to [0,1]; it may leave [0,1].
/// R_i(x) is the picture of state(x), which keeps its constraints. Same x and same centre, same bits. The renderer and
/// the target must outlive it. thread: the renderer's. source: Pellacini et al. 2007, sections 5 and 5.1.
class Objective {
 public:
  Objective(Renderer& renderer, ParamState centre, const Target& target);

  [[nodiscard]] int dofs() const { return map_.dofs(); }
  [[nodiscard]] const UnitMap& map() const { return map_; }
  /// The lights that have something unlocked, or use the shadows of one that has; all, if anything but lights is free.
  [[nodiscard]] const std::vector<int>& moving() const { return moving_; }

  /// Infinite where the renderer's error is not finite. errors the renderer's. cost one picture.
  Result<double> evaluate(std::span<const double> x);

  [[nodiscard]] std::vector<double> unit(const ParamState& state) const;
  [[nodiscard]] ParamState state(std::span<const double> x) const;

  /// Charts directions around another state's: a restart goes as far from there as the start did from its own.
  void recentre(const ParamState& state);

 private:
  Renderer* renderer_;
  const Target* target_;
  ParamState centre_;
  UnitMap map_;
  std::vector<int> moving_;
};

/// The second sum of epsilon at a state.
double penalty_of(const ParamState& state, const SceneFrame& frame);

/// Places in the rig of the lights that a map's degrees of freedom change, as Objective::moving().
std::vector<int> moving_lights(const ParamState& state, const UnitMap& map);

}  // namespace luminist
