#include "explore/alternatives.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "explore/light_distance.h"
#include "explore/light_removal.h"
#include "explore/locks.h"
#include "explore/other_starts.h"

namespace luminist {
namespace {

constexpr int kTriesEach = 8;
constexpr double kPromising = 3.0;  // times the limit: worth freeing what was held

double limit_of(double best, double black, const AlternativesOptions& options) {
  return std::max(options.factor * best, best + options.allowance * black);
}

bool anything_unlocked(const ParamState& state) {
  for (const ParamBlock* block : state.blocks()) {
    for (int dof = 0; dof < block->schema().dofs(); ++dof) {
      if (!block->locked(dof)) return true;
    }
  }
  return false;
}

/// A solve with what was moved held there, so that it cannot all run back to one solution; freed if it must be.
Result<Outcome> solve_elsewhere(WatchedSolves& solves, const OtherStart& start, double limit, std::uint64_t seed,
                                const std::string& doing) {
  const SolveOptions options{.seed = seed, .until = limit, .restarts = 0};
  Outcome held{start.state, {}};
  if (anything_unlocked(start.held)) {
    LUM_TRY(held, solves.run(start.held, options, doing));
    held.state = with_locks_of(std::move(held.state), start.state);
    if (held.report.epsilon <= limit || held.report.epsilon > kPromising * limit || solves.stopped()) return held;
  }
  return solves.run(std::move(held.state), options, doing);
}

/// Greedily the farthest from those that were taken; the first of `all` is the best and always taken.
Result<std::vector<Alternative>> most_different(LightDistance& distance, std::vector<Outcome> all,
                                                const AlternativesOptions& options) {
  std::vector<double> nearest(all.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> taken(all.size(), false);
  std::vector<Alternative> list;
  std::size_t next = 0;
  while (true) {
    taken[next] = true;
    list.push_back({all[next].state, all[next].report, list.empty() ? 0.0 : nearest[next]});
    if (static_cast<int>(list.size()) >= options.count) return list;
    std::optional<std::size_t> farthest;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (taken[i]) continue;
      LUM_TRY(const double apart, distance.between(list.back().state, all[i].state));
      nearest[i] = std::min(nearest[i], apart);
      if (nearest[i] >= options.distinct && (!farthest || nearest[i] > nearest[*farthest])) farthest = i;
    }
    if (!farthest) return list;
    next = *farthest;
  }
}

}  // namespace

Result<Alternatives> find_alternatives(Renderer& renderer, const ParamState& start, const Target& target,
                                       const AlternativesOptions& options, const ExploreWatch& watch) {
  const int tries = options.tries > 0 ? options.tries : kTriesEach * (options.count - 1);
  const double black = black_error(target);
  WatchedSolves solves(renderer, target, watch, 1 + 2 * tries);
  LUM_TRY(Outcome first, solves.run(start, {.seed = options.seed}, "the painting"));
  LightDistance distance(renderer, target);
  OtherStarts starts(first.state, distance.cells(), renderer.frame(), distance.focus(), options.seed);
  double best = first.report.epsilon;
  Alternatives result;
  std::vector<Outcome> all;
  all.push_back(std::move(first));
  for (; result.tried < tries && !solves.stopped(); ++result.tried) {
    const std::string doing = fmt::format("other lights {} of {}", result.tried + 1, tries);
    LUM_TRY(Outcome outcome, solve_elsewhere(solves, starts.next(), limit_of(best, black, options),
                                             options.seed + static_cast<std::uint64_t>(result.tried) + 1, doing));
    best = std::min(best, outcome.report.epsilon);
    all.push_back(std::move(outcome));
  }
  result.limit = limit_of(best, black, options);
  result.stopped = solves.stopped();
  std::erase_if(all, [&](const Outcome& outcome) { return outcome.report.epsilon > result.limit; });
  std::stable_sort(all.begin(), all.end(),
                   [](const Outcome& a, const Outcome& b) { return a.report.epsilon < b.report.epsilon; });
  result.good = static_cast<int>(all.size());
  LUM_TRY(result.list, most_different(distance, std::move(all), options));
  return result;
}

}  // namespace luminist
