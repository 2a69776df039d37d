#pragma once
// solve/live_solve.h -- a solve that follows the brush: the target changes while it runs.
#include <chrono>
#include <limits>
#include <memory>
#include <utility>

#include "paint/coverage.h"
#include "render/renderer.h"
#include "solve/solve_session.h"

namespace luminist {

/// Whether another target is about to come.
enum class Hand { kMoves, kRests };

struct LiveReport {
  double epsilon = std::numeric_limits<double>::infinity();  ///< of the picture shown, against the present target
  double penalty = 0.0;                                      ///< the part of it of parameters outside their ranges
  int pictures = 0;                                          ///< drawn, the start's too
  bool following = false;  ///< descending on samples; else the lights are searched for as in any solve
  bool settled = false;    ///< nothing more is found for the present target
  Termination termination = Termination::kRunning;  ///< of the search that settled it

  [[nodiscard]] double error() const { return epsilon - penalty; }
};

/// Keeps the best lights for a target that is still being painted, and the picture of them.
///
/// While the hand moves, a descent on some hundred samples follows, with wide shadows and edges until it comes to an
/// end, and from there with true ones until the samples are cut anew: each new target is started on from the lights
/// that are shown or, if that is nearer, from what was found since. Samples stay where they are until the paint has
/// moved a seventh of what the cells stand for; the surface's edges are looked for once. When the hand rests, a
/// SolveSession goes on from what is shown, with all that a solve can do, and then one from where the lights began.
///
/// What is found is drawn by show() and compared with the picture shown, both in full against the present target; the
/// nearer one stays. So the picture never gets worse while the paint stands still, at the cost of one picture for each
/// change and none for a comparison. Steps are deterministic; where they meet the events of a hand is not, so a live
/// solve proposes and a solve without a clock can be repeated.
///
/// thread: the renderer's. The renderer must outlive it.
class LiveSolve {
 public:
  /// What the caller may have already.
  struct Known {
    Image picture;                          ///< of the start
    std::shared_ptr<const EdgeMask> edges;  ///< edge_pixels() of the renderer's surface
  };
  /// Turns the unlocked degrees of freedom of start. options: those of the solve when the hand rests.
  /// errors kNothingToDo: everything locked; the renderer's. cost a picture.
  static Result<LiveSolve> create(Renderer& renderer, ParamState start, const Target& target,
                                  const SolveOptions& options, Known known);
  static Result<LiveSolve> create(Renderer& renderer, ParamState start, const Target& target,
                                  const SolveOptions& options) {
    return create(renderer, std::move(start), target, options, Known{});
  }
  LiveSolve(LiveSolve&&) noexcept;
  LiveSolve& operator=(LiveSolve&&) noexcept;
  ~LiveSolve();

  /// The target is another inside the box; of the same size. errors the renderer's. cost O(pixels of the rows from
  /// there on) and, where cells are cut anew or the style's metric blurs, of all pixels.
  Result<void> retarget(const Target& target, const PixelBox& changed);
  /// Other lights to start from (of the same rig, with the same locks), if they are nearer on the samples.
  void offer(ParamState start);

  /// One bounded piece of work. returns false when the present target has nothing more to gain. errors the renderer's.
  Result<bool> step();
  /// Steps until then or the slice is over (at least one step). While the hand moves it is also over when the descent
  /// is at its end: a search that the next event throws away would only keep that event waiting.
  Result<bool> run_for(std::chrono::milliseconds slice, Hand hand);
  /// Draws what was found since and shows it if it is nearer. returns whether the picture changed. errors the
  /// renderer's. cost a picture, or nothing if nothing was found.
  Result<bool> show();

  [[nodiscard]] const ParamState& best() const;                       ///< the lights of the picture shown
  [[nodiscard]] const Image& picture() const;                         ///< until another is shown
  [[nodiscard]] std::shared_ptr<const Image> shared_picture() const;  ///< the same, for others to keep
  [[nodiscard]] const LiveReport& report() const;

 private:
  class Impl;
  explicit LiveSolve(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace luminist
