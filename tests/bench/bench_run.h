#pragma once
// tests/bench/bench_run.h -- one solve of a benchmark: what was asked and what came of it.
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "solve/solve_session.h"

namespace luminist {

/// What was run. Two runs of one key are the same run.
struct BenchKey {
  std::string bench;
  std::string scene;
  std::string task;    ///< what is solved: the row of a table, with everything that changes it
  std::string method;  ///< a method's word
  int width = 0;
  int height = 0;
  std::string caps;  ///< where the method had to end
  std::uint64_t seed = 1;

  /// All fields in one line.
  [[nodiscard]] std::string text() const;
};

struct BenchRun {
  BenchKey key;
  int lights = 0;  ///< with something to turn
  int dofs = 0;
  bool success = false;  ///< the goal was reached
  bool capped = false;   ///< ended by a cap, not by itself
  double epsilon_start = 0.0;
  double epsilon = 0.0;  ///< best on the full picture
  double goal = 0.0;
  int evals = 0;                   ///< full pictures compared, until the goal or the end
  double equivalents = 0.0;        ///< all work in full pictures of the starting rig, until the goal or the end
  double seconds = 0.0;            ///< wall time until the goal or the end, with what the method prepares
  double total_equivalents = 0.0;  ///< until the method ended, where it went on after the goal
  double total_seconds = 0.0;
  double first_seconds = 0.0;       ///< until the first picture that was better than the start; 0: there was none
  double evaluation_seconds = 0.0;  ///< one full picture compared, every free light moved
  std::vector<ConvergencePoint> convergence;

  [[nodiscard]] double ratio() const { return epsilon_start > 0.0 ? epsilon / epsilon_start : 0.0; }
};

/// One line without a line break, and back. errors kBadContent: no such object.
std::string to_json_line(const BenchRun& run);
Result<BenchRun> parse_run(const std::string& line);

}  // namespace luminist
