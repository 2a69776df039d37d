#include "bench/table1.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/convergence.h"
#include "bench/perturbation.h"
#include "image_io/image_io.h"

namespace luminist {
namespace {

constexpr double kGoal = 0.05;  // of the start's epsilon: the paper's
constexpr PictureSize kFastSize{512, 512};
constexpr PictureSize kBaselineSize{128, 128};
constexpr int kFastSeeds = 20;
constexpr int kBaselineSeeds = 5;
constexpr int kFullSizeSeeds = 2;  // of baselines at the fast solver's size, for one row
const char* const kFullSizeRow = "18";

using Roles = std::vector<std::string_view>;

/// The degrees of freedom of one row: those of the rig's first lights whose parameters have these roles.
struct Row {
  std::string name;
  std::vector<Roles> lights;
};

std::vector<Row> table_rows() {
  const Roles place{"position", "direction"};                                  // 5 of a cinematic light
  const Roles look{"position", "direction", "color", "shape"};                 // 11
  const Roles reach{"position", "direction", "color", "shape", "cutoff"};      // 15
  const Roles all{"position", "direction",        "color", "shape", "cutoff",  //
                  "falloff",  "falloff_distance", "shadow"};                   // 18
  return {{"5", {place}}, {"18", {all}}, {"30", {reach, reach}}, {"51", {all, look, look, look}}};
}

std::vector<std::string> row_names() {
  std::vector<std::string> names;
  for (const Row& row : table_rows()) names.push_back(row.name);
  return names;
}

ParamState with_row_free(ParamState state, const Row& row) {
  LUM_CHECK(row.lights.size() <= state.rig.lights.size(), "the demo rigs have six lights or more");
  for (std::size_t i = 0; i < row.lights.size(); ++i) unlock_roles(state.rig.lights[i], row.lights[i]);
  return state;
}

/// How bright a picture is, in the measure of epsilon.
double mean_length(const Image& picture) {
  double sum = 0.0;
  for (std::size_t i = 0; i < picture.pixels(); ++i) sum += glm::length(picture.rgb(i));
  return sum / static_cast<double>(picture.pixels());
}

/// Draws again while nobody could see the difference: a light that shows neither before nor after is no task.
Result<BenchTask> perturbed_task(const BenchStage& stage, const ParamState& original, const Image& picture,
                                 const PerturbReach& reach, std::uint64_t seed) {
  constexpr double kNegligible = 0.005;  // of the picture's brightness
  constexpr int kDraws = 1000;
  Random random(seed);
  BenchTask task{original, whole_picture(picture, picture)};
  const double least = kNegligible * mean_length(picture);
  for (int i = 0; i < kDraws; ++i) {
    task.start = perturbed(original, stage.frame(), reach, random);
    LUM_TRY(const double epsilon, stage.renderer().error(task.start, task.target));
    task.goal = kGoal * epsilon;
    if (epsilon > least) return task;
  }
  return Error{ErrorKind::kLimit, "no random change of these lights can be seen", stage.scene, "rows", ""};
}

std::vector<MethodPlan> row_plan(const Row& row) {
  std::vector<MethodPlan> plan{{Method::kFast, kFastSize, kFastSeeds}};
  for (const Method method : {Method::kSimplex, Method::kNloptNelderMead, Method::kNloptBobyqa}) {
    plan.push_back({method, kBaselineSize, kBaselineSeeds});
    if (row.name == kFullSizeRow) plan.push_back({method, kFastSize, kFullSizeSeeds});
  }
  return plan;
}

void say_dofs(const BenchSuite& suite, const BenchStage& stage, const Row& row) {
  const ParamState state = with_row_free(stage.state, row);
  const std::vector<const ParamBlock*> blocks = state.blocks();
  const std::vector<std::string> names = dof_names(state, UnitMap::create(blocks, stage.frame()));
  nlohmann::ordered_json line{{"bench", "table1"}, {"kind", "dofs"},       {"scene", stage.scene},
                              {"task", row.name},  {"dofs", names.size()}, {"names", names}};
  suite.say(line.dump(), fmt::format("{} row {}: {}", stage.scene, row.name, fmt::join(names, " ")));
}

/// All rows of one scene at one size.
Result<void> run_scene(BenchSuite& suite, const BenchStage& stage, const Table1Options& options,
                       std::vector<std::pair<std::string, BenchReport>>& reports) {
  const PerturbReach reach = options.perturb == "small" ? small_reach() : full_reach();
  LUM_TRY(const Image picture, stage.renderer().render(stage.state));
  for (const Row& row : table_rows()) {
    if (!suite.wants_task(row.name)) continue;
    const ParamState original = with_row_free(stage.state, row);
    for (const MethodPlan& plan : suite.narrowed(row_plan(row))) {
      if (plan.size != PictureSize{stage.width, stage.height}) continue;
      const auto make = [&](std::uint64_t seed) { return perturbed_task(stage, original, picture, reach, seed); };
      LUM_TRY(BenchReport report, suite.run(stage, row.name + " " + options.perturb, plan, make));
      reports.emplace_back(row.name, std::move(report));
    }
  }
  return {};
}

/// For each row what every run of the simplex takes more than the fast solver's.
void say_speed_ups(const BenchSuite& suite, const std::vector<std::pair<std::string, BenchReport>>& reports) {
  for (const auto& [row, fast] : reports) {
    if (fast.key().method != to_word(Method::kFast)) continue;
    for (const auto& [other_row, slow] : reports) {
      if (other_row == row && slow.key().method == to_word(Method::kSimplex)) suite.say_speed_up(slow, fast);
    }
  }
}

/// One picture a row, of all methods and sizes.
Result<void> draw_convergence(const BenchSuite& suite, const std::string& scene,
                              const std::vector<std::pair<std::string, BenchReport>>& reports) {
  for (const Row& row : table_rows()) {
    std::vector<const BenchReport*> of_row;
    for (const auto& [name, report] : reports) {
      if (name == row.name) of_row.push_back(&report);
    }
    if (of_row.empty()) continue;
    const Image image = convergence_image(fmt::format("Table I, {}: {} degrees of freedom", scene, row.name), of_row);
    LUM_TRY_VOID(write_image(suite.file(fmt::format("table1_{}_{}.png", scene, row.name)), image));
  }
  return {};
}

/// The sizes that are left of the plans, each once.
std::vector<PictureSize> sizes(const BenchSuite& suite) {
  std::vector<PictureSize> result;
  for (const Row& row : table_rows()) {
    if (!suite.wants_task(row.name)) continue;
    for (const MethodPlan& plan : suite.narrowed(row_plan(row))) {
      if (std::find(result.begin(), result.end(), plan.size) == result.end()) result.push_back(plan.size);
    }
  }
  return result;
}

}  // namespace

Result<void> run_table1(Device& device, const Table1Options& options) {
  if (options.perturb != "full" && options.perturb != "small") {
    return Error{ErrorKind::kUsage, "lights are moved by their full range or a small part of it", "", "perturb",
                 "give full or small"};
  }
  LUM_TRY(BenchSuite suite,
          BenchSuite::create("table1", options.suite, {"still_life", "bust", "creature"}, row_names()));
  for (const std::string& scene : suite.scenes()) {
    std::vector<std::pair<std::string, BenchReport>> reports;
    bool named = false;
    for (const PictureSize& size : sizes(suite)) {
      LUM_TRY(const BenchStage stage, open_bench_stage(device, demo_scene(scene), size.width, size.height));
      for (const Row& row : table_rows()) {
        if (!named && suite.wants_task(row.name)) say_dofs(suite, stage, row);
      }
      named = true;
      LUM_TRY_VOID(run_scene(suite, stage, options, reports));
    }
    say_speed_ups(suite, reports);
    LUM_TRY_VOID(draw_convergence(suite, scene, reports));
  }
  return {};
}

}  // namespace luminist
