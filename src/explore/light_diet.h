#pragma once
// explore/light_diet.h -- the fewest lights that still make the picture (paper, section 6.1.1).
#include <cstdint>
#include <string>
#include <vector>

#include "explore/light_removal.h"
#include "explore/watched_solve.h"

namespace luminist {

/// How far the picture may go from what it was.
struct ErrorBudget {
  double value = 0.05;
  bool of_black = true;  ///< a share of black_error(); else an epsilon
};

struct DietOptions {
  ErrorBudget budget;
  std::uint64_t seed = 1;
  int breadth = 2;   ///< removals at each size that are tried with all that is free; all of them are with colours only
  int restarts = 0;  ///< of the solve that settles a size
  int fewest = 1;    ///< lights
  MakeUp who = MakeUp::kUnlockedOrByType;
};

/// One size of the rig.
struct DietStep {
  std::string removed;  ///< against the step before; "" for the rig as it was
  ParamState state;
  double epsilon = 0.0;
  double epsilon_removed = 0.0;  ///< before the others made up for it
  bool on_front = false;         ///< no step with as few lights has so low an epsilon (Pareto)
};

struct Diet {
  Target target;
  double black = 0.0;           ///< black_error() of the target
  double budget = 0.0;          ///< as an epsilon
  std::vector<DietStep> steps;  ///< from all lights to the fewest
  std::size_t chosen = 0;       ///< the smallest rig within the budget
  bool stopped = false;         ///< by the watch: steps end early
};

/// Greedy backward elimination: of the lights that are left the one goes whose loss the others make up for best, and
/// from what they then are it goes on. Each removal is tried with the others' colours, which are solved in closed form;
/// the `breadth` best are solved with everything that with_free_lights() frees. Where removals are alike, the light
/// goes that did less; what does not show goes first. The epsilon is always that of the full picture against the first
/// one. Deterministic by seed.
/// errors kNothingToDo with fewer than two lights; the renderer's.
/// cost about n^2 / 2 colour solves and breadth * n whole ones for n lights.
Result<Diet> light_diet(Renderer& renderer, const ParamState& state, const DietOptions& options,
                        const ExploreWatch& watch);

}  // namespace luminist
