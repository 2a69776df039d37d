#include "bench/bench_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include <fmt/format.h>

namespace luminist {
namespace {

template <class F>
double median(const std::vector<BenchRun>& runs, F&& value) {
  if (runs.empty()) return 0.0;
  std::vector<double> values;
  for (const BenchRun& run : runs) values.push_back(value(run.report));
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double equivalents(const SolveReport& report) {
  return report.render_equivalents;
}
double seconds(const SolveReport& report) {
  return report.seconds;
}
double ratio(const SolveReport& report) {
  return report.epsilon_start > 0.0 ? report.epsilon / report.epsilon_start : 0.0;
}

double success(const BenchReport& report) {
  const auto good = std::count_if(report.runs.begin(), report.runs.end(), [](const BenchRun& r) { return r.success; });
  return report.runs.empty() ? 0.0 : static_cast<double>(good) / static_cast<double>(report.runs.size());
}

int capped(const BenchReport& report) {
  return static_cast<int>(
      std::count_if(report.runs.begin(), report.runs.end(), [](const BenchRun& r) { return r.capped; }));
}

}  // namespace

std::string to_json_line(const BenchReport& report) {
  nlohmann::ordered_json line;
  line["bench"] = report.bench;
  line["scene"] = report.scene;
  line["size"] = fmt::format("{}x{}", report.width, report.height);
  line["method"] = report.method;
  line["lights"] = report.lights;
  line["dofs"] = report.dofs;
  line["seeds"] = report.runs.size();
  line["success"] = success(report);
  line["render_equivalents"] = median(report.runs, equivalents);
  line["seconds"] = median(report.runs, seconds);
  line["epsilon_ratio"] = median(report.runs, ratio);
  line["capped"] = capped(report);
  return line.dump();
}

std::string to_table_line(const BenchReport& report) {
  return fmt::format(
      "{:<10} {:<14} {:>9} {:<8} {} light(s) {:>3} DOFs  success {:>5.1f} % of {:>3}  RE {:>8.1f}  {:>7.3f} s  "
      "epsilon ratio {:.4f}  capped {}",
      report.bench, report.scene, fmt::format("{}x{}", report.width, report.height), report.method, report.lights,
      report.dofs, 100.0 * success(report), report.runs.size(), median(report.runs, equivalents),
      median(report.runs, seconds), median(report.runs, ratio), capped(report));
}

Result<SolveReport> run_to_end(SolveSession& session) {
  while (true) {
    LUM_TRY(const bool more, session.step());
    if (!more) return session.report();
  }
}

}  // namespace luminist
