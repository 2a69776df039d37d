#pragma once
// solve/fast_solver.h -- Gauss-Newton on samples, from soft to sharp, with restarts and a simplex on the same samples.
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solve/exploration.h"
#include "solve/fast_levels.h"
#include "solve/gauss_newton.h"
#include "solve/progress.h"
#include "solve/sample_simplex.h"

namespace luminist {

/// The search, one bounded piece of work a step:
///
/// 1. compare the start on the full picture; what the lights that do not move add to the samples is read from it;
/// 2. descend (Gauss-Newton) from few cells with wide shadow and light edges to few with the real ones, once as the
///    samples are and once with the samples made exact at the start; explore variants of one light after another as
///    long as that is far from the target and gains; descend on many cells and compare the outcome on the full picture;
/// 3. polish: make the samples exact at the outcome and descend again, as long as that gains;
/// 4. unless that is good enough, rounds: variants around the best, variants around the start, a simplex over one light
///    on the samples, which sees what has no slope. What is better on many cells is compared on the full picture.
///
/// Where the style has bands (find_bands()), the simplex on many samples comes right after the first descents, and
/// pictures are compared on the way.
///
/// A variant descends with its own light and all colours first, on true edges where the samples are near the target.
/// Ends when the goal is reached or rounds gain nothing. Deterministic by options().seed.
/// source  making a coarse model exact at the best point so far: space mapping (Bandler et al. 2004).
/// The renderer, target and progress must outlive it. thread: the renderer's.
class FastSolver final : public Solver {
 public:
  /// edges: as for CellSampler. errors the renderer's.
  static Result<std::unique_ptr<FastSolver>> create(Renderer& renderer, const Target& target, Progress& progress,
                                                    std::shared_ptr<const EdgeMask> edges = nullptr);
  Result<bool> step() override;

 private:
  enum class Phase { kStart, kDescend, kCheck, kExplore, kSimplex, kDone };
  /// Where a descent begins, and the block that turns alone where a stage wants that.
  struct Start {
    ParamState state;
    int block = -1;
  };

  FastSolver(Renderer& renderer, const Target& target, Progress& progress);
  Result<void> prepare(std::shared_ptr<const EdgeMask> edges);
  /// Whether the style has thresholds, or colours that are solved. Few samples then say little of where a light
  /// belongs: its picture changes along edges only, or is met half by other colours.
  Result<void> find_bands();
  Result<void> compare_start();
  Result<void> descend();
  Result<void> check();
  Result<void> explore();
  Result<void> run_simplex();
  void begin_round();
  void begin_descents(std::vector<Start> starts, std::span<const FastStage> plan);
  void begin_exploration(const ParamState& base, FastLevel level);
  Result<void> end_stage();
  /// Before many cells are descended on for the first time: tries the other way, or explores, unless enough was tried.
  Result<void> look_again();
  /// Compares what samples have come to on the full picture, before the search goes on: a painting leaves an error that
  /// only the picture tells from a bad light, and whoever waits sees something.
  Result<void> glance(const CellPoint& point);
  [[nodiscard]] std::span<const FastStage> first_plan() const {
    return few_ ? std::span<const FastStage>(kFirstOfFew) : kFirst;
  }
  /// Makes the samples of all levels exact at a state, of which the last picture was made.
  Result<void> correct(const ParamState& state);
  /// The renderer's picture of a state, without some lights, on the cells of every level.
  Result<FastFields> shown(const ParamState& state, std::span<const int> without);
  [[nodiscard]] bool good_enough() const;

  Renderer* renderer_;
  const Target* target_;
  Progress* progress_;
  Objective objective_;
  Random random_;
  Vec3 focus_{0.0F};
  PictureParts parts_;
  FastLevels levels_;
  std::vector<CellProblem> problems_;  ///< one a level
  std::vector<int> free_blocks_;       ///< blocks with something unlocked besides colours
  bool few_ = false;                   ///< little besides colours is unlocked
  bool banded_ = false;                ///< see find_bands()

  Phase phase_ = Phase::kStart;
  std::span<const FastStage> plan_;  ///< what is left of it, the present stage first
  std::vector<Start> queue_;         ///< of this stage, still to descend
  int turned_ = -1;                  ///< the block of the present descent
  std::vector<FastFind> ends_;       ///< of this stage
  std::optional<GaussNewton> descent_;
  std::optional<CellPoint> incumbent_;  ///< the best that was compared in full, on kSharp
  std::optional<CellPoint> outcome_;    ///< the best of the present descents...
  FastLevel outcome_level_ = kSharp;    ///< ...and on which level
  ParamState start_;
  ParamState base_;                       ///< what is explored around
  std::optional<ParamState> first_look_;  ///< where the first descent came, before many cells
  std::optional<CellPoint> scouted_;      ///< the best on kNear, not yet taken to the sharpest
  int scouts_ = 0;                        ///< explorations before the first picture
  int idle_scouts_ = 0;                   ///< in a row without a gain
  double near_start_ = 0.0;               ///< the start's cost on kNear
  std::optional<Exploration> exploration_;
  std::span<const FastStage> search_;  ///< how its finds descend
  bool near_known_ = false;            ///< what is around the best on kNear was scanned for the present samples
  bool far_known_ = false;             ///< and around the start on kScout
  std::unique_ptr<SampleSimplex> simplex_;
  std::size_t simplex_turn_ = 0;  ///< of free_blocks_
  bool exploring_ = false;        ///< ends that are home again do not count
  int polishes_ = 0;              ///< descents in a row from the point that the samples are exact at
  int round_ = 0;
  int idle_rounds_ = 0;  ///< in a row without a gain
  double epsilon_before_round_ = 0.0;
};

}  // namespace luminist
