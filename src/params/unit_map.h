#pragma once
// params/unit_map.h -- the unlocked degrees of freedom of some blocks as a point of the unit cube (paper, section 5.1).
#include <span>
#include <vector>

#include "base/math.h"
#include "params/param_block.h"

namespace luminist {

/// max(0, (2x - 1)^2 - 1): zero in [0,1], climbing steeply outside (paper, section 5.1).
double penalty(double x);
/// Sum over the coordinates.
double penalty(std::span<const double> x);

/// One unlocked degree of freedom.
struct Dof {
  int block = 0;      ///< index into the blocks given to create()
  int param = 0;      ///< index into the block's schema
  int component = 0;  ///< of the parameter; for a direction the axis (0 or 1) of its tangent chart
};

class UnitMap {
 public:
  /// Lists the unlocked degrees of freedom block by block. A direction is charted around its value at this moment:
  /// x = (1/2, 1/2) is that direction, a step of 1 in x is the range in radians along a great circle.
  static UnitMap create(std::span<const ParamBlock* const> blocks, const SceneFrame& frame);

  [[nodiscard]] int dofs() const { return static_cast<int>(dofs_.size()); }
  [[nodiscard]] const std::vector<Dof>& list() const { return dofs_; }

  /// x [dofs()] of the blocks' present values; outside [0,1] where a value is outside its range, which may be
  /// ParamBlock::limits().
  [[nodiscard]] std::vector<double> to_unit(std::span<const ParamBlock* const> blocks) const;
  /// Writes the values of x; x may leave [0,1] (log scales extrapolate, nothing is clamped). Locked values stay.
  void from_unit(std::span<const double> x, std::span<ParamBlock* const> blocks) const;

 private:
  SceneFrame frame_;
  std::vector<Dof> dofs_;
  std::vector<Vec3> chart_;  ///< per dof: base direction of a direction's chart
};

}  // namespace luminist
