#include "solve/fast_solver.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace luminist {
namespace {

constexpr double kGoodEnough = 0.01;  // of the start's epsilon: nobody sees the rest
constexpr double kRoundGain = 0.02;   // a round that gains less was idle
constexpr int kRounds = 12;
constexpr int kIdleRounds = 3;     // a whole cycle: around the best, around the start, the simplex
constexpr int kScouts = 2;         // explorations before the first picture...
constexpr double kClear = 0.15;    // ...unless the middle level is this near to the target, of the start's distance
constexpr double kHopeless = 1.2;  // times the cost at home on the middle level: not worth the sharpest
constexpr int kVariants = 150;     // of one light
constexpr std::size_t kPool = 20;  // variants that descend
constexpr int kSimplexSlice = 25;  // evaluations on samples in one step

bool cheaper(const CellPoint& a, const CellPoint& b) {
  return a.cost < b.cost;
}

/// The cheapest points whose pictures differ from those of `taken` and from each other by some of their cost: what only
/// turns something that does not show is no other start.
std::vector<CellPoint> cheapest_distinct(const CellProblem& problem, std::vector<CellPoint> points, std::size_t count,
                                         const CellPoint* taken) {
  constexpr double kDistinct = 0.1;
  std::stable_sort(points.begin(), points.end(), cheaper);
  std::vector<CellField> seen;
  if (taken != nullptr) seen.push_back(problem.picture(*taken));
  std::vector<CellPoint> chosen;
  for (CellPoint& point : points) {
    if (chosen.size() == count) break;
    CellField picture = problem.picture(point);
    const bool known = std::any_of(seen.begin(), seen.end(), [&](const CellField& other) {
      double difference = 0.0;
      for (std::size_t c = 0; c < other.size(); ++c) {
        difference += problem.level().cells.weight[c] * glm::distance(picture[c], other[c]);
      }
      return difference < kDistinct * point.cost;
    });
    if (known) continue;
    seen.push_back(std::move(picture));
    chosen.push_back(std::move(point));
  }
  return chosen;
}

}  // namespace

/// Coordinates of the parameters that no closed form gives, and the simplex that walks in them.
struct FastSolver::SampleSimplex {
  AimMap map;
  std::vector<std::size_t> coordinate;  // of the map
  NelderMead walk;
  int evaluations = 0;
  int limit = 0;
  CellPoint best;

  static std::unique_ptr<SampleSimplex> create(const CellProblem& problem, const CellPoint& start, const Vec3& focus,
                                               double size) {
    AimMap map(start.state, problem.frame(), focus);
    std::vector<std::size_t> coordinate;
    std::vector<double> x;
    for (std::size_t k = 0; k < map.origin().size(); ++k) {
      if (problem.parts().scaled_by(map.units().list()[k]) >= 0) continue;
      coordinate.push_back(k);
      x.push_back(map.origin()[k]);
    }
    if (x.empty()) return nullptr;
    const int limit = 60 + 30 * static_cast<int>(x.size());
    NelderMead walk(x, {.size = size, .tolerance = 1e-3, .restarts = 1});
    return std::make_unique<SampleSimplex>(
        SampleSimplex{std::move(map), std::move(coordinate), std::move(walk), 0, limit, start});
  }
};

FastSolver::~FastSolver() = default;

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
  const CellSampler sampler(renderer_->surface(), *target_, std::move(edges));
  levels_ = fast_levels(sampler, renderer_->style().metric.blur, progress_->options().seed);
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
  for (const Dof& dof : objective_.map().list()) {
    if (parts_.scaled_by(dof) >= 0) continue;
    if (free_blocks_.empty() || free_blocks_.back() != dof.block) free_blocks_.push_back(dof.block);
  }
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
  begin_descents({start}, kFirst);
  return {};
}

void FastSolver::begin_descents(std::vector<ParamState> starts, std::span<const FastStage> plan) {
  starts_ = std::move(starts);
  std::reverse(starts_.begin(), starts_.end());  // taken from the back
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
    LUM_TRY(CellPoint point, problem.measure(starts_.back()));
    starts_.pop_back();
    descent_.emplace(problem, std::move(point), focus_);
  }
  LUM_TRY(const bool more, descent_->iterate());
  if (more && descent_->iterations() < stage.iterations) return {};
  ends_.push_back(descent_->point());
  descent_.reset();
  if (starts_.empty()) return end_stage();
  return {};
}

