#include "bench/bench_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include <fmt/format.h>

namespace luminist {
namespace {

template <class F>
double median_of(const std::vector<BenchRun>& runs, F&& value) {
  std::vector<double> values;
  for (const BenchRun& run : runs) values.push_back(value(run));
  return median(std::move(values));
}

template <class F>
Bounded bounded_median_of(const std::vector<BenchRun>& runs, F&& value) {
  std::vector<Bounded> values;
  for (const BenchRun& run : runs) values.push_back({static_cast<double>(value(run)), !run.success});
  return median(std::move(values));
}

std::string size_of(const BenchKey& key) {
  return fmt::format("{}x{}", key.width, key.height);
}

/// "12.3", or ">= 12.3".
std::string text(const Bounded& number, int digits) {
  return fmt::format("{}{:.{}f}", number.at_least ? ">= " : "", number.value, digits);
}

Bounded quotient(const Bounded& slow, const Bounded& fast) {
  return {fast.value > 0.0 ? slow.value / fast.value : 0.0, slow.at_least};
}

}  // namespace

double BenchReport::success() const {
  const auto good = std::count_if(runs.begin(), runs.end(), [](const BenchRun& run) { return run.success; });
  return runs.empty() ? 0.0 : static_cast<double>(good) / static_cast<double>(runs.size());
}

int BenchReport::capped() const {
  return static_cast<int>(std::count_if(runs.begin(), runs.end(), [](const BenchRun& run) { return run.capped; }));
}

Bounded BenchReport::equivalents() const {
  return bounded_median_of(runs, [](const BenchRun& run) { return run.equivalents; });
}
Bounded BenchReport::evals() const {
  return bounded_median_of(runs, [](const BenchRun& run) { return run.evals; });
}
Bounded BenchReport::seconds() const {
  return bounded_median_of(runs, [](const BenchRun& run) { return run.seconds; });
}
double BenchReport::total_equivalents() const {
  return median_of(runs, [](const BenchRun& run) { return run.total_equivalents; });
}
double BenchReport::total_seconds() const {
  return median_of(runs, [](const BenchRun& run) { return run.total_seconds; });
}
double BenchReport::first_seconds() const {
  return median_of(runs, [](const BenchRun& run) { return run.first_seconds; });
}
double BenchReport::ratio() const {
  return median_of(runs, [](const BenchRun& run) { return run.ratio(); });
}
double BenchReport::evaluation_seconds() const {
  return median_of(runs, [](const BenchRun& run) { return run.evaluation_seconds; });
}

std::string to_json_line(const BenchReport& report) {
  const BenchKey& key = report.key();
  nlohmann::ordered_json line;
  line["bench"] = key.bench;
  line["kind"] = "result";
  line["scene"] = key.scene;
  line["task"] = key.task;
  line["size"] = size_of(key);
  line["method"] = key.method;
  line["caps"] = key.caps;
  line["lights"] = report.runs.front().lights;
  line["dofs"] = report.runs.front().dofs;
  line["seeds"] = report.runs.size();
  line["success"] = report.success();
  line["render_equivalents"] = report.equivalents().value;
  line["evals"] = report.evals().value;
  line["seconds"] = report.seconds().value;
  line["at_least"] = report.equivalents().at_least;
  line["total_render_equivalents"] = report.total_equivalents();
  line["total_seconds"] = report.total_seconds();
  line["first_seconds"] = report.first_seconds();
  line["epsilon_ratio"] = report.ratio();
  line["capped"] = report.capped();
  return line.dump();
}

std::string to_table_line(const BenchReport& report) {
  const BenchKey& key = report.key();
  std::string end;  // of methods that go on after the goal
  if (report.total_equivalents() > 1.001 * report.equivalents().value) {
    end = fmt::format("  to its end {:.1f} RE {:.3f} s", report.total_equivalents(), report.total_seconds());
  }
  return fmt::format(
      "{:<8} {:<11} {:<10} {:>9} {:<17} {:>3} DOFs  ok {:>5.1f} % of {:>2}  {:>10} RE  {:>10} s  error {:.4f} "
      "of start  capped {}{}",
      key.bench, key.scene, key.task, size_of(key), key.method, report.runs.front().dofs, 100.0 * report.success(),
      report.runs.size(), text(report.equivalents(), 1), text(report.seconds(), 3), report.ratio(), report.capped(),
      end);
}

std::string to_text(const BenchRun& run) {
  return fmt::format(
      "{:<11} {:<10} {:>9} {:<17} seed {:>2}: {:>3} DOFs  {:.5f} -> {:.5f} ({:.4f})  {:>8.2f} RE  {:>8.3f} s  "
      "{:>5} evals{}{}",
      run.key.scene, run.key.task, size_of(run.key), run.key.method, run.key.seed, run.dofs, run.epsilon_start,
      run.epsilon, run.ratio(), run.equivalents, run.seconds, run.evals, run.success ? "" : "  MISSED",
      run.capped ? "  capped" : "");
}

SpeedUp speed_up(const BenchReport& slow, const BenchReport& fast) {
  SpeedUp ratio;
  ratio.work = quotient(slow.equivalents(), fast.equivalents());
  ratio.measured = slow.key().width == fast.key().width && slow.key().height == fast.key().height;
  const Bounded pictures = slow.evals();
  const Bounded time =
      ratio.measured ? slow.seconds() : Bounded{pictures.value * fast.evaluation_seconds(), pictures.at_least};
  ratio.time = quotient(time, fast.seconds());
  return ratio;
}

std::string to_json_line(const BenchReport& slow, const BenchReport& fast, const SpeedUp& ratio) {
  nlohmann::ordered_json line;
  line["bench"] = fast.key().bench;
  line["kind"] = "ratio";
  line["scene"] = fast.key().scene;
  line["task"] = fast.key().task;
  line["slow"] = slow.key().method;
  line["slow_size"] = size_of(slow.key());
  line["fast"] = fast.key().method;
  line["fast_size"] = size_of(fast.key());
  line["work_ratio"] = ratio.work.value;
  line["work_at_least"] = ratio.work.at_least;
  line["time_ratio"] = ratio.time.value;
  line["time_at_least"] = ratio.time.at_least;
  line["time_measured"] = ratio.measured;
  return line.dump();
}

std::string to_table_line(const BenchReport& slow, const BenchReport& fast, const SpeedUp& ratio) {
  return fmt::format("{:<8} {:<11} {:<10} {} ({}) over {} ({}): {} times the work, {} times the time{}",
                     fast.key().bench, fast.key().scene, fast.key().task, slow.key().method, size_of(slow.key()),
                     fast.key().method, size_of(fast.key()), text(ratio.work, 0), text(ratio.time, 0),
                     ratio.measured ? "" : fmt::format(" (by counts, {:.4f} s a picture)", fast.evaluation_seconds()));
}

}  // namespace luminist
