#include "bench/latency.h"

#include <array>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <thread>

#include <nlohmann/json.hpp>

#include "studio/live_replay.h"
#include "studio/studio_thread.h"

namespace luminist {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kEventsPerSecond = 60.0;
constexpr double kHandSpeed = 1.0;  // picture heights a second
constexpr std::chrono::seconds kPatience{120};

double since(Clock::time_point moment) {
  return std::chrono::duration<double>(Clock::now() - moment).count();
}

/// Snapshots as they come, each with the moment when it was seen.
class Watcher {
 public:
  void wake() {
    {
      const std::lock_guard lock(mutex_);
      changed_ = true;
    }
    wake_.notify_one();
  }
  /// Until it holds of the latest snapshot. errors kLimit.
  Result<void> wait(const StudioThread& studio, const std::function<bool(const StudioSnapshot&)>& holds) {
    const auto end = Clock::now() + kPatience;
    while (!holds(*studio.latest())) {
      std::unique_lock lock(mutex_);
      if (!wake_.wait_until(lock, end, [this] { return changed_; })) {
        return Error{ErrorKind::kLimit, "the studio does not answer", "", "", ""};
      }
      changed_ = false;
    }
    return {};
  }
  /// For so long, or until something changes.
  void pause(double seconds) {
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return changed_; });
    changed_ = false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool changed_ = false;
};

/// The points of an event, and when it was sent.
struct Sent {
  std::size_t points = 0;  ///< of the stroke, with this event's
  Clock::time_point moment;
};

class DrawingHand {
 public:
  DrawingHand(StudioThread& studio, Watcher& watcher) : studio_(&studio), watcher_(&watcher) {}

  Result<void> draw(const Stroke& stroke) {
    const std::uint64_t taken = studio_->latest()->strokes_taken;
    sent_.clear();
    studio_->begin_stroke({stroke.brush, {stroke.points.front()}}, ".");
    if (!stroke.brush.bucket) {
      sent_.push_back({1, Clock::now()});
      move(stroke.points);
      studio_->end_stroke();
    }
    const auto lifted = Clock::now();
    LUM_TRY_VOID(watcher_->wait(*studio_, [&](const StudioSnapshot& now) {
      look(now, taken);
      return now.strokes_taken > taken && now.unanswered == 0 && now.picture->same_size(now.painted->color);
    }));
    to_full.push_back(since(lifted));
    return {};
  }

  std::vector<double> to_picture;
  std::vector<double> to_full;
  std::vector<EventCost> costs;  ///< of the rounds that answered
  int width = 0;                 ///< of the picture that answered last

 private:
  void move(const std::vector<StrokePoint>& points) {
    const std::uint64_t taken = studio_->latest()->strokes_taken;
    auto next = Clock::now();
    std::size_t sent = 1;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const StrokePoint& a = points[i - 1];
      const StrokePoint& b = points[i];
      const int steps = std::max(1, static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) * kEventsPerSecond / kHandSpeed));
      for (int s = 1; s <= steps; ++s) {
        const float t = static_cast<float>(s) / static_cast<float>(steps);
        next += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / kEventsPerSecond));
        while (Clock::now() < next) {
          watcher_->pause(std::chrono::duration<double>(next - Clock::now()).count());
          look(*studio_->latest(), taken);
        }
        studio_->extend_stroke({{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 1.0F}});
        sent_.push_back({++sent, Clock::now()});
      }
    }
  }

  /// Events that a snapshot holds have been answered.
  void look(const StudioSnapshot& now, std::uint64_t taken) {
    const bool whole = now.strokes_taken > taken;
    if (!whole && now.version != seen_ && now.points_taken > 1) {
      costs.push_back(now.cost);
      width = now.picture->width;
    }
    seen_ = now.version;
    while (!sent_.empty() && (whole || sent_.front().points <= now.points_taken)) {
      to_picture.push_back(since(sent_.front().moment));
      sent_.erase(sent_.begin());
    }
  }

  StudioThread* studio_;
  Watcher* watcher_;
  std::vector<Sent> sent_;
  std::uint64_t seen_ = 0;
};

/// The middle of one part of all rounds, in seconds.
double middle(const std::vector<EventCost>& costs, double EventCost::*part) {
  std::vector<double> seconds;
  for (const EventCost& cost : costs) seconds.push_back(cost.*part);
  return latency_of(std::move(seconds)).median;
}

