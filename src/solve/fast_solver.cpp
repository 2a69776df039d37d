#include "solve/fast_solver.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "render/metric.h"

namespace luminist {
namespace {

constexpr double kGoodEnough = 0.01;     // of the start's epsilon: nobody sees the rest
constexpr double kRoundGain = 0.02;      // of what was gained so far: a round that gains less was idle
constexpr int kRounds = 12;              // twice as many for a stated goal
constexpr int kIdleRounds = 3;           // a whole cycle: around the best, around the start, the simplex
constexpr int kIdleRoundsWithBands = 4;  // the simplex from the start, too
constexpr int kScouts = 5;               // explorations before the first picture...
constexpr int kIdleScouts = 2;           // ...fewer if so many in a row gain little...
constexpr double kScoutGain = 0.1;
constexpr double kGlanceGain = 0.02;  // worth a picture before the search goes on
constexpr double kClear = 0.15;       // ...or few samples are this near to the target, of the start's distance
constexpr double kFar = 0.3;          // of the start's distance: wide shadows lead
constexpr double kHopeless = 1.2;     // times the cost at home: not worth the sharpest
constexpr std::size_t kPool = 24;     // variants that descend
constexpr int kSimplexSlice = 25;     // points in one step
constexpr double kSimplexSize = 0.1;
constexpr double kWideSimplexSize = 0.2;
constexpr float kWideBand = 0.3F;  // as on the softest level
constexpr int kFew = 9;            // degrees of freedom besides colours

}  // namespace

FastSolver::FastSolver(Renderer& renderer, const Target& target, Progress& progress)
    : renderer_(&renderer),
      target_(&target),
      progress_(&progress),
      objective_(renderer, progress.best(), target),
      random_(progress.options().seed),
      start_(progress.best()),
      base_(progress.best()) {}

Result<std::unique_ptr<FastSolver>> FastSolver::create(Renderer& renderer, const Target& target, Progress& progress,
                                                       std::shared_ptr<const EdgeMask> edges) {
  std::unique_ptr<FastSolver> solver(new FastSolver(renderer, target, progress));
  LUM_TRY_VOID(solver->prepare(std::move(edges)));
  return solver;
}

Result<void> FastSolver::prepare(std::shared_ptr<const EdgeMask> edges) {
  const ParamState& start = progress_->best();
  const StyleMetric& metric = renderer_->style().metric;
  Target seen;
  if (metric.blur > 0.0F) seen = as_compared(*target_, metric);
  const CellSampler sampler(renderer_->surface(), metric.blur > 0.0F ? seen : *target_, std::move(edges));
  levels_ = fast_levels(sampler, progress_->options().seed, renderer_->estimates());
  LUM_TRY(parts_, PictureParts::create(*renderer_, start, levels_[kScout].cells.samples));
  LUM_TRY(const auto still, shown(start, objective_.moving()));
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    LUM_TRY(CellProblem problem,
            CellProblem::create(*renderer_, parts_, levels_[level], start, Norm::kUnsquared, still[level]));
    problems_.push_back(std::move(problem));
  }
  Vec3 sum(0.0F);
  for (const Vec3& position : levels_[kSoft].cells.position) sum += position;
  focus_ = sum / static_cast<float>(std::max(1, levels_[kSoft].cells.size()));
  int turning = 0;
  for (const Dof& dof : objective_.map().list()) {
    if (parts_.color_of(dof) >= 0) continue;
    if (start.blocks()[static_cast<std::size_t>(dof.block)]->schema()[dof.param].role == "color") continue;
    if (free_blocks_.empty() || free_blocks_.back() != dof.block) free_blocks_.push_back(dof.block);
    ++turning;
  }
  few_ = turning <= kFew;
  return find_bands();
}

Result<void> FastSolver::find_bands() {
  banded_ = std::ranges::any_of(parts_.colors(), [](const PartColor& color) { return color.of_style; });
  const SampleSet& probe = levels_[kScout].cells.samples;
  const Candidate start{&progress_->best()};
  std::vector<Vec3> sharp(probe.pixels.size());
  std::vector<Vec3> wide(probe.pixels.size());
  LUM_TRY_VOID(renderer_->evaluate({&start, 1}, probe, {.shadow_rays = 1}, sharp));
  LUM_TRY_VOID(renderer_->evaluate({&start, 1}, probe, {.threshold = kWideBand, .shadow_rays = 1}, wide));
  banded_ = banded_ || sharp != wide;
  return {};
}

