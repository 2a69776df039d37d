#include "explore/light_diet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "explore/locks.h"

namespace luminist {
namespace {

constexpr double kUnseen = 1e-3;  // of a black picture's error: a light that did less is just removed

/// A light that may go next.
struct Removed {
  std::size_t light = 0;
  double epsilon_removed = 0.0;
  Outcome outcome;
  bool shows = true;  ///< there is something to make up for
};

/// Epsilons that differ by less than what shows are alike: then the light goes that did less.
struct Better {
  double unseen = 0.0;

  bool operator()(const Removed& a, const Removed& b) const { return rank(a) < rank(b); }
  [[nodiscard]] std::pair<double, double> rank(const Removed& removed) const {
    const double epsilon = removed.outcome.report.epsilon;
    return {unseen > 0.0 ? std::round(epsilon / unseen) : epsilon, removed.epsilon_removed};
  }
};

class Elimination {
 public:
  Elimination(Renderer& renderer, const Target& target, double black, const DietOptions& options,
              const ExploreWatch& watch, int lights)
      : renderer_(&renderer),
        target_(&target),
        options_(options),
        black_(black),
        solves_(renderer, target, watch, planned(lights, options)) {}

  /// The next step from the lights of `from`; nothing if it was stopped before one was found.
  Result<std::optional<DietStep>> next(const DietStep& from);
  [[nodiscard]] bool stopped() const { return solves_.stopped(); }

 private:
  static int planned(int lights, const DietOptions& options) {
    int solves = 0;
    for (int n = lights; n > std::max(1, options.fewest); --n) solves += n + std::min(options.breadth, n);
    return solves;
  }
  Result<std::vector<Removed>> by_colors(const DietStep& from);
  Result<void> by_all(const ParamState& from, Removed& removed);

  Renderer* renderer_;
  const Target* target_;
  DietOptions options_;
  double black_;
  WatchedSolves solves_;
};

/// Every light removed, the others' colours solved. A light whose loss does not show ends the search.
Result<std::vector<Removed>> Elimination::by_colors(const DietStep& from) {
  std::vector<Removed> all;
  const std::vector<Light>& lights = from.state.rig.lights;
  for (std::size_t i = 0; i < lights.size() && !solves_.stopped(); ++i) {
    const ParamState free = with_free_lights(without_light(from.state, i), options_.who);
    Removed removed{i, 0.0, {free, {}}};
    LUM_TRY(removed.epsilon_removed, renderer_->error(free, *target_));
    removed.outcome.report.epsilon = removed.epsilon_removed;
    if (removed.epsilon_removed <= from.epsilon + kUnseen * black_) {
      removed.shows = false;
      return std::vector<Removed>{std::move(removed)};
    }
    if (const auto colors = with_only_colors_free(free)) {
      const SolveOptions options{.seed = options_.seed, .restarts = 0};
      LUM_TRY(removed.outcome, solves_.run(*colors, options, "without " + lights[i].name));
      removed.outcome.state = with_locks_of(std::move(removed.outcome.state), free);
    }
    all.push_back(std::move(removed));
  }
  std::stable_sort(all.begin(), all.end(), Better{kUnseen * black_});
  return all;
}

Result<void> Elimination::by_all(const ParamState& from, Removed& removed) {
  const std::string& name = from.rig.lights[removed.light].name;
  if (!check_free(removed.outcome.state, renderer_->frame())) return {};  // a rig that is all locked only loses lights
  const SolveOptions options{.seed = options_.seed, .restarts = options_.restarts};
  LUM_TRY(removed.outcome, solves_.run(std::move(removed.outcome.state), options, "made up for " + name));
  return {};
}

Result<std::optional<DietStep>> Elimination::next(const DietStep& from) {
  LUM_TRY(std::vector<Removed> all, by_colors(from));
  if (all.empty()) return std::optional<DietStep>{};
  const auto tried = std::min(all.size(), static_cast<std::size_t>(std::max(1, options_.breadth)));
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(tried), all.end());
  for (Removed& removed : all) {
    if (removed.shows && !solves_.stopped()) LUM_TRY_VOID(by_all(from.state, removed));
  }
  Removed& best = *std::min_element(all.begin(), all.end(), Better{kUnseen * black_});
  return std::optional(DietStep{from.state.rig.lights[best.light].name, std::move(best.outcome.state),
                                best.outcome.report.epsilon, best.epsilon_removed, false});
}

/// Marks the front and finds the smallest rig within the budget; the first step is always both.
void judge(Diet& diet) {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = diet.steps.size(); i-- > 0;) {
    diet.steps[i].on_front = diet.steps[i].epsilon < lowest;
    lowest = std::min(lowest, diet.steps[i].epsilon);
  }
  for (std::size_t i = 0; i < diet.steps.size(); ++i) {
    if (diet.steps[i].epsilon <= diet.budget) diet.chosen = i;
  }
}

}  // namespace

Result<Diet> light_diet(Renderer& renderer, const ParamState& state, const DietOptions& options,
                        const ExploreWatch& watch) {
  const int lights = static_cast<int>(state.rig.lights.size());
  if (lights < 2) {
    return Error{
        ErrorKind::kNothingToDo,
        lights == 0 ? "there are no lights" : fmt::format("\"{}\" is the only light", state.rig.lights[0].name), "",
        "rig", "give a rig with several lights"};
  }
  Diet diet;
  LUM_TRY(const Image picture, renderer.render(state));
  diet.target = kept_picture(picture);
  diet.black = black_error(diet.target);
  diet.budget = options.budget.of_black ? options.budget.value * diet.black : options.budget.value;
  diet.steps.push_back({"", state, 0.0, 0.0, false});
  Elimination elimination(renderer, diet.target, diet.black, options, watch, lights);
  for (int n = lights; n > std::max(1, options.fewest) && !elimination.stopped(); --n) {
    LUM_TRY(std::optional<DietStep> step, elimination.next(diet.steps.back()));
    if (step) diet.steps.push_back(*std::move(step));
  }
  diet.stopped = elimination.stopped();
  judge(diet);
  return diet;
}

}  // namespace luminist
