#include "bench/bench_suite.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/files.h"

namespace luminist {
namespace {

/// The entries of all that are wanted, in their own order; all if nothing is.
Result<std::vector<std::string>> chosen(const std::vector<std::string>& wanted, std::span<const std::string> all,
                                        const char* field) {
  for (const std::string& word : wanted) {
    if (std::find(all.begin(), all.end(), word) != all.end()) continue;
    const std::string near = nearest_name(word, all);
    return Error{
        ErrorKind::kUsage, fmt::format("this benchmark has no \"{}\"", word), "", field,
        near.empty() ? fmt::format("it has: {}", fmt::join(all, ", ")) : fmt::format("did you mean \"{}\"?", near)};
  }
  std::vector<std::string> result;
  for (const std::string& word : all) {
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), word) != wanted.end()) result.push_back(word);
  }
  return result;
}

}  // namespace

std::string PictureSize::text() const {
  return fmt::format("{}x{}", width, height);
}

Result<PictureSize> parse_size(const std::string& text) {
  PictureSize size;
  int end = 0;
  const bool read = std::sscanf(text.c_str(), "%dx%d%n", &size.width, &size.height, &end) == 2;
  if (read && end == static_cast<int>(text.size()) && size.width > 0 && size.height > 0) return size;
  return Error{ErrorKind::kUsage, fmt::format("\"{}\" is no size", text), "", "size", "write it as 512x512"};
}

Result<BenchSuite> BenchSuite::create(std::string bench, const SuiteOptions& options, std::vector<std::string> scenes,
                                      std::vector<std::string> tasks) {
  const std::filesystem::path file = std::filesystem::path(options.out) / (bench + ".jsonl");
  LUM_TRY(std::vector<std::string> wanted_scenes, chosen(options.scenes, scenes, "scenes"));
  LUM_TRY(std::vector<std::string> wanted_tasks, chosen(options.tasks, tasks, "rows"));
  LUM_TRY([[maybe_unused]] const auto methods, chosen(options.methods, method_words(), "methods"));
  if (!options.size.empty()) {
    LUM_TRY([[maybe_unused]] const PictureSize size, parse_size(options.size));
  }
  LUM_TRY(RunStore store, RunStore::open(file, options.fresh));
  BenchSuite suite(std::move(bench), options, std::move(store));
  suite.scenes_ = std::move(wanted_scenes);
  suite.tasks_ = std::move(wanted_tasks);
  return suite;
}

bool BenchSuite::wants_task(const std::string& task) const {
  return std::find(tasks_.begin(), tasks_.end(), task) != tasks_.end();
}

std::vector<MethodPlan> BenchSuite::narrowed(std::vector<MethodPlan> plan) const {
  std::vector<MethodPlan> result;
  for (MethodPlan each : plan) {
    const auto& methods = options_.methods;
    if (!methods.empty() && std::find(methods.begin(), methods.end(), to_word(each.method)) == methods.end()) continue;
    if (options_.seeds > 0) each.seeds = std::min(each.seeds, options_.seeds);
    if (!options_.size.empty()) each.size = parse_size(options_.size).value();
    const bool known = std::any_of(result.begin(), result.end(), [&](const MethodPlan& other) {
      return other.method == each.method && other.size == each.size;
    });
    if (!known) result.push_back(each);
  }
  return result;
}

std::string BenchSuite::file(const std::string& name) const {
  return (std::filesystem::path(options_.out) / name).string();
}

Result<BenchReport> BenchSuite::run(const BenchStage& stage, const std::string& task, const MethodPlan& plan,
                                    const MakeTask& make) {
  BenchReport report;
  for (int seed = 1; seed <= plan.seeds; ++seed) {
    const BenchKey key{bench_,
                       stage.scene,
                       task,
                       to_word(plan.method),
                       stage.width,
                       stage.height,
                       options_.caps.text(plan.method),
                       static_cast<std::uint64_t>(seed)};
    const auto solve = [&]() -> Result<BenchRun> {
      LUM_TRY(const BenchTask made, make(key.seed));
      LUM_TRY(const double picture, time_evaluation(stage.renderer(), made));
      LUM_TRY(BenchRun done, run_method(stage.renderer(), made, plan.method, options_.caps, key.seed));
      done.evaluation_seconds = picture;
      return done;
    };
    LUM_TRY(const BenchRun run, store_.find_or_make(key, solve));
    if (options_.verbose) std::fputs((to_text(run) + "\n").c_str(), stderr);
    report.runs.push_back(run);
  }
  say(to_json_line(report), to_table_line(report));
  return report;
}

void BenchSuite::say(const std::string& json, const std::string& text) const {
  std::printf("%s\n", options_.json ? json.c_str() : text.c_str());
  std::fflush(stdout);
}

void BenchSuite::say_speed_up(const BenchReport& slow, const BenchReport& fast) const {
  const SpeedUp ratio = speed_up(slow, fast);
  say(to_json_line(slow, fast, ratio), to_table_line(slow, fast, ratio));
}

}  // namespace luminist