Result<FastFields> FastSolver::shown(const ParamState& state, std::span<const int> without) {
  const std::vector<std::uint32_t> pixels = all_pixels(levels_);  // the picture is read once
  std::vector<Vec3> colors(pixels.size());
  LUM_TRY_VOID(renderer_->colors_at(state, without, pixels, colors));
  for (Vec3& color : colors) {
    if (!is_finite(color)) color = Vec3(0.0F);
  }
  return averages(levels_, colors);
}

Result<void> FastSolver::correct(const ParamState& state) {
  LUM_TRY(const auto pictures, shown(state, {}));
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    LUM_TRY(const CellPoint point, problems_[level].measure_as_is(state));
    problems_[level].correct(point, pictures[level]);
  }
  return {};
}

Result<bool> FastSolver::step() {
  switch (phase_) {
    case Phase::kStart:
      LUM_TRY_VOID(compare_start());
      break;
    case Phase::kDescend:
      LUM_TRY_VOID(descend());
      break;
    case Phase::kCheck:
      LUM_TRY_VOID(check());
      break;
    case Phase::kExplore:
      LUM_TRY_VOID(explore());
      break;
    case Phase::kSimplex:
      LUM_TRY_VOID(run_simplex());
      break;
    case Phase::kDone:
      break;
  }
  progress_->tally();
  return phase_ != Phase::kDone;
}

bool FastSolver::good_enough() const {
  const SolveReport& report = progress_->report();
  const double until = progress_->options().until;
  return report.epsilon <= (until > 0.0 ? until : kGoodEnough * report.epsilon_start);
}

Result<void> FastSolver::compare_start() {
  const ParamState given = progress_->best();
  LUM_TRY(const double epsilon, objective_.evaluate(objective_.unit(given)));
  progress_->record(given, epsilon);
  const ParamState start = in_range(given, renderer_->frame(), focus_);
  start_ = start;
  LUM_TRY(incumbent_, problems_[kSharp].measure(start));
  begin_descents({{start}}, first_plan());
  return {};
}

void FastSolver::begin_descents(std::vector<Start> starts, std::span<const FastStage> plan) {
  queue_ = std::move(starts);
  std::reverse(queue_.begin(), queue_.end());  // taken from the back
  plan_ = plan;
  ends_.clear();
  outcome_.reset();
  descent_.reset();
  phase_ = Phase::kDescend;
}

Result<void> FastSolver::descend() {
  const FastStage& stage = plan_.front();
  if (!descent_) {
    const CellProblem& problem = problems_[stage.level];
    LUM_TRY(CellPoint point, problem.measure(queue_.back().state));
    turned_ = queue_.back().block;
    queue_.pop_back();
    // Descents on few samples should stay near where they began: far away lie other minima. The last ones may creep
    // along a valley to its end.
    const bool last = stage.level >= kSharp;
    const GaussNewtonOptions options{.damping = last ? 1e-3 : 1e-2, .eager = last, .block = stage.alone ? turned_ : -1};
    descent_.emplace(problem, std::move(point), focus_, options);
  }
  LUM_TRY(const bool more, descent_->iterate());
  if (more && descent_->iterations() < stage.iterations) return {};
  ends_.push_back({descent_->point(), turned_});
  descent_.reset();
  if (queue_.empty()) return end_stage();
  return {};
}

Result<void> FastSolver::end_stage() {
  std::stable_sort(ends_.begin(), ends_.end(), cheaper);
  if (plan_.size() == 1) {
    outcome_ = std::move(ends_.front().point);
    outcome_level_ = plan_.front().level;
    phase_ = Phase::kCheck;
    return {};
  }
  const bool searching = round_ == 0 && polishes_ == 0;
  if (searching && plan_[1].level == kSharp) return look_again();
  // What an exploration finds must be another place than where it set out from.
  const CellProblem& problem = problems_[plan_.front().level];
  std::optional<CellPoint> home;
  if (exploring_ && polishes_ == 0) {
    LUM_TRY(home, problem.measure(base_));
    if (plan_[1].level == kSharp)
      std::erase_if(ends_, [&](const FastFind& end) { return end.point.cost > kHopeless * home->cost; });
  }
  LUM_TRY(const CellPoint start, problem.measure(start_));
  std::vector<Start> next;
  for (FastFind& end :
       cheapest_distinct(problem, std::move(ends_), plan_.front().keep, home ? &*home : nullptr, start.cost)) {
    next.push_back({std::move(end.point.state), end.block});
  }
  if (next.empty()) {
    begin_round();
    return {};
  }
  begin_descents(std::move(next), plan_.subspan(1));
  return {};
}

