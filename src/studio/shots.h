#pragma once
// studio/shots.h -- a session beyond its frame and its camera: keys anywhere in time, the paint of each vantage, one
// rig for several.
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "project/frame_paint.h"
#include "studio/session.h"

namespace luminist {

/// A frame, seen by a camera, that takes part in a solve of several, and how much its error counts among the others'.
struct FrameChoice {
  Vantage at;
  double weight = 1.0;  ///< > 0
};

/// "frame 12", or "side, frame 12" where there are several cameras.
std::string vantage_text(const Vantage& at, std::span<const std::string> cameras);

/// The calls of a session that look beyond its frame. Each is one gesture, as Session's are. Patterns are those of
/// params_matching(): lights, parameters, or numbers of them as "lights/key/position.x"; styles have no keys.
/// thread the device's.
class Shots {
 public:
  /// The session outlives it.
  explicit Shots(Session& session) : session_(&session) {}

  /// Keys at the session's frame, as Session::set_keys().
  Result<int> set_keys(const std::string& pattern, KeyInterpolation interpolation);
  /// Keys of another frame. They return how many there were. errors kUsage if the pattern has no key there, or the
  /// frame is not finite. What the session looks at goes where its keys say then.
  Result<int> remove_keys(const std::string& pattern, double frame);
  Result<int> move_keys(const std::string& pattern, double from, double to);
  Result<int> interpolate_keys(const std::string& pattern, double frame, KeyInterpolation interpolation);

  /// What is looked at.
  [[nodiscard]] Vantage present() const { return session_->vantage(); }
  /// By any camera of the scene.
  [[nodiscard]] std::vector<PaintedFrame> painted() const;
  /// errors kNothingToDo: nothing is painted there; kUsage for an unknown camera (nearest name).
  Result<void> clear_paint(Vantage at);

  /// One rig for the paint of several frames or cameras: the weighted mean of their errors. What it finds is the
  /// session's proposal, with what became of each frame in Solved::frames; accepting it answers the paint of all of
  /// them. The style and the locks are the session's. What has keys stays as they say, in each frame what it is there;
  /// the rest is what is found. judge: each frame's strokes, unless watch stopped the solve. look: told the lights
  /// found so far, as the session's frame has them, whenever they are better; it may render. errors kUsage: fewer than
  /// two, one twice, a weight that is not above zero, lights of the scene that move, an unknown camera; kNothingToDo:
  /// nothing painted in one of them, all that may change has keys; SharedSolve's, look's. cost a stage for each camera
  /// besides the session's own, and for each frame where something moves; the solve.
  using Look = std::function<Result<void>(const ParamState&)>;
  Result<void> solve(std::span<const FrameChoice> frames, const SolveOptions& options, bool judge,
                     const Session::SolveWatch& watch, const Look& look = {});

 private:
  /// "" is the scene's first camera. errors kUsage for an unknown one.
  Result<Vantage> known(Vantage at) const;
  /// Changes keys of what a pattern names, tells how many there were.
  template <class Edit>
  Result<int> edit_keys(const std::string& pattern, double frame, const std::string& label, const std::string& action,
                        const Edit& edit);
  Session* session_;
};

}  // namespace luminist
