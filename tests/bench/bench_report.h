#pragma once
// tests/bench/bench_report.h -- what the runs of one method on one task came to, as a line of JSON or of a table.
#include <functional>
#include <string>
#include <vector>

#include "bench/bench_run.h"
#include "bench/bench_statistics.h"

namespace luminist {

/// Runs that differ only in their seed.
struct BenchReport {
  std::vector<BenchRun> runs;  ///< at least one

  [[nodiscard]] const BenchKey& key() const { return runs.front().key; }
  [[nodiscard]] double success() const;  ///< share
  [[nodiscard]] int capped() const;
  /// Medians. A run that did not reach its goal gives a bound of what it would have taken.
  [[nodiscard]] Bounded equivalents() const;
  [[nodiscard]] Bounded evals() const;
  [[nodiscard]] Bounded seconds() const;
  [[nodiscard]] double total_equivalents() const;
  [[nodiscard]] double total_seconds() const;
  [[nodiscard]] double first_seconds() const;
  [[nodiscard]] double ratio() const;
  [[nodiscard]] double evaluation_seconds() const;
};

/// {bench, kind: "result", scene, task, size, method, caps, lights, dofs, seeds, success, render_equivalents, evals,
/// seconds, at_least, total_render_equivalents, total_seconds, first_seconds, epsilon_ratio, capped}: success is a
/// share, capped a count, the others medians; at_least says that the work and time are bounds.
std::string to_json_line(const BenchReport& report);
std::string to_table_line(const BenchReport& report);
/// The same for one run, as a person follows it.
std::string to_text(const BenchRun& run);

/// How much more work and time `slow` takes than `fast`, both medians until the goal: a bound if slow's are. Work is
/// compared by counts. Time: as measured where the sizes are equal, else slow's pictures at fast's seconds a picture.
struct SpeedUp {
  Bounded work;
  Bounded time;
  bool measured = false;  ///< the time is; else it follows by counts
};
SpeedUp speed_up(const BenchReport& slow, const BenchReport& fast);
std::string to_json_line(const BenchReport& slow, const BenchReport& fast, const SpeedUp& ratio);
std::string to_table_line(const BenchReport& slow, const BenchReport& fast, const SpeedUp& ratio);

}  // namespace luminist