Result<void> FastSolver::end_stage() {
  std::stable_sort(ends_.begin(), ends_.end(), cheaper);
  if (plan_.size() == 1) {
    outcome_ = std::move(ends_.front());
    phase_ = Phase::kCheck;
    return {};
  }
  const bool searching = round_ == 0 && polishes_ == 0;
  if (searching && plan_.front().level == kMiddle) {
    LUM_TRY(const bool again, look_again());
    if (again) return {};
  }
  // What an exploration finds must be another place than where it set out from.
  const CellProblem& problem = problems_[plan_.front().level];
  std::optional<CellPoint> home;
  if (exploring_ && polishes_ == 0) {
    LUM_TRY(home, problem.measure(base_));
    if (plan_.front().level == kMiddle)
      std::erase_if(ends_, [&](const CellPoint& end) { return end.cost > kHopeless * home->cost; });
  }
  std::vector<ParamState> next;
  for (CellPoint& end : cheapest_distinct(problem, std::move(ends_), plan_.front().keep, home ? &*home : nullptr)) {
    next.push_back(std::move(end.state));
  }
  if (next.empty()) {
    begin_round();
    return {};
  }
  begin_descents(std::move(next), plan_.subspan(1));
  return {};
}

Result<bool> FastSolver::look_again() {
  const CellProblem& problem = problems_[kMiddle];
  if (!first_look_) {
    // Wide shadows differ from real ones by more than may be wanted. Seen from the start, whose picture is known, that
    // is no error; seen from far away it is: both ways are tried.
    first_look_ = ends_.front().state;
    LUM_TRY_VOID(correct(start_));
    LUM_TRY(incumbent_, problems_[kSharp].measure(start_));
    LUM_TRY(const CellPoint middle, problem.measure(start_));
    middle_start_ = middle.cost;
    begin_descents({start_}, kFirst);
    return true;
  }
  if (scouts_ == 0) {
    LUM_TRY(CellPoint other, problem.measure(*first_look_));
    ends_.push_back(std::move(other));
    std::stable_sort(ends_.begin(), ends_.end(), cheaper);
  }
  if (!scouted_ || ends_.front().cost < scouted_->cost) scouted_ = ends_.front();
  if (scouted_->cost > kClear * middle_start_ && scouts_ < kScouts && !free_blocks_.empty()) {
    ++scouts_;
    base_ = scouted_->state;
    pool_.clear();
    explored_ = 0;
    phase_ = Phase::kExplore;
    return true;
  }
  ends_.front() = *scouted_;
  return false;
}

Result<void> FastSolver::check() {
  constexpr double kWorthAPicture = 0.995;
  constexpr int kPolishes = 8;          // in a row
  constexpr double kPolishGain = 0.95;  // of the best so far: one that leaves more was the last
  const bool better = outcome_ && (outcome_->cost < kWorthAPicture * incumbent_->cost || round_ == 0 || polishes_ > 0);
  bool polish = false;
  if (better) {
    objective_.recentre(outcome_->state);
    LUM_TRY(const double epsilon, objective_.evaluate(objective_.unit(outcome_->state)));
    const double best_before = progress_->report().epsilon;
    progress_->record(outcome_->state, epsilon);
    if (epsilon < best_before) {
      LUM_TRY_VOID(correct(outcome_->state));
      LUM_TRY(incumbent_, problems_[kSharp].measure(outcome_->state));
      polish = polishes_ < kPolishes && epsilon < kPolishGain * best_before;
    }
  }
  outcome_.reset();
  if (polish && !good_enough()) {
    ++polishes_;
    begin_descents({incumbent_->state}, kPolish);
    return {};
  }
  polishes_ = 0;
  begin_round();
  return {};
}

