#include "studio/live_replay.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <nlohmann/json.hpp>

#include "render/metric.h"

namespace luminist {
namespace {

constexpr double kEventsPerSecond = 60.0;
constexpr int kPointsPerEvent = 2;
constexpr double kHandSpeed = 1.0;  // picture heights a second
constexpr double kPause = 0.25;     // seconds between strokes
constexpr double kVisible = 0.01;   // of the error: an improvement

/// What the hand sends at once.
struct HandEvent {
  double arrival = 0.0;  ///< seconds since the hand began
  std::size_t stroke = 0;
  bool begins = false;
  std::vector<StrokePoint> points;
};

/// The polyline with points as close as a tablet reports them; recorded points stay.
std::vector<StrokePoint> tablet_points(const std::vector<StrokePoint>& points) {
  constexpr double kSpacing = kHandSpeed / (kEventsPerSecond * kPointsPerEvent);
  std::vector<StrokePoint> result(1, points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    const StrokePoint& a = points[i - 1];
    const StrokePoint& b = points[i];
    const int steps = std::max(1, static_cast<int>(std::ceil(std::hypot(b.x - a.x, b.y - a.y) / kSpacing)));
    for (int s = 1; s < steps; ++s) {
      const float t = static_cast<float>(s) / static_cast<float>(steps);
      result.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.pressure + t * (b.pressure - a.pressure)});
    }
    result.push_back(b);
  }
  return result;
}

std::vector<HandEvent> hand_events(const StrokeFile& file) {
  std::vector<HandEvent> events;
  double clock = 0.0;
  for (std::size_t s = 0; s < file.strokes.size(); ++s) {
    const Stroke& stroke = file.strokes[s];
    const std::vector<StrokePoint> points = stroke.brush.bucket ? stroke.points : tablet_points(stroke.points);
    const std::size_t step = stroke.brush.bucket ? points.size() + 1 : kPointsPerEvent;
    std::size_t next = 0;
    do {
      const std::size_t end = std::min(points.size(), next + step);
      HandEvent event{clock, s, next == 0, {}};
      event.points.assign(points.begin() + static_cast<std::ptrdiff_t>(next),
                          points.begin() + static_cast<std::ptrdiff_t>(end));
      events.push_back(std::move(event));
      next = end;
      clock += 1.0 / kEventsPerSecond;
    } while (next < points.size());
    clock += kPause;
  }
  return events;
}

/// A moment after the last event.
struct Moment {
  double seconds = 0.0;
  double error = 0.0;
};

/// Runs the events through the loop of a window.
class HandReplay {
 public:
  HandReplay(LivePainting& painting, const StrokeFile& file, const std::string& path)
      : painting_(&painting),
        file_(&file),
        folder_(std::filesystem::path(path).parent_path().string()),
        events_(hand_events(file)) {}

  Result<void> paint(const std::function<bool()>& watch) {
    while (next_ < events_.size() && watch()) {
      LUM_TRY_VOID(wait());
      LUM_TRY_VOID(frame());
    }
    return {};
  }

  /// After the last event, until nothing more is found.
  Result<void> settle(std::optional<double> seconds, const std::function<bool()>& watch) {
    moments_ = {{since_last(), frames_.back().error}};
    for (bool more = true; more && watch() && !(seconds && since_last() > *seconds);) {
      LUM_TRY(const LiveEvent rest, painting_->rest());
      clock_ += rest.total();
      look(rest.error);
      moments_.push_back({since_last(), rest.error});
      more = rest.more;
    }
    return {};
  }

  [[nodiscard]] int events() const { return static_cast<int>(events_.size()); }
  [[nodiscard]] int frames() const { return static_cast<int>(frames_.size()); }
  [[nodiscard]] const std::vector<Moment>& moments() const { return moments_; }
  [[nodiscard]] const std::vector<double>& improvements() const { return improvements_; }
  [[nodiscard]] const LiveEvent& last_frame() const { return frames_.back(); }
  [[nodiscard]] const std::vector<double>& latencies() const { return latencies_; }
  [[nodiscard]] Latency of(double LiveEvent::*part) const {
    std::vector<double> times;
    for (const LiveEvent& frame : frames_) times.push_back(frame.*part);
    return latency_of(std::move(times));
  }

 private:
  /// Until the next event the hand rests; a frame of rest that has begun is finished.
  Result<void> wait() {
    bool more = painting_->has_lights();
    const double arrival = events_[next_].arrival;
    if (!events_[next_].begins) more = false;  // inside a stroke the time between events is the window's
    while (more && clock_ < arrival) {
      LUM_TRY(const LiveEvent rest, painting_->rest());
      clock_ += rest.total();
      look(rest.error);
      more = rest.more;
    }
    clock_ = std::max(clock_, arrival);
    return {};
  }

