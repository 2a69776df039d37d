#pragma once
// solve/sample_simplex.h -- the simplex on samples: it sees what has no slope, such as a shadow that should be
// elsewhere.
#include <memory>
#include <vector>

#include "solve/aim_map.h"
#include "solve/cell_problem.h"
#include "solve/nelder_mead.h"

namespace luminist {

/// Walks in the unlocked parameters of one block; colours are solved at every point. The problem must outlive it.
class SampleSimplex {
 public:
  /// start: a point of the problem. size: of the first simplex, unit coordinates. Null if the block has nothing
  /// unlocked besides colours.
  static std::unique_ptr<SampleSimplex> create(const CellProblem& problem, const CellPoint& start, int block,
                                               const Vec3& focus, double size);

  /// At most so many points. returns false when the walk has ended. errors the renderer's.
  Result<bool> walk(int points);
  /// The best so far; the cost of what is not the start has the penalty.
  [[nodiscard]] const CellPoint& best() const { return best_; }

 private:
  SampleSimplex(const CellProblem& problem, const CellPoint& start, AimMap map, std::vector<std::size_t> coordinates,
                double size);

  const CellProblem* problem_;
  CellPoint start_;
  CellPoint best_;
  AimMap map_;
  std::vector<std::size_t> coordinates_;  ///< of the map
  std::vector<int> touched_;              ///< parts that they change
  NelderMead simplex_;
  int left_ = 0;  ///< points
};

}  // namespace luminist
