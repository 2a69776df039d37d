#pragma once
// tests/bench/method.h -- the solvers that are compared, behind one call.
#include <span>
#include <string>
#include <vector>

#include "bench/bench_run.h"
#include "render/renderer.h"

namespace luminist {

enum class Method {
  kFast,
  kSimplex,          ///< the paper's: restarts until it is halted
  kNloptNelderMead,  ///< NLopt's, as an independent baseline
  kNloptBobyqa,
};

/// "fast", "simplex", "nlopt_nelder_mead", "nlopt_bobyqa": by the enumerators' values.
std::span<const std::string> method_words();
const std::string& to_word(Method method);

/// A goal where a light is looked for that was moved away: of the start's epsilon; the paper's.
inline constexpr double kReached = 0.05;

struct BenchTask {
  ParamState start;  ///< what is unlocked may turn
  Target target;
  double goal = 0.0;   ///< an epsilon, penalty included
  bool stated = true;  ///< the method knows the goal and ends there; else it ends by its own rule
};

struct MethodCaps {
  int max_evals = 5000;            ///< full pictures compared; of the methods that compare nothing else
  double max_equivalents = 200.0;  ///< of the fast solver

  /// "5000 evals": of one method.
  [[nodiscard]] std::string text(Method method) const;
};

/// Solves a task from its start. Baselines compare whole pictures; the fast solver's renderer keeps what the lights add
/// that do not move. The account is the renderer's own: everything between the call and the return counts,
/// over the work of one full picture of the starting rig. key and evaluation_seconds are left to the caller. best gets
/// the state that was found. errors the renderer's, the session's.
Result<BenchRun> run_method(Renderer& renderer, const BenchTask& task, Method method, const MethodCaps& caps,
                            std::uint64_t seed, ParamState* best = nullptr);

/// Wall time of comparing one full picture in which every free degree of freedom has moved a little: the median of
/// three. errors the renderer's.
Result<double> time_evaluation(Renderer& renderer, const BenchTask& task);

/// Lights with something to turn, and how many degrees of freedom.
int free_lights(const ParamState& state);
int free_dofs(const ParamState& state, const SceneFrame& frame);
/// Their paths, in UnitMap order.
std::vector<std::string> free_names(const ParamState& state, const SceneFrame& frame);

}  // namespace luminist