  /// Takes the events of one stroke that have arrived.
  Result<void> frame() {
    const std::size_t first = next_;
    HandEvent together = events_[next_++];
    while (next_ < events_.size() && !events_[next_].begins && events_[next_].arrival <= clock_) {
      const std::vector<StrokePoint>& points = events_[next_++].points;
      together.points.insert(together.points.end(), points.begin(), points.end());
    }
    const Stroke& recorded = file_->strokes[together.stroke];
    if (together.begins) before_ = painting_->picture();
    LiveEvent event;
    if (recorded.brush.bucket) {
      LUM_TRY(event, painting_->bucket(recorded, folder_));
    } else if (together.begins) {
      LUM_TRY(event, painting_->begin({recorded.brush, together.points}, folder_));
    } else {
      LUM_TRY(event, painting_->extend(together.points));
    }
    clock_ += event.total();
    for (std::size_t i = first; i < next_; ++i) latencies_.push_back(clock_ - events_[i].arrival);
    frames_.push_back(event);
    const bool lifted = next_ == events_.size() || events_[next_].begins;
    if (!lifted) return {};
    lifted_ = events_[next_ - 1].arrival;
    wanted_ = (1.0 - kVisible) * painting_->error_of(before_);
    look(event.error);
    if (!recorded.brush.bucket) LUM_TRY_VOID(painting_->end());
    return {};
  }

  /// Whether the picture is nearer to the target, since the last stroke is whole, than that shown before the stroke.
  void look(double error) {
    if (error > wanted_) return;
    improvements_.push_back(clock_ - lifted_);
    wanted_ = -1.0;
  }

  [[nodiscard]] double since_last() const { return clock_ - events_.back().arrival; }

  LivePainting* painting_;
  const StrokeFile* file_;
  std::string folder_;
  std::vector<HandEvent> events_;
  std::size_t next_ = 0;
  double clock_ = 0.0;
  std::vector<LiveEvent> frames_;
  std::vector<double> latencies_;
  Image before_;          ///< shown when the last stroke began
  double lifted_ = 0.0;   ///< when the last stroke ended
  double wanted_ = -1.0;  ///< an error that is an improvement on before_; negative if there is nothing to wait for
  std::vector<double> improvements_;
  std::vector<Moment> moments_;
};

/// The first moment at most that far from the target; -1 if there is none.
double reached(const std::vector<Moment>& moments, double error) {
  for (const Moment& moment : moments) {
    if (moment.error <= error) return moment.seconds;
  }
  return -1.0;
}

nlohmann::json to_json(const Latency& latency) {
  return {{"median", latency.median}, {"p95", latency.p95}, {"max", latency.most}};
}

}  // namespace

Latency latency_of(std::vector<double> seconds) {
  if (seconds.empty()) return {};
  std::sort(seconds.begin(), seconds.end());
  const auto at = [&](double share) {
    return seconds[static_cast<std::size_t>(std::ceil(share * static_cast<double>(seconds.size()))) - 1];
  };
  return {at(0.5), at(0.95), seconds.back()};
}

Result<LiveMeasure> paint_live(LivePainting& painting, const StrokeFile& strokes, const std::string& path,
                               std::optional<double> seconds, const std::function<bool()>& watch) {
  const Image start = painting.picture();
  const ParamState lights = painting.best();
  painting.set_importance(strokes.nu, strokes.delta);
  HandReplay hand(painting, strokes, path);
  LUM_TRY_VOID(hand.paint(watch));
  if (!painting.has_lights()) {
    return Error{ErrorKind::kNothingToDo, "no stroke says where the new light begins", path, "strokes",
                 "paint light that is not there yet"};
  }
  LUM_TRY_VOID(hand.settle(seconds, watch));
  const std::vector<Moment>& moments = hand.moments();
  LiveMeasure measure;
  measure.name = std::filesystem::path(path).filename().string();
  measure.strokes = static_cast<int>(strokes.strokes.size());
  measure.events = hand.events();
  measure.frames = hand.frames();
  measure.event_to_picture = latency_of(hand.latencies());
  measure.paint = hand.of(&LiveEvent::paint);
  measure.retarget = hand.of(&LiveEvent::retarget);
  measure.solve = hand.of(&LiveEvent::solve);
  measure.picture = hand.of(&LiveEvent::picture);
  measure.error_before = hand.last_frame().error_before;
  measure.error_event = moments.front().error;
  measure.error = moments.back().error;
  measure.improved = static_cast<int>(hand.improvements().size());
  measure.stroke_to_improvement = latency_of(hand.improvements());
  measure.settled_95 = reached(moments, measure.error + 0.05 * (measure.error_before - measure.error));
  measure.settled = moments.back().seconds;
  measure.report = painting.report_from(painting.error_of(start), lights);
  measure.report.seconds = measure.settled;
  return measure;
}

nlohmann::json live_to_json(const LiveMeasure& measure) {
  return {{"strokes_of", measure.name},
          {"strokes", measure.strokes},
          {"events", measure.events},
          {"frames", measure.frames},
          {"event_to_picture", to_json(measure.event_to_picture)},
          {"paint", to_json(measure.paint)},
          {"retarget", to_json(measure.retarget)},
          {"solve", to_json(measure.solve)},
          {"picture", to_json(measure.picture)},
          {"improved", measure.improved},
          {"stroke_to_improvement", to_json(measure.stroke_to_improvement)},
          {"settled_95", measure.settled_95},
          {"settled", measure.settled},
          {"error_before", measure.error_before},
          {"error_event", measure.error_event},
          {"error", measure.error},
          {"pictures", measure.report.evals}};
}

}  // namespace luminist
