#pragma once
// studio/live_replay.h -- recorded strokes painted again as a hand would, and how long each picture took.
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "studio/live_painting.h"

namespace luminist {

struct LiveReplayOptions {
  std::chrono::milliseconds slice{12};
  double scale = 1.0;  ///< share of the shot's size that everything is done at
};

/// Of many times, in seconds.
struct Latency {
  double median = 0.0;
  double p95 = 0.0;
  double most = 0.0;
};
/// [0] of no times is all zero.
Latency latency_of(std::vector<double> seconds);

/// What one painting took.
struct LiveMeasure {
  std::string name;  ///< of the stroke file
  int strokes = 0;
  int events = 0;            ///< of the hand
  int frames = 0;            ///< rounds of the loop: events that came meanwhile are taken together
  Latency event_to_picture;  ///< from the arrival of an event's last point until a picture that knows of it
  Latency paint, retarget, solve, picture;  ///< parts of a frame
  int improved = 0;               ///< strokes after which a picture came, before the next stroke, that was nearer...
  Latency stroke_to_improvement;  ///< ...by 1 % than the one shown when they began; from the end of the stroke
  double settled_95 = 0.0;        ///< from the last event until 95 % of what was still to be gained was gained
  double settled = 0.0;           ///< until nothing more was found
  double error_before = 0.0;      ///< of the picture shown when the last event came, against the final target
  double error_event = 0.0;       ///< of the picture that answered the last event
  double error = 0.0;             ///< at the end
  SolveReport report;             ///< from the picture before the first event, against the final target
};

/// Paints strokes as a hand does: 60 events a second, each with the points of a tablet of 120 Hz, at one picture height
/// a second along the recorded polylines and a quarter of a second between strokes. The loop is as a window's: an
/// event waits until the frame before is done, those that wait are taken together. The clock of the hand is reckoned
/// from the measured times, so nothing sleeps. After the last event slices go on until nothing more is found, for so
/// many seconds at most, or until watch says false.
/// errors LivePainting's; kNothingToDo if no stroke says where a new light begins.
Result<LiveMeasure> paint_live(LivePainting& painting, const StrokeFile& strokes, const std::string& path,
                               std::optional<double> seconds, const std::function<bool()>& watch);

/// {"strokes", "events", "frames", "event_to_picture": {"median", "p95", "max"}, "paint": ..., ...} in seconds.
nlohmann::json live_to_json(const LiveMeasure& measure);

}  // namespace luminist