void FastSolver::begin_round() {
  const double epsilon = progress_->report().epsilon;
  if (round_ > 0) {
    idle_rounds_ = epsilon < (1.0 - kRoundGain) * epsilon_before_round_ ? 0 : idle_rounds_ + 1;
  }
  const int rounds = progress_->options().restarts >= 0 ? progress_->options().restarts : kRounds;
  const bool wanted = progress_->options().until > 0.0;  // a stated goal is worth every round
  if (good_enough() || (idle_rounds_ >= kIdleRounds && !wanted) || round_ >= rounds || free_blocks_.empty()) {
    phase_ = Phase::kDone;
    return;
  }
  epsilon_before_round_ = epsilon;
  exploring_ = false;
  ++round_;
  pool_.clear();
  explored_ = 0;
  base_ = round_ % 3 == 2 ? start_ : incumbent_->state;  // another centre, other finds
  phase_ = round_ % 3 == 0 ? Phase::kSimplex : Phase::kExplore;
}

Result<void> FastSolver::explore() {
  const CellProblem& problem = problems_[kScout];
  const SampleCells& cells = levels_[kScout].cells;
  LUM_TRY(const CellPoint here, problem.measure(base_));
  const CellField picture = problem.picture(here);
  LightPlaces places{cells.position, cells.normal, {}, focus_};
  for (std::size_t c = 0; c < picture.size(); ++c) {
    places.say.push_back(cells.weight[c] * glm::length(picture[c] - cells.target[c]));
  }
  const int block = free_blocks_[explored_++];
  std::vector<int> touched;
  for (const Dof& dof : objective_.map().list()) {
    if (dof.block != block || parts_.scaled_by(dof) >= 0) continue;
    for (const int part : parts_.touched_by(here.state, dof)) touched.push_back(part);
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  std::vector<ParamState> states = light_variants(here.state, block, places, renderer_->frame(), kVariants, random_);
  std::vector<std::size_t> group_ends;  // of each scan only the best counts
  for (std::size_t i = 1; i <= states.size(); ++i) group_ends.push_back(i);
  for (std::vector<ParamState>& scan : light_scans(here.state, start_, block, renderer_->frame())) {
    std::move(scan.begin(), scan.end(), std::back_inserter(states));
    group_ends.push_back(states.size());
  }
  LUM_TRY(std::vector<CellPoint> points, problem.measure(std::move(states), &here, touched));
  std::size_t first = 0;
  for (const std::size_t end : group_ends) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
    if (end > first)
      pool_.push_back(std::move(*std::min_element(begin, points.begin() + static_cast<std::ptrdiff_t>(end), cheaper)));
    first = end;
  }
  if (explored_ < free_blocks_.size()) return {};
  pool_ = cheapest_distinct(problem, std::move(pool_), kPool, &here);
  if (pool_.empty() && round_ == 0) {  // no variant shows: what was found without them has not been compared yet
    begin_descents({scouted_->state}, kFromSharp);
    return {};
  }
  if (pool_.empty()) {
    begin_round();
    return {};
  }
  exploring_ = round_ > 0;
  std::vector<ParamState> starts;
  for (const CellPoint& point : pool_) starts.push_back(point.state);
  begin_descents(std::move(starts), kSearch);
  return {};
}

Result<void> FastSolver::run_simplex() {
  const CellProblem& problem = problems_[kMiddle];
  if (!simplex_) {
    LUM_TRY(CellPoint here, problem.measure(incumbent_->state));
    simplex_ = SampleSimplex::create(problem, here, focus_, 0.1);
    if (!simplex_) {
      phase_ = Phase::kDone;
      return {};
    }
  }
  SampleSimplex& s = *simplex_;
  for (int i = 0; i < kSimplexSlice && !s.walk.done() && s.evaluations < s.limit; ++i) {
    std::vector<double> x = s.map.origin();
    for (std::size_t k = 0; k < s.coordinate.size(); ++k) x[s.coordinate[k]] = s.walk.point()[k];
    LUM_TRY(CellPoint point, problem.measure(s.map.at(x)));
    const double value = point.cost + penalty(x);
    ++s.evaluations;
    if (value < s.best.cost) {
      s.best = std::move(point);
      s.best.cost = value;
    }
    s.walk.tell(value);
  }
  if (!s.walk.done() && s.evaluations < s.limit) return {};
  begin_descents({s.best.state}, kFromMiddle);
  simplex_.reset();
  return {};
}

}  // namespace luminist
