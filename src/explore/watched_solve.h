#pragma once
// explore/watched_solve.h -- many solves as one piece of work: how far it is, and whether to go on.
#include <functional>
#include <memory>
#include <string>

#include "solve/sample_cells.h"
#include "solve/solve_session.h"

namespace luminist {

struct ExploreProgress {
  int done = 0;          ///< solves that have ended
  int planned = 0;       ///< at most
  std::string doing;     ///< "without fill", "other lights 3"
  double epsilon = 0.0;  ///< best so far of the solve under way, without penalty
};

/// Asked about every 50 ms; false: stop, what was found so far is kept. May be empty: never stop.
using ExploreWatch = std::function<bool(const ExploreProgress&)>;

/// What one solve came to.
struct Outcome {
  ParamState state;
  SolveReport report;
};

/// Runs solves for one target. The renderer, target and watch must outlive it. thread: the renderer's.
class WatchedSolves {
 public:
  WatchedSolves(Renderer& renderer, const Target& target, const ExploreWatch& watch, int planned);

  /// The best that a solve found, also if it was stopped on the way. errors those of SolveSession.
  Result<Outcome> run(ParamState start, const SolveOptions& options, const std::string& doing);
  [[nodiscard]] bool stopped() const { return stopped_; }
  /// Of the renderer's surface, looked for once.
  [[nodiscard]] const std::shared_ptr<const EdgeMask>& edges() const { return edges_; }

 private:
  Renderer* renderer_;
  const Target* target_;
  const ExploreWatch* watch_;
  std::shared_ptr<const EdgeMask> edges_;
  ExploreProgress progress_;
  bool stopped_ = false;
};

}  // namespace luminist
