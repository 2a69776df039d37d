#include "studio/live_painting.h"

#include <utility>

#include "render/metric.h"
#include "solve/objective.h"
#include "solve/start_light.h"

namespace luminist {
namespace {

using Clock = std::chrono::steady_clock;

/// Seconds since a moment, which becomes now.
double lap(Clock::time_point& since) {
  const Clock::time_point now = Clock::now();
  return std::chrono::duration<double>(now - std::exchange(since, now)).count();
}

}  // namespace

LivePainting::LivePainting(const Stage& stage, Canvas canvas, ParamState start, std::vector<std::string> new_lights,
                           const Options& options)
    : stage_(&stage),
      canvas_(std::move(canvas)),
      start_(std::move(start)),
      new_lights_(std::move(new_lights)),
      options_(options) {}

void LivePainting::go_on_from(ParamState lights, std::vector<std::string> new_lights) {
  new_lights_ = std::move(new_lights);
  if (solve_) solve_->offer(lights);
  start_ = std::move(lights);
}

Result<void> LivePainting::get_ready() {
  return retarget(PixelBox{});
}

void LivePainting::set_importance(float nu, float delta) {
  canvas_.set_importance(nu, delta);
}

Result<LiveEvent> LivePainting::bucket(const Stroke& stroke, const std::string& folder) {
  const auto since = Clock::now();
  return follow(canvas_.apply(stroke, folder), Hand::kMoves, since);
}
Result<LiveEvent> LivePainting::begin(const Stroke& stroke, const std::string& folder) {
  const auto since = Clock::now();
  return follow(canvas_.begin_stroke(stroke, folder), Hand::kMoves, since);
}
Result<LiveEvent> LivePainting::extend(std::span<const StrokePoint> points) {
  const auto since = Clock::now();
  return follow(canvas_.extend_stroke(points), Hand::kMoves, since);
}
Result<LiveEvent> LivePainting::rest() {
  return follow(PixelBox{}, Hand::kRests, Clock::now());
}

/// Another place and size for new lights, now that more is painted: the nearer start wins.
Result<void> LivePainting::end() {
  LUM_TRY_VOID(canvas_.end_stroke());
  if (!solve_ || new_lights_.empty()) return {};
  if (auto lights = lights_from_paint()) solve_->offer(std::move(*lights));
  return {};
}

Result<LiveEvent> LivePainting::follow(Result<PixelBox> painted, Hand hand, Clock::time_point since) {
  if (!painted) return std::move(painted).error();
  LiveEvent event;
  event.painted = *painted;
  event.paint = lap(since);
  const bool began = solve_.has_value();
  const std::shared_ptr<const Image> shown = began ? solve_->shared_picture() : nullptr;
  LUM_TRY_VOID(retarget(*painted));
  event.retarget = lap(since);
  event.error_before = began ? solve_->report().error() : error_of(canvas_.target().before);
  event.error = event.error_before;
  if (!solve_) return event;
  since = Clock::now();
  LUM_TRY(event.more, solve_->run_for(options_.slice, hand));
  event.solve = lap(since);
  LUM_TRY_VOID(solve_->show());
  event.changed = solve_->shared_picture() != shown;  // a step may show something, too
  event.picture = lap(since);
  event.error = solve_->report().error();
  return event;
}

SolveReport LivePainting::report() const {
  const LiveReport& live = solve_->report();
  SolveReport report;
  report.solver = "live";
  report.termination = live.settled ? live.termination : Termination::kStopped;
  report.evals = live.pictures;
  report.epsilon = live.epsilon;
  report.penalty = live.penalty;
  return report;
}

SolveReport LivePainting::report_from(double error, const ParamState& lights) const {
  SolveReport report = this->report();
  report.penalty_start = penalty_of(lights, stage_->frame);
  report.epsilon_start = error + report.penalty_start;
  return report;
}

double LivePainting::error_of(const Image& picture) const {
  return picture_error(picture, canvas_.target(), stage_->style.metric);
}

Result<void> LivePainting::retarget(const PixelBox& box) {
  if (solve_) return solve_->retarget(canvas_.target(), box);
  ParamState start = start_;
  if (!new_lights_.empty()) {
    auto lights = lights_from_paint();
    if (!lights) return {};  // the paint has not said yet
    start = std::move(*lights);
  }
  LUM_TRY(solve_, LiveSolve::create(*stage_->renderer, std::move(start), canvas_.target(), options_.solve,
                                    {.picture = {}, .edges = stage_->edges}));
  return {};
}

Result<ParamState> LivePainting::lights_from_paint() const {
  ParamState lights = start_;
  LUM_TRY_VOID(place_lights(new_lights_, stage_->renderer->surface(), canvas_.target(), stage_->frame, lights.rig));
  return lights;
}

}  // namespace luminist
