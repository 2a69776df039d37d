#include "solve/live_solve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/check.h"
#include "render/metric.h"
#include "solve/gauss_newton.h"
#include "solve/objective.h"

namespace luminist {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kCells = 320;  // few enough for several iterations in a slice, enough for a small new stroke
constexpr int kPerCell = 2;
constexpr double kMoved = 0.15;         // of the cells' mass: cut anew
constexpr int kDescentIterations = 20;  // of one descent; the search that comes after it has all the time
constexpr int kSearches = 2;            // when the hand rests
constexpr double kGain = 0.995;         // on the samples, to be worth a picture

void copy_box(const Target& from, Target& to, const PixelBox& box) {
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const std::size_t i = to.color.index(x, y);
      to.color.set_rgb(i, from.color.rgb(i));
      to.importance.data[i] = from.importance.data[i];
      if (i < to.stroke.size() && i < from.stroke.size()) to.stroke[i] = from.stroke[i];
      sanitize_pixel(to, i);
    }
  }
}

bool same_values(const ParamState& a, const ParamState& b) {
  return std::ranges::equal(a.blocks(), b.blocks(),
                            [](const ParamBlock* left, const ParamBlock* right) { return left->same_values(*right); });
}

}  // namespace

class LiveSolve::Impl {
 public:
  Impl(Renderer& renderer, ParamState start, const Target& target, const SolveOptions& options,
       std::shared_ptr<const EdgeMask> edges)
      : renderer_(&renderer),
        options_(options),
        target_(clean(target)),
        edges_(edges ? std::move(edges) : std::make_shared<const EdgeMask>(edge_pixels(renderer.surface()))),
        seen_(blurs() ? as_compared(target_, renderer.style().metric) : Target{}),
        sampler_(renderer.surface(), blurs() ? seen_ : target_, edges_),
        first_(start),
        best_(std::move(start)) {
    const std::vector<const ParamBlock*> blocks = std::as_const(best_).blocks();
    moving_ = moving_lights(best_, UnitMap::create(blocks, renderer.frame()));
  }

  Result<void> begin(Image picture);
  Result<void> retarget(const Target& target, const PixelBox& changed);
  Result<bool> step();
  Result<bool> show();
  void offer(ParamState start);

  [[nodiscard]] const ParamState& best() const { return best_; }
  [[nodiscard]] const std::shared_ptr<const Image>& picture() const { return picture_; }
  [[nodiscard]] const LiveReport& report() const { return report_; }

 private:
  enum class Phase { kBegin, kDescend, kSearch, kDone };
  /// The same samples twice: soft, where shadows and edges have slopes, and as the picture is.
  enum LevelName : std::size_t { kFollow, kExact };

  static Target clean(Target target) {
    sanitize(target);
    return target;
  }
  [[nodiscard]] bool blurs() const { return renderer_->style().metric.blur > 0.0F; }
  Result<void> cut();
  Result<void> start_descent();
  Result<void> descend();
  Result<void> search();
  void enter(Phase phase);
  void tell(double error, double penalty) {
    report_.epsilon = error + penalty;
    report_.penalty = penalty;
  }
  [[nodiscard]] Image compared(const Image& picture) const {
    return blurs() ? as_compared(picture, renderer_->style().metric) : Image();
  }
  /// Of a picture, or of what the metric compares in its place, in those rows.
  void compare(const Image& picture, const Image& compared, RowErrors& errors, const PixelBox& rows) const {
    errors.compare(blurs() ? compared : picture, blurs() ? seen_.color : target_.color, target_.importance, rows.y0,
                   rows.y1);
  }
  [[nodiscard]] PixelBox everywhere() const { return {0, 0, target_.color.width, target_.color.height}; }

  Renderer* renderer_;
  SolveOptions options_;
  Target target_;
  std::shared_ptr<const EdgeMask> edges_;
  Target seen_;  ///< the target as a metric compares it that blurs; else empty
  CellSampler sampler_;
  std::optional<PictureParts> parts_;
  std::array<Level, 2> levels_;
  std::vector<CellProblem> problems_;  ///< one a level; empty while nothing counts
  Vec3 focus_{0.0F};

  Phase phase_ = Phase::kBegin;
  LevelName level_ = kFollow;  ///< of the descent
  std::vector<ParamState> offers_;
  std::optional<GaussNewton> descent_;
  std::optional<SolveSession> session_;
  std::optional<ParamState> found_;  ///< not shown yet
  bool compared_ = false;            ///< what was found is nearer on the full picture already
  double handed_ = 0.0;              ///< epsilon of the session's last find that was taken up
  int searches_ = 0;                 ///< begun for the present target
  ParamState first_;                 ///< where the lights began: given first, or offered last
  ParamState best_;
  std::vector<int> moving_;  ///< lights that may turn
  std::shared_ptr<const Image> picture_;
  Image seen_picture_;  ///< as a metric compares it that blurs; else empty
  RowErrors errors_;    ///< of the picture shown
  LiveReport report_;
};

