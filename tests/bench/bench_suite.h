#pragma once
// tests/bench/bench_suite.h -- what all benchmarks share: which part is wanted, finished runs, and saying what came
// out.
#include <functional>
#include <string>
#include <vector>

#include "bench/bench_report.h"
#include "bench/bench_scene.h"
#include "bench/method.h"
#include "bench/run_store.h"

namespace luminist {

struct PictureSize {
  int width = 0;
  int height = 0;
  [[nodiscard]] std::string text() const;
  bool operator==(const PictureSize&) const = default;
};
/// "512x512". errors kUsage.
Result<PictureSize> parse_size(const std::string& text);

struct SuiteOptions {
  bool json = false;     ///< one object a line instead of a table
  bool verbose = false;  ///< a line a run on stderr
  bool fresh = false;    ///< forget finished runs
  std::string out = "out/bench";
  std::vector<std::string> scenes;  ///< empty: all of the benchmark; as the next two
  std::vector<std::string> tasks;
  std::vector<std::string> methods;
  int seeds = 0;     ///< 0: the benchmark's own numbers; else at most as many
  std::string size;  ///< empty: the benchmark's own sizes; else all methods at this one
  MethodCaps caps;
};

/// Seeds and sizes of one method.
struct MethodPlan {
  Method method = Method::kFast;
  PictureSize size;
  int seeds = 0;
};

/// The sizes of plans, each once, in their order.
std::vector<PictureSize> sizes_of(const std::vector<MethodPlan>& plans);

class BenchSuite {
 public:
  /// scenes, tasks: what the benchmark has. errors kUsage for a scene, task, method or size that there is not, with the
  /// nearest; kUnwritable.
  static Result<BenchSuite> create(std::string bench, const SuiteOptions& options, std::vector<std::string> scenes,
                                   std::vector<std::string> tasks);

  [[nodiscard]] const std::vector<std::string>& scenes() const { return scenes_; }
  [[nodiscard]] bool wants_task(const std::string& task) const;
  /// What is left of a benchmark's own plan after the user's choice of methods, seeds and size.
  [[nodiscard]] std::vector<MethodPlan> narrowed(std::vector<MethodPlan> plan) const;
  [[nodiscard]] const SuiteOptions& options() const { return options_; }
  [[nodiscard]] std::string file(const std::string& name) const;     ///< below the output folder
  [[nodiscard]] std::string prefix(const std::string& scene) const;  ///< "<bench>_<scene>", of files

  /// Seeds 1 to plan.seeds: stored runs are not run again. task names what make gives, down to every option that
  /// changes it. The report is said. errors of make and of the renderer.
  using MakeTask = std::function<Result<BenchTask>(std::uint64_t seed)>;
  Result<BenchReport> run(const BenchStage& stage, const std::string& task, const MethodPlan& plan,
                          const MakeTask& make);
  /// One of these runs; nothing is said.
  Result<BenchRun> solve(const BenchStage& stage, const std::string& task, Method method, std::uint64_t seed,
                         const MakeTask& make);
  /// A run of any other kind: the stored one of that method, caps and seed, or what make gives. errors make's.
  Result<BenchRun> find_or_make(const BenchStage& stage, const std::string& task, const std::string& method,
                                const std::string& caps, std::uint64_t seed,
                                const std::function<Result<BenchRun>()>& make);

  /// A line on stdout: the first with --json, else the second.
  void say(const std::string& json, const std::string& text) const;
  void say(const BenchReport& report) const;
  /// What every report of the faithful simplex takes more than that of the fast solver, of one task.
  void say_speed_ups(const std::vector<BenchReport>& reports) const;
  /// The convergence of all reports of one task as <bench>_<scene>_<task>.png. errors those of write_image().
  [[nodiscard]] Result<void> draw(const std::string& scene, const std::string& task,
                                  const std::vector<BenchReport>& reports) const;
  /// With --verbose, on stderr.
  void follow(const BenchRun& run) const;

 private:
  BenchSuite(std::string bench, SuiteOptions options, RunStore store)
      : bench_(std::move(bench)), options_(std::move(options)), store_(std::move(store)) {}

  std::string bench_;
  SuiteOptions options_;
  RunStore store_;
  std::vector<std::string> scenes_;
  std::vector<std::string> tasks_;
};

}  // namespace luminist
