#pragma once
// solve/refinement.h -- goes on with a solve on estimates where their noise would hide what is still to gain.
#include <memory>
#include <optional>

#include "solve/gauss_newton.h"
#include "solve/progress.h"

namespace luminist {

/// What was found on a few kept paths a pixel fits their noise a little. In rounds, each on four times as many paths of
/// another seed, this descends from there on single pixels (Gauss-Newton), and compares start, best and outcome on
/// whole pictures of paths that neither descent has seen: only what is better there is kept. From the first such
/// comparison on the report's numbers, the start's too, are of those paths. A round that gains little ends it: what is
/// left is noise. Where many pixels make rounds expensive, a descent on as few paths as the solve had, but others,
/// comes first: where even that gains little nothing more is done.
///
/// The style's parameters of the roles "kept" and "seed" choose the paths; states that are recorded have the user's
/// own. The renderer, target and progress must outlive it. thread: the renderer's. errors the renderer's. source
/// stochastic approximation with growing samples: Polak and Royset 2008; common random numbers for comparisons:
///         Glasserman and Yao 1992.
class Refinement final : public Solver {
 public:
  static constexpr int kPictures = 3;  ///< that a round compares
  /// Null for a renderer that does not estimate, for a style without those parameters, and where only colours turn:
  /// they are averages over all samples as they are. start: of the whole solve, whose error is told anew. edges: as for
  /// CellSampler.
  static std::unique_ptr<Refinement> create(Renderer& renderer, const Target& target, Progress& progress,
                                            ParamState start, std::shared_ptr<const EdgeMask> edges);
  ~Refinement() override;
  /// One iteration of a descent, or one picture.
  Result<bool> step() override;

 private:
  struct Descent;
  enum class Phase { kPrepare, kDescend, kJudge, kDone };
  /// The numbers of the style that choose paths.
  struct PathParams {
    int kept = 0;
    int seed = 0;
  };

  Refinement(Renderer& renderer, const Target& target, Progress& progress, ParamState start,
             std::shared_ptr<const EdgeMask> edges, PathParams params);
  /// A state with so many kept paths of the round's seed; for_judging: of one that no descent has.
  [[nodiscard]] ParamState with_paths(const ParamState& state, int paths, bool for_judging) const;
  /// The same with the user's paths.
  [[nodiscard]] ParamState as_given(const ParamState& state) const;
  [[nodiscard]] int given_paths() const;  ///< the user's
  [[nodiscard]] int paths_of_round() const;
  Result<void> prepare();
  void end_descent();
  Result<void> judge();
  void end_round();

  Renderer* renderer_;
  const Target* target_;
  Progress* progress_;
  ParamState start_;
  std::shared_ptr<const EdgeMask> edges_;
  PathParams params_;
  Phase phase_ = Phase::kPrepare;
  int round_ = 0;  ///< 0: the look ahead
  std::unique_ptr<Descent> descent_;
  ParamState found_;            ///< of this round
  std::vector<double> judged_;  ///< the errors of start, best and found, as far as they are known
};

}  // namespace luminist
