#pragma once
// studio/live_painting.h -- painting while the lights follow: event by event from the hand to the picture.
#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "paint/canvas.h"
#include "solve/live_solve.h"
#include "studio/stage.h"

namespace luminist {

/// What became of one event, and what its parts took, in seconds.
struct LiveEvent {
  double paint = 0.0;         ///< strokes into target and importance
  double retarget = 0.0;      ///< the solver takes the new target; the first time it is made
  double solve = 0.0;         ///< the slice
  double picture = 0.0;       ///< drawn and compared, where something was found
  double error_before = 0.0;  ///< of the picture shown until now, against the target now
  double error = 0.0;         ///< of the picture shown then
  PixelBox painted;           ///< where the target may be another
  bool changed = false;       ///< another picture is shown
  bool more = false;          ///< there is more to gain
  [[nodiscard]] double total() const { return paint + retarget + solve + picture; }
};

/// One painting, beside a session and on copies of what it has: the session records strokes and lights when the hand
/// is done (Session::paint(), Session::propose()), so that the log holds gestures and not events.
///
/// thread: the device's. The stage must outlive it.
class LivePainting {
 public:
  struct Options {
    SolveOptions solve;  ///< when the hand rests
    std::chrono::milliseconds slice{12};
  };
  /// canvas: what is painted on. start: lights with their locks. new_lights: names of those that begin where the paint
  /// says; they stay dark until it says so.
  LivePainting(const Stage& stage, Canvas canvas, ParamState start, std::vector<std::string> new_lights,
               const Options& options);

  /// Other lights of the same rig to go on from, where they are nearer; between strokes.
  void go_on_from(ParamState lights, std::vector<std::string> new_lights);
  /// Gets the solver ready before there is a stroke, unless the paint has not said yet where lights begin.
  /// errors the renderer's. cost a picture and the samples.
  Result<void> get_ready();

  /// Before the first stroke of a shadow brush waits for it, as Canvas's.
  Result<void> ready_shadows(PaintTool tool) { return canvas_.ready_shadows(tool); }
  [[nodiscard]] bool has_shadows(PaintTool tool) const { return canvas_.has_shadows(tool); }
  /// Weights of what is not painted; no event. cost O(pixels).
  void set_importance(float nu, float delta);
  /// The events of a hand: paint, retarget, a slice, the picture. A bucket is an event of its own.
  /// folder: where copies are looked for. errors Canvas's, the renderer's.
  Result<LiveEvent> bucket(const Stroke& stroke, const std::string& folder);
  Result<LiveEvent> begin(const Stroke& stroke, const std::string& folder);
  Result<LiveEvent> extend(std::span<const StrokePoint> points);
  Result<void> end();
  /// The hand rests: a slice and the picture.
  Result<LiveEvent> rest();

  /// False until the paint has said where new lights begin.
  [[nodiscard]] bool has_lights() const { return solve_.has_value(); }
  [[nodiscard]] const ParamState& best() const { return solve_ ? solve_->best() : start_; }
  /// Until another is shown.
  [[nodiscard]] const Image& picture() const { return solve_ ? solve_->picture() : canvas_.target().before; }
  /// The same, for others to keep; a copy only while there are no lights.
  [[nodiscard]] std::shared_ptr<const Image> shared_picture() const {
    return solve_ ? solve_->shared_picture() : std::make_shared<const Image>(canvas_.target().before);
  }
  [[nodiscard]] const Target& target() const { return canvas_.target(); }
  /// Of a picture of the shot, against the target now. cost O(pixels)
  [[nodiscard]] double error_of(const Image& picture) const;
  /// As of a solve that was stopped while there is more to gain; what it began with is not told. There are lights.
  [[nodiscard]] SolveReport report() const;
  /// The same from the picture that is painted on: its error and its lights.
  [[nodiscard]] SolveReport report_from(double error, const ParamState& lights) const;

 private:
  Result<LiveEvent> follow(Result<PixelBox> painted, Hand hand, std::chrono::steady_clock::time_point since);
  Result<void> retarget(const PixelBox& box);
  [[nodiscard]] Result<ParamState> lights_from_paint() const;

  const Stage* stage_;
  Canvas canvas_;
  ParamState start_;
  std::vector<std::string> new_lights_;
  Options options_;
  std::optional<LiveSolve> solve_;
};

}  // namespace luminist