Result<void> FastSolver::look_again() {
  const CellProblem& near = problems_[kNear];
  if (!first_look_) {
    // Wide shadows differ from real ones by more than may be wanted. Seen from the start, whose picture is known, that
    // is no error; seen from far away it is: both ways are tried.
    first_look_ = ends_.front().point.state;
    LUM_TRY_VOID(correct(start_));
    LUM_TRY(incumbent_, problems_[kSharp].measure(start_));
    LUM_TRY(const CellPoint start, near.measure(start_));
    near_start_ = start.cost;
    begin_descents({{start_}}, first_plan());
    return {};
  }
  LUM_TRY(CellPoint end, near.measure(ends_.front().point.state));
  if (!scouted_) {
    LUM_TRY(CellPoint other, near.measure(*first_look_));
    if (other.cost < end.cost) end = std::move(other);
  }
  const double gain = scouted_ ? 1.0 - end.cost / scouted_->cost : 1.0;
  idle_scouts_ = gain < kScoutGain ? idle_scouts_ + 1 : 0;
  if (gain > 0.0) {
    scouted_ = std::move(end);
    near_known_ = false;
  }
  if (scouted_->cost > kClear * near_start_ && scouts_ < kScouts && idle_scouts_ < kIdleScouts &&
      !free_blocks_.empty()) {
    if (gain > kGlanceGain) LUM_TRY_VOID(glance(*scouted_));
    if (good_enough()) {
      phase_ = Phase::kDone;
      return {};
    }
    if (banded_) {
      begin_round();
      return {};
    }
    begin_exploration(scouted_->state, scouts_ == 0 && scouted_->cost > kFar * near_start_ ? kScout : kNear);
    ++scouts_;
    return {};
  }
  begin_descents({{scouted_->state}}, kFromSharp);
  return {};
}

Result<void> FastSolver::glance(const CellPoint& point) {
  constexpr double kReach = 1.2;  // times a stated goal, on samples: farther away the picture does not reach it
  const double until = progress_->options().until;
  if (until > 0.0 && point.cost > kReach * until) return {};
  const ParamState state = in_range(point.state, renderer_->frame(), focus_);  // a simplex leaves the ranges
  objective_.recentre(state);
  LUM_TRY(const double epsilon, objective_.evaluate(objective_.unit(state)));
  const bool better = epsilon < progress_->report().epsilon;
  progress_->record(state, epsilon);
  if (better) {
    LUM_TRY(incumbent_, problems_[kSharp].measure(state));
  }
  return {};
}

void FastSolver::begin_exploration(const ParamState& base, FastLevel level) {
  base_ = base;
  search_ = few_ ? std::span<const FastStage>(kFarSearchOfFew) : kFarSearch;
  if (level == kNear) search_ = kNearSearch;
  bool& known = level == kNear ? near_known_ : far_known_;
  exploration_.emplace(problems_[level], base, start_, free_blocks_, focus_, std::exchange(known, true));
  phase_ = Phase::kExplore;
}

