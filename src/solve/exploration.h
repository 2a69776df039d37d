#pragma once
// solve/exploration.h -- restarts: what a state's lights could be instead, and which of that is worth descending from.
#include <cstddef>
#include <optional>
#include <vector>

#include "solve/cell_problem.h"
#include "solve/random.h"

namespace luminist {

/// A point, and the block of parameters whose variation led to it; -1: several, or none.
struct FastFind {
  CellPoint point;
  int block = -1;
};

[[nodiscard]] inline bool cheaper(const FastFind& a, const FastFind& b) {
  return a.point.cost < b.point.cost;
}

/// The cheapest finds whose pictures differ from that of `taken` (may be null) and from each other by some of their
/// cost or, if that is less, of what they gain over the start: what only turns something that does not show is no other
/// start. No block gets more than its share of the places. start_cost: the start's, on the same cells.
std::vector<FastFind> cheapest_distinct(const CellProblem& problem, std::vector<FastFind> finds, std::size_t count,
                                        const CellPoint* taken, double start_cost);

/// Variants of one light after another, everything else staying as it is in the base: random ones of the light as it is
/// and as it was at the start, scans of what has no slope, and lights that exchange their places.
class Exploration {
 public:
  /// blocks: what is varied, those that have something unlocked besides colours. known: scans and exchanges around this
  /// base were made before; only the random variants are new. The problem must outlive it.
  Exploration(const CellProblem& problem, ParamState base, ParamState start, std::vector<int> blocks, const Vec3& focus,
              bool known);

  /// One block. returns false when it was the last one. errors the renderer's.
  Result<bool> step(Random& random);
  /// The best that was found and differs from the base; empties the exploration.
  [[nodiscard]] std::vector<FastFind> take(std::size_t count);

 private:
  /// Measures states in which `block` (and maybe `other`) is not the base's. Of each group only the best is kept.
  Result<void> measure(std::vector<std::vector<ParamState>> groups, int block, int other);
  Result<void> exchange(int block);

  const CellProblem* problem_;
  ParamState base_;
  ParamState start_;
  std::vector<int> blocks_;
  Vec3 focus_;
  bool known_;
  std::size_t next_ = 0;           ///< of blocks_
  std::optional<CellPoint> home_;  ///< the base, once measured
  double start_cost_ = 0.0;
  std::vector<FastFind> finds_;
};

}  // namespace luminist