Result<void> LiveSolve::Impl::begin(Image picture) {
  if (picture.empty()) {
    LUM_TRY(picture, renderer_->render(best_));
    ++report_.pictures;
  }
  picture_ = std::make_shared<const Image>(std::move(picture));
  seen_picture_ = compared(*picture_);
  LUM_TRY_VOID(cut());
  compare(*picture_, seen_picture_, errors_, everywhere());
  tell(errors_.error(), penalty_of(best_, renderer_->frame()));
  enter(Phase::kBegin);
  return {};
}

/// Cells for the present target, and what does not change on them.
Result<void> LiveSolve::Impl::cut() {
  problems_.clear();
  level_ = kFollow;
  if (sampler_.nothing_counts()) return {};
  levels_[kFollow] = {
      sampler_.cut(kCells, kPerCell, options_.seed), {0.03F, 0.04F, 0.1F, 2}, 0.008, 0.005, kDescentIterations};
  levels_[kExact] = {levels_[kFollow].cells, {0.0F, 0.0F, 0.0F, 2}, 0.004, 0.003, kDescentIterations};
  const SampleCells& cells = levels_[kFollow].cells;
  if (!parts_) {
    LUM_TRY(parts_, PictureParts::create(*renderer_, best_, cells.samples));
  }
  for (const Level& level : levels_) {
    LUM_TRY(CellProblem problem, CellProblem::create(*renderer_, *parts_, level, best_, Norm::kUnsquared));
    problems_.push_back(std::move(problem));
  }
  focus_ = Vec3(0.0F);
  for (const Vec3& position : cells.position) focus_ += position / static_cast<float>(cells.size());
  return {};
}

void LiveSolve::Impl::enter(Phase phase) {
  phase_ = problems_.empty() ? Phase::kDone : phase;
  report_.following = phase_ == Phase::kBegin || phase_ == Phase::kDescend;
  report_.settled = phase_ == Phase::kDone;
  if (!report_.settled) {
    report_.termination = Termination::kRunning;
  } else if (report_.termination == Termination::kRunning) {
    report_.termination = Termination::kConverged;
  }
}

Result<void> LiveSolve::Impl::retarget(const Target& target, const PixelBox& changed) {
  LUM_CHECK(target.color.same_size(target_.color) && target.importance.same_size(target_.importance),
            "a target keeps its size");
  if (changed.empty()) return {};
  copy_box(target, target_, changed);
  if (blurs()) {
    seen_.color = compared(target_.color);
    seen_.importance = target_.importance;
  }
  const PixelBox reached = blurs() ? everywhere() : changed;  // blurred paint reaches beyond its box
  sampler_.update(reached);
  double moved = 1.0;
  if (!problems_.empty()) {
    moved = sampler_.refresh(levels_[kFollow].cells);
    levels_[kExact].cells = levels_[kFollow].cells;
  }
  descent_.reset();
  session_.reset();
  searches_ = 0;
  compared_ = false;
  compare(*picture_, seen_picture_, errors_, reached);
  tell(errors_.error(), penalty_of(best_, renderer_->frame()));
  if (moved > kMoved) LUM_TRY_VOID(cut());
  enter(Phase::kBegin);
  return {};
}

void LiveSolve::Impl::offer(ParamState start) {
  keep_constraints(start.rig);
  first_ = start;
  offers_.push_back(std::move(start));
  level_ = kFollow;
  descent_.reset();
  session_.reset();
  searches_ = 0;
  compared_ = false;
  enter(Phase::kBegin);
}

Result<bool> LiveSolve::Impl::step() {
  switch (phase_) {
    case Phase::kBegin:
      LUM_TRY_VOID(start_descent());
      break;
    case Phase::kDescend:
      LUM_TRY_VOID(descend());
      break;
    case Phase::kSearch:
      LUM_TRY_VOID(search());
      break;
    case Phase::kDone:
      break;
  }
  return phase_ != Phase::kDone;
}

Result<void> LiveSolve::Impl::start_descent() {
  std::vector<ParamState> starts = std::move(offers_);
  offers_.clear();
  starts.insert(starts.begin(), best_);
  if (found_) starts.push_back(*found_);
  LUM_TRY(std::vector<CellPoint> points, problems_[level_].measure(std::move(starts), nullptr, {}));
  const auto nearest = std::min_element(points.begin(), points.end(),
                                        [](const CellPoint& a, const CellPoint& b) { return a.cost < b.cost; });
  found_ = nearest->state;  // its colours were solved
  GaussNewtonOptions options;
  options.eager = level_ == kExact;
  descent_.emplace(problems_[level_], std::move(*nearest), focus_, options);
  enter(Phase::kDescend);
  return {};
}