Result<void> FastSolver::check() {
  // Gains are shares of what was gained so far: a painting leaves an error that no picture makes less.
  constexpr double kWorthAPicture = 0.005;
  constexpr int kPolishes = 8;          // in a row
  constexpr double kPolishReach = 2.0;  // of a stated goal: farther away a polish is no help
  constexpr double kPolishGain = 0.03;  // a polish that gains less was the last
  const double gained = progress_->report().epsilon_start - progress_->report().epsilon;
  const bool first = round_ == 0 || polishes_ > 0;
  LUM_TRY(const CellPoint here, problems_[outcome_level_].measure(incumbent_->state));
  const bool better = first || here.cost - outcome_->cost > kWorthAPicture * gained;
  bool polish = false;
  if (better) {
    objective_.recentre(outcome_->state);
    LUM_TRY(const double epsilon, objective_.evaluate(objective_.unit(outcome_->state)));
    const double best_before = progress_->report().epsilon;
    progress_->record(outcome_->state, epsilon);
    if (epsilon < best_before) {
      LUM_TRY_VOID(correct(outcome_->state));
      LUM_TRY(incumbent_, problems_[kSharp].measure(outcome_->state));
      const double until = progress_->options().until;
      polish = polishes_ < kPolishes && best_before - epsilon > kPolishGain * gained &&
               (until <= 0.0 || epsilon < kPolishReach * until);
      near_known_ = far_known_ = false;
    }
  }
  outcome_.reset();
  if (polish && !good_enough()) {
    ++polishes_;
    begin_descents({{incumbent_->state}}, kPolish);
    return {};
  }
  polishes_ = 0;
  begin_round();
  return {};
}

void FastSolver::begin_round() {
  const double epsilon = progress_->report().epsilon;
  if (round_ > 0) {
    const double gained = progress_->report().epsilon_start - epsilon;
    idle_rounds_ = epsilon_before_round_ - epsilon > kRoundGain * gained ? 0 : idle_rounds_ + 1;
  }
  const bool wanted = progress_->options().until > 0.0;  // a stated goal is worth every round
  const int most = wanted ? 2 * kRounds : kRounds;
  const int rounds = progress_->options().restarts >= 0 ? progress_->options().restarts : most;
  if (good_enough() || (idle_rounds_ >= (banded_ ? kIdleRoundsWithBands : kIdleRounds) && !wanted) ||
      round_ >= rounds || free_blocks_.empty()) {
    phase_ = Phase::kDone;
    return;
  }
  epsilon_before_round_ = epsilon;
  exploring_ = false;
  ++round_;
  // Where little turns, or bands have no slope, the simplex has the first turn; with bands a second one from the start.
  const int turn = banded_ ? (round_ + 2) % 4 : (round_ + (few_ ? 2 : 0)) % 3;
  switch (turn) {
    case 1:
      exploring_ = true;
      begin_exploration(incumbent_->state, kNear);
      break;
    case 2:
      exploring_ = true;
      begin_exploration(start_, kScout);  // another centre, other finds
      break;
    default:
      phase_ = Phase::kSimplex;
  }
}

Result<void> FastSolver::explore() {
  LUM_TRY(const bool more, exploration_->step(random_));
  if (more) return {};
  std::vector<FastFind> finds = exploration_->take(kPool);
  exploration_.reset();
  if (finds.empty()) {
    // No variant shows. What was found without them may not have been compared yet.
    if (round_ > 0) {
      begin_round();
    } else {
      begin_descents({{scouted_->state}}, kFromSharp);
    }
    return {};
  }
  std::vector<Start> starts;
  for (FastFind& find : finds) starts.push_back({std::move(find.point.state), find.block});
  begin_descents(std::move(starts), search_);
  return {};
}

Result<void> FastSolver::run_simplex() {
  if (!simplex_) {
    const CellProblem& problem = problems_[banded_ ? kSharp : few_ ? kExact : kNear];
    const bool anew = banded_ && round_ % 4 == 2;
    LUM_TRY(const CellPoint here, problem.measure(anew ? start_ : incumbent_->state));
    const int block = free_blocks_[simplex_turn_++ % free_blocks_.size()];
    simplex_ = SampleSimplex::create(problem, here, block, focus_, anew ? kWideSimplexSize : kSimplexSize);
    LUM_CHECK(simplex_ != nullptr, "free blocks have something to turn besides colours");
  }
  const double before = simplex_->best().cost;
  LUM_TRY(const bool more, simplex_->walk(kSimplexSlice));
  if (more) {
    const double gain = 1.0 - simplex_->best().cost / before;
    if (banded_ && gain > kGlanceGain) LUM_TRY_VOID(glance(simplex_->best()));
    if (good_enough()) phase_ = Phase::kDone;
    return {};
  }
  // A simplex leaves the ranges, and a descent may stay where it begins.
  begin_descents({{in_range(simplex_->best().state, renderer_->frame(), focus_)}},
                 few_ || banded_ ? std::span<const FastStage>(kPolish) : std::span(kNearSearch).subspan(1));
  simplex_.reset();
  return {};
}

}  // namespace luminist
