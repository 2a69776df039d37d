#include "bench/bench_suite.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/files.h"
#include "bench/convergence.h"
#include "image_io/image_io.h"

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

std::vector<PictureSize> sizes_of(const std::vector<MethodPlan>& plans) {
  std::vector<PictureSize> sizes;
  for (const MethodPlan& plan : plans) {
    if (std::find(sizes.begin(), sizes.end(), plan.size) == sizes.end()) sizes.push_back(plan.size);
  }
  return sizes;
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

std::string BenchSuite::prefix(const std::string& scene) const {
  return bench_ + "_" + scene;
}

Result<BenchReport> BenchSuite::run(const BenchStage& stage, const std::string& task, const MethodPlan& plan,
                                    const MakeTask& make) {
  BenchReport report;
  for (int seed = 1; seed <= plan.seeds; ++seed) {
    LUM_TRY(BenchRun run, solve(stage, task, plan.method, static_cast<std::uint64_t>(seed), make));
    follow(run);
    report.runs.push_back(std::move(run));
  }
  say(report);
  return report;
}

Result<BenchRun> BenchSuite::solve(const BenchStage& stage, const std::string& task, Method method, std::uint64_t seed,
                                   const MakeTask& make) {
  const auto run = [&]() -> Result<BenchRun> {
    LUM_TRY(const BenchTask made, make(seed));
    LUM_TRY(const double picture, time_evaluation(stage.renderer(), made));
    LUM_TRY(BenchRun done, run_method(stage.renderer(), made, method, options_.caps, seed));
    done.evaluation_seconds = picture;
    return done;
  };
  return find_or_make(stage, task, to_word(method), options_.caps.text(method), seed, run);
}

Result<BenchRun> BenchSuite::find_or_make(const BenchStage& stage, const std::string& task, const std::string& method,
                                          const std::string& caps, std::uint64_t seed,
                                          const std::function<Result<BenchRun>()>& make) {
  const BenchKey key{bench_, stage.scene, task, method, stage.width, stage.height, caps, seed};
  return store_.find_or_make(key, make);
}

void BenchSuite::follow(const BenchRun& run) const {
  if (options_.verbose) std::fputs((to_text(run) + "\n").c_str(), stderr);
}

void BenchSuite::say(const BenchReport& report) const {
  say(to_json_line(report), to_table_line(report));
}

void BenchSuite::say(const std::string& json, const std::string& text) const {
  std::printf("%s\n", options_.json ? json.c_str() : text.c_str());
  std::fflush(stdout);
}

void BenchSuite::say_speed_ups(const std::vector<BenchReport>& reports) const {
  for (const BenchReport& fast : reports) {
    if (fast.key().method != to_word(Method::kFast)) continue;
    for (const BenchReport& slow : reports) {
      if (slow.key().method != to_word(Method::kSimplex)) continue;
      const SpeedUp ratio = speed_up(slow, fast);
      say(to_json_line(slow, fast, ratio), to_table_line(slow, fast, ratio));
    }
  }
}

Result<void> BenchSuite::draw(const std::string& scene, const std::string& task,
                              const std::vector<BenchReport>& reports) const {
  if (reports.empty()) return {};
  std::string name = fmt::format("{}_{}.png", prefix(scene), task);
  std::replace(name.begin(), name.end(), ' ', '_');
  return write_image(file(name), convergence_image(fmt::format("{}: {}, {}", bench_, scene, task), reports));
}

}  // namespace luminist