Result<void> LiveSolve::Impl::descend() {
  LUM_TRY(const bool more, descent_->iterate());
  found_ = descent_->point().state;
  if (!more || descent_->iterations() >= kDescentIterations) {
    descent_.reset();
    enter(level_ == kFollow ? Phase::kBegin : Phase::kSearch);
    level_ = kExact;
  }
  return {};
}

/// The descent is at its end: a whole solve from what is shown, then one from where the lights began, because a hand's
/// way leads into minima of its own.
Result<void> LiveSolve::Impl::search() {
  if (!session_) {
    if (found_) {
      LUM_TRY([[maybe_unused]] const bool nearer, show());
    }
    const ParamState& start = searches_++ == 0 ? best_ : first_;
    if (same_values(best_, first_)) searches_ = kSearches;  // the second search would be the first again
    LUM_TRY(session_, SolveSession::create(*renderer_, start, target_, options_, edges_));
    handed_ = std::numeric_limits<double>::infinity();
    return {};
  }
  LUM_TRY(const bool more, session_->step());
  if (const double epsilon = session_->report().epsilon; epsilon < std::min(report_.epsilon, handed_)) {
    handed_ = epsilon;
    found_ = session_->best();
    compared_ = true;
  }
  if (more) return {};
  if (searches_ >= kSearches || session_->report().termination != Termination::kConverged) {
    enter(Phase::kDone);
    report_.termination = session_->report().termination;
  } else {
    session_.reset();
  }
  return {};
}

Result<bool> LiveSolve::Impl::show() {
  if (problems_.empty()) found_.reset();  // nothing counts any more
  if (!found_) return false;
  ParamState state = std::move(*found_);
  found_.reset();
  if (!compared_) {
    const CellProblem& exact = problems_[kExact];
    LUM_TRY(std::vector<CellPoint> points, exact.measure({best_, state}, nullptr, {}));
    // Measuring solves the colours: of the lights shown that is a find of its own.
    CellPoint& nearer = points[1].cost < points[0].cost ? points[1] : points[0];
    state = nearer.state;
    const double cost = nearer.cost;
    points[0].state = best_;
    if (cost >= kGain * cell_cost(exact.level().cells, exact.picture(points[0]), exact.norm())) return false;
  }
  compared_ = false;
  LUM_TRY(Image picture, renderer_->render(state, {.moving = moving_}));
  ++report_.pictures;
  Image seen = compared(picture);
  RowErrors errors;
  compare(picture, seen, errors, everywhere());
  const double penalty = penalty_of(state, renderer_->frame());
  if (!(errors.error() + penalty < report_.epsilon)) return false;
  best_ = std::move(state);
  picture_ = std::make_shared<const Image>(std::move(picture));
  seen_picture_ = std::move(seen);
  errors_ = std::move(errors);
  tell(errors_.error(), penalty);
  return true;
}

LiveSolve::LiveSolve(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LiveSolve::LiveSolve(LiveSolve&&) noexcept = default;
LiveSolve& LiveSolve::operator=(LiveSolve&&) noexcept = default;
LiveSolve::~LiveSolve() = default;

Result<LiveSolve> LiveSolve::create(Renderer& renderer, ParamState start, const Target& target,
                                    const SolveOptions& options, Known known) {
  keep_constraints(start.rig);
  LUM_TRY_VOID(check_free(start, renderer.frame()));
  auto impl = std::make_unique<Impl>(renderer, std::move(start), target, options, std::move(known.edges));
  LUM_TRY_VOID(impl->begin(std::move(known.picture)));
  return LiveSolve(std::move(impl));
}

Result<void> LiveSolve::retarget(const Target& target, const PixelBox& changed) {
  return impl_->retarget(target, changed);
}
void LiveSolve::offer(ParamState start) {
  impl_->offer(std::move(start));
}
Result<bool> LiveSolve::step() {
  return impl_->step();
}

Result<bool> LiveSolve::run_for(std::chrono::milliseconds slice, Hand hand) {
  const Clock::time_point end = Clock::now() + slice;
  do {
    if (hand == Hand::kMoves && !report().following) return !report().settled;
    LUM_TRY(const bool more, step());
    if (!more) return false;
  } while (Clock::now() < end);
  return true;
}

Result<bool> LiveSolve::show() {
  return impl_->show();
}
const ParamState& LiveSolve::best() const {
  return impl_->best();
}
const Image& LiveSolve::picture() const {
  return *impl_->picture();
}
std::shared_ptr<const Image> LiveSolve::shared_picture() const {
  return impl_->picture();
}
const LiveReport& LiveSolve::report() const {
  return impl_->report();
}

}  // namespace luminist
