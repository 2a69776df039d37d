#pragma once
// solve/refinement.h -- goes on with a solve on estimates where their noise would hide what is still to gain.
#include <memory>
#include <optional>

#include "solve/gauss_newton.h"
#include "solve/progress.h"

namespace luminist {

/// What was found on a few kept paths a pixel fits their noise a little. In rounds, each on four times as many paths of
/// another seed, this descends from there on single pixels (Gauss-Newton), and compares start, best and outcome on
/// whole pictures of paths that neither descent has seen: only what is better there is kept. The report tells its error
/// on the user's paths, as it does of every solve. A round that gains little ends it: what is left is noise. Where
/// rounds would look along many paths, a descent on as few as the solve had, but others, looks ahead: where that gains
/// little, colours being solved anew before and after, nothing more is done.
///
/// The style's parameters of the roles "kept" and "seed" choose the paths; states that are recorded have the user's
/// own. The renderer, target and progress must outlive it. thread: the renderer's. errors the renderer's. source
/// stochastic approximation with growing samples: Polak and Royset 2008; common random numbers for comparisons:
///         Glasserman and Yao 1992.
class Refinement final : public Solver {
 public:
  static constexpr int kPictures = 4;  ///< that a round compares, and the one whose error is told
  /// Null for a renderer that does not estimate, for a style without those parameters, and where only colours turn:
  /// they are averages over all samples as they are. start: of the whole solve. edges: as for
  /// CellSampler.
  static std::unique_ptr<Refinement> create(Renderer& renderer, const Target& target, Progress& progress,
                                            ParamState start, std::shared_ptr<const EdgeMask> edges);
  ~Refinement() override;
  /// One iteration of a descent, or one picture.
  Result<bool> step() override;

 private:
  struct Descent;
  enum class Phase { kPrepare, kDescend, kJudge, kTell, kDone };
  enum class Outcome { kAsBefore, kFound, kStart };
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
  [[nodiscard]] int given_paths() const;         ///< the user's
  [[nodiscard]] int paths_of(int rounds) const;  ///< of a pixel, after so many rounds
  Result<void> prepare();
  void end_descent();
  /// On a whole picture, which counts as one.
  Result<double> error(const ParamState& state);
  Result<void> judge();
  Result<void> tell();
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
  Outcome outcome_ = Outcome::kAsBefore;
  ParamState best_;             ///< by what was judged so far
  ParamState found_;            ///< of this round
  std::vector<double> judged_;  ///< the errors of start, best and found, as far as they are known
};

}  // namespace luminist
