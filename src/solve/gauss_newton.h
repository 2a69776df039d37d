#pragma once
// solve/gauss_newton.h -- Levenberg and Marquardt's method on the cells of one level, one iteration at a time.
#include <vector>

#include "base/result.h"
#include "solve/aim_map.h"
#include "solve/cell_problem.h"

namespace luminist {

struct GaussNewtonOptions {
  double damping = 1e-2;      ///< first Marquardt parameter
  double largest_step = 0.5;  ///< in any unit coordinate
  double difference = 0.01;   ///< step of the finite differences; positions have the level's
  double enough_gain = 0.01;  ///< two gains in a row below this fraction end the descent
  int tries = 6;              ///< dampings tried in one iteration
};

/// Descends from a point. Slopes come of one batch of finite differences, in which a light's parameters evaluate that
/// light's part alone; colours have exact slopes at no cost and are solved again at every trial. The un-squared norm is
/// reweighted least squares; bounds are an active set. Directions are charted anew in every iteration.
///
/// source: Marquardt 1963; Madsen, Nielsen and Tingleff 2004; for colours Golub and Pereyra 1973.
class GaussNewton {
 public:
  /// The problem must outlive it. start is a point of that problem.
  GaussNewton(const CellProblem& problem, CellPoint start, const Vec3& focus, const GaussNewtonOptions& options = {});

  /// One batch of slopes and up to `tries` trials. returns false when the descent has ended. errors the renderer's.
  Result<bool> iterate();

  [[nodiscard]] const CellPoint& point() const { return point_; }
  [[nodiscard]] int iterations() const { return iterations_; }

 private:
  struct Slopes;  // the weighted normal equations at the present point
  Result<Slopes> slopes(const AimMap& map) const;
  Result<std::vector<CellField>> columns(const AimMap& map) const;
  [[nodiscard]] std::vector<double> step(const AimMap& map, const Slopes& slopes) const;
  Result<bool> improve(const AimMap& map, const Slopes& slopes);

  const CellProblem* problem_;
  CellPoint point_;
  Vec3 focus_;
  GaussNewtonOptions options_;
  double damping_;
  int iterations_ = 0;
  int small_gains_ = 0;
};

}  // namespace luminist
