#include "explore/watched_solve.h"

#include <utility>

namespace luminist {

WatchedSolves::WatchedSolves(Renderer& renderer, const Target& target, const ExploreWatch& watch, int planned)
    : renderer_(&renderer),
      target_(&target),
      watch_(&watch),
      edges_(std::make_shared<const EdgeMask>(edge_pixels(renderer.surface()))) {
  progress_.planned = planned;
}

Result<Outcome> WatchedSolves::run(ParamState start, const SolveOptions& options, const std::string& doing) {
  constexpr std::chrono::milliseconds kSlice(50);
  LUM_TRY(SolveSession solve, SolveSession::create(*renderer_, std::move(start), *target_, options, edges_));
  progress_.doing = doing;
  for (bool more = true; more;) {
    LUM_TRY(more, solve.run_for(kSlice));
    progress_.epsilon = solve.report().error();
    stopped_ = stopped_ || (*watch_ && !(*watch_)(progress_));
    if (!more || !stopped_) continue;
    solve.stop();
    more = false;
  }
  ++progress_.done;
  return Outcome{solve.best(), solve.report()};
}

}  // namespace luminist
