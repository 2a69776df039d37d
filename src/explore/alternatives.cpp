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

constexpr int kSearchCells = 256;
constexpr int kTriesEach = 8;
constexpr double kPromising = 6.0;  // times the limit: worth freeing what was held

struct Solution {
  Outcome outcome;
  std::vector<LightLook> look;
};

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
std::vector<Alternative> most_different(const std::vector<Solution>& all, const AlternativesOptions& options) {
  std::vector<double> nearest(all.size(), std::numeric_limits<double>::infinity());
  std::vector<Alternative> list;
  std::size_t next = 0;
  while (true) {
    list.push_back({all[next].outcome.state, all[next].outcome.report, list.empty() ? 0.0 : nearest[next]});
    if (static_cast<int>(list.size()) >= options.count) return list;
    for (std::size_t i = 0; i < all.size(); ++i) {
      nearest[i] = std::min(nearest[i], look_distance(all[next].look, all[i].look));
    }
    next = static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
    if (!(nearest[next] > 0.0 && nearest[next] >= options.distinct)) return list;
  }
}

/// Where the picture counts.
Vec3 focus_of(const SampleCells& cells, const SceneFrame& frame) {
  Vec3 sum(0.0F);
  double weights = 0.0;
  for (std::size_t c = 0; c < cells.position.size(); ++c) {
    sum += static_cast<float>(cells.weight[c]) * cells.position[c];
    weights += cells.weight[c];
  }
  return weights > 0.0 ? sum / static_cast<float>(weights) : frame.center;
}

}  // namespace

Result<Alternatives> find_alternatives(Renderer& renderer, const ParamState& start, const Target& target,
                                       const AlternativesOptions& options, const ExploreWatch& watch) {
  const int tries = options.tries > 0 ? options.tries : kTriesEach * (options.count - 1);
  const double black = black_error(target);
  WatchedSolves solves(renderer, target, watch, 1 + 2 * tries);
  LUM_TRY(Outcome first, solves.run(start, {.seed = options.seed}, "the painting"));
  const SampleCells cells = CellSampler(renderer.surface(), target, solves.edges()).cut(kSearchCells, 1, options.seed);
  const Vec3 focus = focus_of(cells, renderer.frame());
  OtherStarts starts(first.state, cells, renderer.frame(), focus, options.seed);
  double best = first.report.epsilon;
  Alternatives result;
  std::vector<Solution> all;
  all.push_back({std::move(first), {}});
  for (; result.tried < tries && !solves.stopped(); ++result.tried) {
    const std::string doing = fmt::format("other lights {} of {}", result.tried + 1, tries);
    LUM_TRY(Outcome outcome, solve_elsewhere(solves, starts.next(), limit_of(best, black, options),
                                             options.seed + static_cast<std::uint64_t>(result.tried) + 1, doing));
    best = std::min(best, outcome.report.epsilon);
    all.push_back({std::move(outcome), {}});
  }
  result.limit = limit_of(best, black, options);
  result.stopped = solves.stopped();
  const auto epsilon = [](const Solution& solution) { return solution.outcome.report.epsilon; };
  std::erase_if(all, [&](const Solution& solution) { return epsilon(solution) > result.limit; });
  std::stable_sort(all.begin(), all.end(),
                   [&](const Solution& a, const Solution& b) { return epsilon(a) < epsilon(b); });
  result.good = static_cast<int>(all.size());
  LightEye eye(renderer, focus);
  for (Solution& solution : all) {
    LUM_TRY(solution.look, eye.look(solution.outcome.state));
  }
  result.list = most_different(all, options);
  return result;
}

}  // namespace luminist
