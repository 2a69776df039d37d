#include "solve/refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "render/metric.h"
#include "solve/sample_cells.h"

namespace luminist {
namespace {

constexpr int kRefinements = 2;       // after the look ahead
constexpr int kManyPaths = 24'000;    // of all cells: where a round needs more, a look ahead is cheap and sure
constexpr int kMorePaths = 4;         // times those of the round before
constexpr int kMostPaths = 256;       // a pixel
constexpr int kPixels = 3000;         // that a descent looks at
constexpr int kPixelsAhead = 1500;    // ...of a look ahead
constexpr int kMostWork = 6'000'000;  // paths of a batch of slopes
constexpr int kSlopeBatches = 4;      // of one descent
constexpr int kJudges = 2;            // times the user's paths, for whole pictures
constexpr double kWorthwhile = 0.01;  // of what was gained so far: a round that gains less was the last
constexpr double kSeedStep = 7919.0;  // seeds of rounds are as far apart

}  // namespace

/// One round's problem; its parts point into each other.
struct Refinement::Descent {
  Level level;
  PictureParts parts;
  std::optional<CellProblem> problem;
  std::optional<GaussNewton> newton;
  // In the look ahead, both with their colours solved:
  double cost_start = 0.0;  ///< of the whole solve's start
  double cost = 0.0;        ///< of what it found
};

std::unique_ptr<Refinement> Refinement::create(Renderer& renderer, const Target& target, Progress& progress,
                                               ParamState start, std::shared_ptr<const EdgeMask> edges) {
  const ParamSchema& schema = start.style.schema();
  const auto kept = schema.by_role("kept");
  const auto seed = schema.by_role("seed");
  if (!renderer.estimates() || !kept || !seed) return nullptr;
  const std::vector<const ParamBlock*> blocks = std::as_const(start).blocks();
  const UnitMap map = UnitMap::create(blocks, renderer.frame());
  const bool turns = std::ranges::any_of(map.list(), [&](const Dof& dof) {
    return blocks[static_cast<std::size_t>(dof.block)]->schema()[dof.param].role != "color";
  });
  if (!turns) return nullptr;
  return std::unique_ptr<Refinement>(
      new Refinement(renderer, target, progress, std::move(start), std::move(edges), {*kept, *seed}));
}

Refinement::Refinement(Renderer& renderer, const Target& target, Progress& progress, ParamState start,
                       std::shared_ptr<const EdgeMask> edges, PathParams params)
    : renderer_(&renderer),
      target_(&target),
      progress_(&progress),
      start_(std::move(start)),
      edges_(std::move(edges)),
      params_(params),
      best_(progress.best()),
      found_(best_) {}

Refinement::~Refinement() = default;

int Refinement::given_paths() const {
  return static_cast<int>(std::clamp(start_.style.get(params_.kept), 1.0, 1.0 * kMostPaths));
}

ParamState Refinement::with_paths(const ParamState& state, int paths, bool for_judging) const {
  ParamState other = state;
  const double seed = start_.style.get(params_.seed);
  const double most = start_.style.schema()[params_.seed].range_max[0];
  const double step = kSeedStep * (2 * round_ + (for_judging ? 2 : 1));
  other.style.set(params_.kept, 0, paths);
  other.style.set(params_.seed, 0, std::fmod(seed + step, most + 1.0));
  return other;
}

ParamState Refinement::as_given(const ParamState& state) const {
  ParamState given = state;
  for (const int param : {params_.kept, params_.seed}) given.style.set(param, 0, start_.style.get(param));
  return given;
}

int Refinement::paths_of(int rounds) const {
  int paths = given_paths();
  for (int round = 0; round < rounds; ++round) paths *= kMorePaths;
  // A batch of slopes is not interrupted: many numbers are looked at along fewer paths.
  const int numbers = UnitMap::create(std::as_const(start_).blocks(), renderer_->frame()).dofs();
  return std::min({paths, kMostPaths, kMostWork / (kPixels * std::max(1, numbers))});
}

Result<void> Refinement::prepare() {
  if (paths_of(std::max(1, round_)) <= given_paths()) {
    phase_ = Phase::kDone;
    return {};
  }
  const StyleMetric& metric = renderer_->style().metric;
  Target seen;
  if (metric.blur > 0.0F) seen = as_compared(*target_, metric);
  const CellSampler sampler(renderer_->surface(), metric.blur > 0.0F ? seen : *target_, edges_);
  auto descent = std::make_unique<Descent>();
  const std::uint64_t seed = progress_->options().seed + 100 + static_cast<std::uint64_t>(round_);
  descent->level = {sampler.cut(kPixels, 1, seed), {0.0F, 0.0F, 0.0F, 8}, 0.006, 0.005, kSlopeBatches};
  SampleCells& cells = descent->level.cells;
  if (round_ == 0 && cells.size() * given_paths() * kMorePaths <= kManyPaths) round_ = 1;
  if (round_ == 0) cells = sampler.cut(kPixelsAhead, 1, seed);
  const int paths = paths_of(round_);
  const ParamState state = with_paths(best_, paths, false);
  LUM_TRY(descent->parts, PictureParts::create(*renderer_, state, cells.samples));
  LUM_TRY(CellProblem problem,
          CellProblem::create(*renderer_, descent->parts, descent->level, state, Norm::kUnsquared));
  descent->problem.emplace(std::move(problem));
  LUM_TRY(CellPoint point, descent->problem->measure(state));
  if (round_ == 0) {
    LUM_TRY(const CellPoint start, descent->problem->measure(with_paths(start_, paths, false)));
    descent->cost_start = start.cost;
    descent->cost = point.cost;
  }
  Vec3 sum(0.0F);
  for (const Vec3& position : cells.position) sum += position;
  const Vec3 focus = sum / static_cast<float>(std::max(1, cells.size()));
  const GaussNewtonOptions options{.damping = 1e-3, .eager = true};
  descent->newton.emplace(*descent->problem, std::move(point), focus, options);
  descent_ = std::move(descent);
  phase_ = Phase::kDescend;
  return {};
}

/// A look ahead only tells whether there is something to gain: what it finds fits the noise of as few paths.
void Refinement::end_descent() {
  if (round_ > 0) {
    found_ = as_given(descent_->newton->point().state);
    phase_ = Phase::kJudge;
    return;
  }
  const double found = descent_->newton->point().cost;
  const bool worthwhile = descent_->cost - found > kWorthwhile * (descent_->cost_start - found);
  descent_.reset();
  round_ = 1;
  phase_ = worthwhile ? Phase::kPrepare : Phase::kDone;
}

Result<double> Refinement::error(const ParamState& state) {
  Objective objective(*renderer_, state, *target_);
  progress_->count();
  return objective.evaluate(objective.unit(state));
}

Result<void> Refinement::judge() {
  const std::array<const ParamState*, 3> states{&start_, &best_, &found_};
  LUM_TRY(const double epsilon, error(with_paths(*states[judged_.size()], kJudges * given_paths(), true)));
  judged_.push_back(epsilon);
  if (judged_.size() == states.size()) end_round();
  return {};
}

void Refinement::end_round() {
  const double start = judged_[0];
  const double best = judged_[1];
  const double found = judged_[2];
  judged_.clear();
  descent_.reset();
  if (found < std::min(best, start)) {
    best_ = found_;
    outcome_ = Outcome::kFound;
  } else if (start < best) {
    best_ = start_;  // what the fewer paths showed as a gain was their noise
    outcome_ = Outcome::kStart;
  }
  ++round_;
  const bool worthwhile = found < best && best - found > kWorthwhile * (start - found);
  const bool affordable = progress_->options().max_evals - progress_->report().evals >= kPictures;
  const bool more = worthwhile && affordable && round_ <= kRefinements && progress_->running();
  phase_ = more ? Phase::kPrepare : Phase::kTell;
}

Result<void> Refinement::tell() {
  phase_ = Phase::kDone;
  const double start = progress_->report().epsilon_start;
  if (outcome_ == Outcome::kFound) {
    LUM_TRY(const double epsilon, error(best_));
    if (epsilon < start) {
      progress_->improve(best_, epsilon);
      return {};
    }
    outcome_ = Outcome::kStart;
  }
  if (outcome_ == Outcome::kStart) progress_->improve(start_, start);
  return {};
}

Result<bool> Refinement::step() {
  switch (phase_) {
    case Phase::kPrepare:
      LUM_TRY_VOID(prepare());
      break;
    case Phase::kDescend: {
      LUM_TRY(const bool more, descent_->newton->iterate());
      if (more) break;
      end_descent();
      break;
    }
    case Phase::kJudge:
      LUM_TRY_VOID(judge());
      break;
    case Phase::kTell:
      LUM_TRY_VOID(tell());
      break;
    case Phase::kDone:
      break;
  }
  progress_->tally();
  return phase_ != Phase::kDone;
}

}  // namespace luminist
