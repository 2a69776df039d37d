#pragma once
// solve/gauss_newton.h -- Levenberg and Marquardt's method on the cells of one level, one iteration at a time.
#include <vector>

#include "base/result.h"
#include "solve/aim_map.h"
#include "solve/cell_problem.h"

namespace luminist {

struct GaussNewtonOptions {
  double damping = 1e-2;      ///< first Marquardt parameter
  bool eager = false;         ///< after a success with one damping tries less, as long as that is better
  double largest_step = 0.5;  ///< in any unit coordinate
  double enough_gain = 0.01;  ///< two gains in a row below this fraction end the descent
  int tries = 6;              ///< dampings tried in one iteration
  int secants = 3;            ///< iterations that go on with the slopes of the last one, where those still serve
  int block = -1;             ///< besides colours only this block of parameters turns; -1: all
};

/// Descends from a point. Slopes come of one batch of finite differences, in which a light's parameters evaluate that
/// light's part alone; colours have exact slopes at no cost and are solved again at every trial. Between two batches
/// slopes follow what trials have shown, part by part. The un-squared norm is reweighted least squares; bounds are an
/// active set. Directions are charted anew in every iteration; slopes that follow keep the axes of their batch.
///
/// source: Marquardt 1963; Madsen, Nielsen and Tingleff 2004; for colours Golub and Pereyra 1973; for slopes that
/// follow Broyden 1965.
class GaussNewton {
 public:
  /// The problem must outlive it. start is a point of that problem.
  GaussNewton(const CellProblem& problem, CellPoint start, const Vec3& focus, const GaussNewtonOptions& options = {});

  /// At most one batch of slopes and up to `tries` trials. returns false when the descent has ended. errors the
  /// renderer's.
  Result<bool> iterate();

  [[nodiscard]] const CellPoint& point() const { return point_; }
  [[nodiscard]] int iterations() const { return iterations_; }  ///< batches of slopes

 private:
  /// How what a light adds changes with one coordinate, the style's colours being the point's; white where the light's
  /// colour scales it.
  struct Slope {
    std::size_t coordinate = 0;  ///< of the map
    int part = 0;                ///< the light's rest
    CellField field;
  };
  struct Equations;  // the weighted normal equations at the present point
  [[nodiscard]] bool turns(const Dof& dof) const;
  Result<void> measure_slopes(const AimMap& map);
  /// Slopes after a step that came out otherwise than they said. step: in coordinates of the map.
  void correct_slopes(const CellPoint& before, std::span<const double> step);
  [[nodiscard]] std::vector<CellField> columns(const AimMap& map, std::span<const std::size_t> turned) const;
  [[nodiscard]] Equations equations(const AimMap& map) const;
  [[nodiscard]] std::vector<double> step(const AimMap& map, const Equations& equations, double damping) const;
  /// Steps until one is better. returns the part of the cost that is gone.
  Result<double> improve(const AimMap& map, int tries);

  const CellProblem* problem_;
  CellPoint point_;
  Vec3 focus_;
  GaussNewtonOptions options_;
  double damping_;
  std::vector<Slope> slopes_;
  std::vector<int> touched_;  ///< parts with slopes
  int secants_ = 0;           ///< iterations since slopes were measured
  int iterations_ = 0;
  int small_gains_ = 0;
};

}  // namespace luminist
