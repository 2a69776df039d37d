#include "bench/table1.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/perturbation.h"

namespace luminist {
namespace {

constexpr PictureSize kFastSize{512, 512};
constexpr PictureSize kBaselineSize{128, 128};
constexpr PictureSize kProbe{96, 96};  // where useful ranges are measured
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

std::vector<Row> wanted_rows(const BenchSuite& suite) {
  std::vector<Row> rows;
  for (Row& row : table_rows()) {
    if (suite.wants_task(row.name)) rows.push_back(std::move(row));
  }
  return rows;
}

/// Within what and how far the degrees of freedom of a row are moved.
struct Reach {
  std::vector<UnitRange> ranges;
  PerturbReach share;
};

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
                                 const Reach& reach, std::uint64_t seed) {
  constexpr double kNegligible = 0.005;  // of the picture's brightness
  constexpr int kDraws = 1000;
  Random random(seed);
  BenchTask task{original, whole_picture(picture, picture)};
  const double least = kNegligible * mean_length(picture);
  for (int i = 0; i < kDraws; ++i) {
    task.start = perturbed(original, stage.frame(), reach.ranges, reach.share, random);
    LUM_TRY(const double epsilon, stage.renderer().error(task.start, task.target));
    task.goal = kReached * epsilon;
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

/// Ranges by the names of degrees of freedom, measured on one small picture, so that every size moves lights alike.
using RangeTable = std::map<std::string, UnitRange>;

/// Those of every degree of freedom that is free in one of the rows.
Result<RangeTable> measured_ranges(const BenchStage& probe, const std::vector<Row>& rows, const std::string& perturb) {
  ParamState original = probe.state;
  for (const Row& row : rows) original = with_row_free(std::move(original), row);
  const std::vector<std::string> names = free_names(original, probe.frame());
  std::vector<UnitRange> ranges(names.size());
  if (perturb != "manifest") {
    LUM_TRY(ranges, useful_ranges(probe.renderer(), original));
  }
  RangeTable table;
  for (std::size_t k = 0; k < names.size(); ++k) table[names[k]] = ranges[k];
  return table;
}

Reach reach_of(const BenchStage& stage, const Row& row, const RangeTable& table, const std::string& perturb) {
  Reach reach;
  if (perturb == "small") reach.share = {0.25 * reach.share.least, 0.25 * reach.share.most};
  const std::vector<std::string> names = free_names(with_row_free(stage.state, row), stage.frame());
  for (const std::string& name : names) reach.ranges.push_back(table.at(name));
  return reach;
}

/// The degrees of freedom of a row and their ranges, in [0,1] of the manifest's: a line a light.
void say_dofs(const BenchSuite& suite, const BenchStage& stage, const Row& row, const RangeTable& table) {
  const std::vector<std::string> names = free_names(with_row_free(stage.state, row), stage.frame());
  nlohmann::ordered_json line{
      {"bench", "table1"}, {"kind", "dofs"}, {"scene", stage.scene}, {"task", row.name}, {"dofs", names.size()}};
  std::string text = fmt::format("{} row {}, free and the part of [0,1] they are moved in:", stage.scene, row.name);
  std::string light;
  for (const std::string& name : names) {
    const UnitRange& range = table.at(name);
    line["names"].push_back(name);
    line["ranges"].push_back({range.low, range.high});
    const std::size_t slash = name.rfind('/');
    if (name.substr(0, slash) != light) text += "\n  " + (light = name.substr(0, slash)) + ":";
    text += fmt::format(" {} {:.2f}-{:.2f}", name.substr(slash + 1), range.low, range.high);
  }
  suite.say(line.dump(), text);
}

using RowReports = std::map<std::string, std::vector<BenchReport>>;

/// All rows of one scene at one size.
Result<void> run_scene(BenchSuite& suite, const BenchStage& stage, const RangeTable& ranges, const std::string& perturb,
                       RowReports& reports) {
  LUM_TRY(const Image picture, stage.renderer().render(stage.state));
  for (const Row& row : wanted_rows(suite)) {
    const ParamState original = with_row_free(stage.state, row);
    const Reach reach = reach_of(stage, row, ranges, perturb);
    for (const MethodPlan& plan : suite.narrowed(row_plan(row))) {
      if (plan.size != PictureSize{stage.width, stage.height}) continue;
      const auto make = [&](std::uint64_t seed) { return perturbed_task(stage, original, picture, reach, seed); };
      LUM_TRY(BenchReport report, suite.run(stage, row.name + " " + perturb, plan, make));
      reports[row.name].push_back(std::move(report));
    }
  }
  return {};
}

}  // namespace

Result<void> run_table1(Device& device, const Table1Options& options) {
  if (options.perturb != "full" && options.perturb != "small" && options.perturb != "manifest") {
    return Error{ErrorKind::kUsage, "there is no such way of moving lights away", "", "perturb",
                 "give full, small or manifest"};
  }
  LUM_TRY(BenchSuite suite,
          BenchSuite::create("table1", options.suite, {"still_life", "bust", "creature"}, row_names()));
  for (const std::string& scene : suite.scenes()) {
    LUM_TRY(const BenchStage probe, open_bench_stage(device, demo_scene(scene), kProbe.width, kProbe.height));
    LUM_TRY(const RangeTable ranges, measured_ranges(probe, wanted_rows(suite), options.perturb));
    for (const Row& row : wanted_rows(suite)) say_dofs(suite, probe, row, ranges);
    RowReports reports;
    std::vector<MethodPlan> plans;
    for (const Row& row : wanted_rows(suite)) {
      for (const MethodPlan& plan : suite.narrowed(row_plan(row))) plans.push_back(plan);
    }
    for (const PictureSize& size : sizes_of(plans)) {
      LUM_TRY(const BenchStage stage, open_bench_stage(device, demo_scene(scene), size.width, size.height));
      LUM_TRY_VOID(run_scene(suite, stage, ranges, options.perturb, reports));
    }
    for (const Row& row : wanted_rows(suite)) {
      suite.say_speed_ups(reports[row.name]);
      LUM_TRY_VOID(suite.draw(scene, row.name + " " + options.perturb, reports[row.name]));
    }
  }
  return {};
}

}  // namespace luminist
