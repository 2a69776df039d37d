#include "bench/scaling.h"

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "bench/crowd.h"
#include "bench/perturbation.h"

namespace luminist {
namespace {

constexpr PerturbReach kReach{0.01, 0.03};
constexpr PictureSize kSize{256, 256};
constexpr int kSeeds = 3;
constexpr std::size_t kMostTriangles = 1'000'000;
constexpr int kCoarsest = -2;  // steps of a quarter of the triangles
const char* const kScene = "bust";

/// One measurement: `x` of its axis.
struct Point {
  std::string axis;
  double x = 0.0;
  BenchScene scene;
  PictureSize size = kSize;
  int lights = 7;
  int free_lights = 1;
};

std::vector<Point> dof_points() {
  std::vector<Point> points;
  for (const int lights : {1, 2, 4, 8, 16, 28}) {
    points.push_back({"dofs", 18.0 * lights, demo_scene(kScene), kSize, lights, lights});
  }
  return points;
}

std::vector<Point> light_points() {
  std::vector<Point> points;
  for (const int lights : {1, 3, 10, 30, 100}) {
    points.push_back({"lights", static_cast<double>(lights), demo_scene(kScene), kSize, lights, 1});
  }
  return points;
}

std::vector<Point> pixel_points() {
  std::vector<Point> points;
  for (const PictureSize size :
       {PictureSize{64, 64}, PictureSize{128, 128}, PictureSize{256, 256}, PictureSize{512, 512},
        PictureSize{1024, 1024}, PictureSize{2048, 2048}, PictureSize{3840, 2160}}) {
    points.push_back({"pixels", static_cast<double>(size.width) * size.height, demo_scene(kScene), size});
  }
  return points;
}

/// The scene decimated, as it is and subdivided until it has the million; written beside the results.
Result<std::vector<Point>> triangle_points(const BenchSuite& suite) {
  std::vector<Point> points;
  LUM_TRY(const std::filesystem::path file, AssetRoots::standard().find(demo_scene(kScene).shot.scene));
  Diagnostics diagnostics;
  LUM_TRY(const Scene coarse, load_scene(file.string(), {}, diagnostics));
  for (int level = kCoarsest;; ++level) {
    LUM_TRY(const Scene scene, refined(coarse, level));
    const std::size_t triangles = scene.triangle_count();
    BenchScene named = demo_scene(kScene);
    named.shot.scene = suite.file(fmt::format("scaling_{}.glb", level - kCoarsest));
    LUM_TRY_VOID(save_scene(scene, named.shot.scene));
    points.push_back({"triangles", static_cast<double>(triangles), named});
    const bool grows = level == kCoarsest || static_cast<double>(triangles) > points[points.size() - 2].x;
    if (triangles >= kMostTriangles || !grows) break;
  }
  return points;
}

Result<BenchTask> moved_task(const BenchStage& stage, const Point& point, std::uint64_t seed) {
  static constexpr std::array<std::string_view, 8> kAll{"position", "direction",        "color", "cutoff", "shape",
                                                        "falloff",  "falloff_distance", "shadow"};
  ParamState original = crowded(stage.state, stage.frame(), point.lights);
  for (int i = 0; i < point.free_lights; ++i) unlock_roles(original.rig.lights[static_cast<std::size_t>(i)], kAll);
  LUM_TRY(const Image picture, stage.renderer().render(original));
  Random random(seed);
  const std::vector<UnitRange> whole(static_cast<std::size_t>(free_dofs(original, stage.frame())));
  BenchTask task{perturbed(original, stage.frame(), whole, kReach, random), whole_picture(picture, picture)};
  LUM_TRY(const double epsilon, stage.renderer().error(task.start, task.target));
  task.goal = kReached * epsilon;
  return task;
}

/// The medians of one point; work in light evaluations and shadow queries.
struct Measured {
  double x = 0.0;
  double work = 0.0;
  double seconds = 0.0;
  double picture_seconds = 0.0;
  bool reached = true;  ///< else work and time are bounds
};

Result<Measured> measure(Device& device, BenchSuite& suite, const Point& point) {
  LUM_TRY(const BenchStage stage, open_bench_stage(device, point.scene, point.size.width, point.size.height));
  BenchReport report;
  const std::string task = fmt::format("{} {:.0f}", point.axis, point.x);
  const int seeds = suite.options().seeds > 0 ? suite.options().seeds : kSeeds;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto make = [&](std::uint64_t which) { return moved_task(stage, point, which); };
    LUM_TRY(BenchRun run, suite.solve(stage, task, Method::kFast, static_cast<std::uint64_t>(seed), make));
    suite.follow(run);
    report.runs.push_back(std::move(run));
  }
  suite.say(report);
  const double picture_work = 2.0 * point.size.width * point.size.height * point.lights;
  return Measured{point.x, picture_work * report.equivalents().value, report.seconds().value,
                  report.evaluation_seconds(), !report.equivalents().at_least};
}

void say_exponents(const BenchSuite& suite, const std::string& axis, const std::vector<Measured>& measured) {
  const auto slope = [&](double Measured::*what) {
    std::vector<double> x;
    std::vector<double> y;
    for (const Measured& each : measured) x.push_back(each.x), y.push_back(each.*what);
    return exponent(x, y);
  };
  const double work = slope(&Measured::work);
  const double seconds = slope(&Measured::seconds);
  const double picture = slope(&Measured::picture_seconds);
  const nlohmann::ordered_json line{
      {"bench", "scaling"},         {"kind", "exponent"},    {"axis", axis},
      {"points", measured.size()},  {"work_exponent", work}, {"seconds_exponent", seconds},
      {"picture_exponent", picture}};
  suite.say(line.dump(), fmt::format("scaling  {}: work ~ {}^{:.2f}, time ~ {}^{:.2f}, one picture ~ {}^{:.2f}", axis,
                                     axis, work, axis, seconds, axis, picture));
}

}  // namespace

Result<void> run_scaling(Device& device, const SuiteOptions& options) {
  const std::vector<std::string> axes{"dofs", "lights", "triangles", "pixels"};
  LUM_TRY(BenchSuite suite, BenchSuite::create("scaling", options, {kScene}, axes));
  for (const std::string& axis : axes) {
    if (!suite.wants_task(axis)) continue;
    std::vector<Point> points;
    if (axis == "dofs") points = dof_points();
    if (axis == "lights") points = light_points();
    if (axis == "pixels") points = pixel_points();
    if (axis == "triangles") {
      LUM_TRY(points, triangle_points(suite));
    }
    std::vector<Measured> measured;  // what reached its goal
    for (const Point& point : points) {
      auto one = measure(device, suite, point);
      if (!one && one.error().kind != ErrorKind::kLimit && one.error().kind != ErrorKind::kGl) return one.error();
      if (one && one->reached) measured.push_back(*one);
      if (one) continue;
      const nlohmann::ordered_json line{{"bench", "scaling"},
                                        {"kind", "left_out"},
                                        {"axis", axis},
                                        {"x", point.x},
                                        {"reason", one.error().message()}};
      suite.say(line.dump(), fmt::format("scaling  {} {:.0f} is left out: {}", axis, point.x, one.error().message()));
    }
    say_exponents(suite, axis, measured);
  }
  return {};
}

}  // namespace luminist