struct Part {
  const char* name;
  double EventCost::*seconds;
};
constexpr std::array<Part, 6> kParts = {{{"paint", &EventCost::paint},
                                         {"preview paint", &EventCost::preview},
                                         {"new target", &EventCost::retarget},
                                         {"solve", &EventCost::solve},
                                         {"picture", &EventCost::picture},
                                         {"snapshot", &EventCost::snapshot}}};

nlohmann::json to_json(const Latency& latency) {
  return {{"median", latency.median}, {"p95", latency.p95}, {"max", latency.most}};
}

void print(const char* what, const Latency& latency) {
  std::printf("%-18s median %5.0f ms   95 %% %5.0f ms   most %5.0f ms\n", what, 1e3 * latency.median, 1e3 * latency.p95,
              1e3 * latency.most);
}

/// Strokes for a picture of 4:3 meet the same objects in a wider one, which shows more at both sides.
void keep_about_the_middle(StrokeFile& strokes, const LatencyOptions& options) {
  const float shift = 0.5F * (static_cast<float>(options.width) / static_cast<float>(options.height) - 4.0F / 3.0F);
  for (Stroke& stroke : strokes.strokes) {
    for (StrokePoint& point : stroke.points) point.x += shift;
  }
}

}  // namespace

Result<void> run_latency(const LatencyOptions& options) {
  const AssetRoots roots = AssetRoots::standard();
  LUM_TRY(const std::string path, find_input(options.strokes, ".", roots));
  LUM_TRY(StrokeFile strokes, load_strokes(path));
  keep_about_the_middle(strokes, options);
  Watcher watcher;
  StudioThread studio({roots, {}, [&] { watcher.wake(); }});
  Shot shot;
  shot.scene = options.scene;
  shot.width = options.width;
  shot.height = options.height;
  studio.post("open", [shot](Workbench& bench) -> Result<void> {
    LUM_TRY_VOID(bench.open(shot, "."));
    for (std::size_t i = 0; i < QuickStage::kSizes.size(); ++i) LUM_TRY_VOID(bench.prepare());
    auto added = bench.act([](Session& session) -> Result<void> {
      LUM_TRY_VOID(session.add_light({.dark = true}));
      return {};
    });
    if (!added) return added;
    return bench.prepare();  // as while the hand goes from the button to the picture
  });
  LUM_TRY_VOID(watcher.wait(studio, [](const StudioSnapshot& now) { return now.picture != nullptr; }));
  DrawingHand hand(studio, watcher);
  // The first stroke compiles what shaders there are; it is painted twice and counted once.
  for (int round = 0; round < 2; ++round) {
    LUM_TRY_VOID(hand.draw(strokes.strokes.size() > 1 ? strokes.strokes[1] : strokes.strokes.front()));
    if (round == 0) hand.to_picture.clear(), hand.to_full.clear(), hand.costs.clear();
  }
  for (std::size_t i = 2; i < strokes.strokes.size(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    LUM_TRY_VOID(hand.draw(strokes.strokes[i]));
  }
  const std::size_t events = hand.to_picture.size();
  const Latency to_picture = latency_of(std::move(hand.to_picture));
  const Latency to_full = latency_of(std::move(hand.to_full));
  if (options.json) {
    nlohmann::json parts;
    for (const Part& part : kParts) parts[part.name] = middle(hand.costs, part.seconds);
    const nlohmann::json line = {{"width", options.width},
                                 {"height", options.height},
                                 {"preview_width", hand.width},
                                 {"events", events},
                                 {"parts", parts},
                                 {"event_to_picture", to_json(to_picture)},
                                 {"stroke_to_full", to_json(to_full)}};
    std::printf("%s\n", line.dump().c_str());
  } else {
    std::printf("%d x %d, %zu events, the preview %d wide\n", options.width, options.height, events, hand.width);
    print("event to picture", to_picture);
    print("stroke to full", to_full);
    std::printf("a round, medians:");
    for (const Part& part : kParts) std::printf("  %s %.1f", part.name, 1e3 * middle(hand.costs, part.seconds));
    std::printf(" ms\n");
  }
  return {};
}

}  // namespace luminist
