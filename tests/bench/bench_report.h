#pragma once
// tests/bench/bench_report.h -- what runs of one method came to, as a line of JSON or of a table.
#include <string>
#include <vector>

#include "solve/solve_session.h"

namespace luminist {

struct BenchRun {
  SolveReport report;
  bool success = false;
  bool capped = false;
};

struct BenchReport {
  std::string bench;
  std::string scene;
  int width = 0;
  int height = 0;
  std::string method;
  int lights = 1;
  int dofs = 0;
  std::vector<BenchRun> runs;
};

/// {bench, scene, size, method, lights, dofs, seeds, success, render_equivalents, seconds, epsilon_ratio, capped}:
/// success is a share, capped a count, the three numbers are medians.
std::string to_json_line(const BenchReport& report);
std::string to_table_line(const BenchReport& report);

/// Steps a session until it is done.
Result<SolveReport> run_to_end(SolveSession& session);

}  // namespace luminist
