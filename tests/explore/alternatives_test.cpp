#include "explore/alternatives.h"

#include <gtest/gtest.h>

#include "explore/light_distance.h"
#include "explore/other_starts.h"
#include "render/metric.h"
#include "solve/fake_renderer.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

constexpr std::uint32_t kWall = 2;
const Vec3 kSpot(-0.4F, 1.9F, -2.2F);

/// A spot painted on the wall, and a light that stands before it.
struct Task {
  FakeRenderer renderer;
  ParamState start;
  Target target;

  Task() : renderer(48, 36), start(renderer.empty_state()) {
    target = renderer.target_of(start, start);
    const SurfaceBuffer& surface = renderer.surface();
    for (std::size_t i = 0; i < surface.pixels(); ++i) {
      const bool painted = surface.object[i] == kWall && glm::distance(surface.position[i], kSpot) < 0.6F;
      if (painted) target.color.set_rgb(i, target.before.rgb(i) + Vec3(0.6F, 0.5F, 0.4F) * surface.albedo[i]);
      target.importance.data[i] = painted ? 1.0F : 0.02F;
      target.stroke[i] = painted ? 1 : 0;
    }
    Light light = renderer.cinematic("light");
    const ParamSchema& schema = light.params.schema();
    light.params.set_param_locked(-1, true);
    for (const char* role : {"position", "direction", "color", "shape"}) {
      light.params.set_param_locked(*schema.by_role(role), false);
    }
    light.params.set_vec3(*schema.by_role("position"), Vec3(1.5F, 3.0F, 2.5F));
    light.params.set_vec3(*schema.by_role("direction"), glm::normalize(kSpot - Vec3(1.5F, 3.0F, 2.5F)));
    start.rig.lights.push_back(light);
  }
  Result<Alternatives> find(const AlternativesOptions& options, const ExploreWatch& watch = {}) {
    return find_alternatives(renderer, start, target, options, watch);
  }
};

AlternativesOptions few() {
  AlternativesOptions options;
  options.count = 3;
  options.tries = 6;
  options.allowance = 0.1;  // the spot has a rim, which only one side meets exactly
  return options;
}

TEST(AlternativesTest, AFlatWallCanBeLitFromSeveralSides) {
  Task task;
  LUM_ASSERT_OK(const Alternatives found, task.find(few()));
  ASSERT_EQ(found.list.size(), 3U) << found.good << " within " << found.limit << ", the best "
                                   << found.list.front().report.epsilon << " from "
                                   << found.list.front().report.epsilon_start;
  EXPECT_EQ(found.tried, 6);
  LightEye eye(task.renderer, kSpot);
  std::vector<std::vector<LightLook>> looks;
  for (const Alternative& each : found.list) {
    EXPECT_LE(each.report.epsilon, found.limit);
    LUM_ASSERT_OK(const double epsilon, task.renderer.error(each.state, task.target));
    EXPECT_LE(epsilon, found.limit);
    LUM_ASSERT_OK(auto look, eye.look(each.state));
    looks.push_back(std::move(look));
  }
  for (std::size_t i = 1; i < looks.size(); ++i) {
    EXPECT_GE(found.list[i].distance, few().distinct);
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT(look_distance(looks[i], looks[j]), 0.1);
  }
}

TEST(AlternativesTest, TheFirstIsTheBestAndNotWorseThanOneSolve) {
  Task task;
  LUM_ASSERT_OK(SolveSession solve, SolveSession::create(task.renderer, task.start, task.target, {}));
  for (bool more = true; more;) {
    LUM_ASSERT_OK(more, solve.step());
  }
  LUM_ASSERT_OK(const Alternatives found, task.find(few()));
  EXPECT_LE(found.list.front().report.epsilon, solve.report().epsilon);
  for (const Alternative& each : found.list) EXPECT_GE(each.report.epsilon, found.list.front().report.epsilon);
}

TEST(AlternativesTest, WhereOnlyAColourIsFreeThereIsOne) {
  Task task;
  ParamBlock& params = task.start.rig.lights[0].params;
  params.set_param_locked(-1, true);
  params.set_param_locked(*params.schema().by_role("color"), false);
  LUM_ASSERT_OK(const Alternatives found, task.find(few()));
  EXPECT_EQ(found.list.size(), 1U);
  EXPECT_GT(found.good, 1);
}

TEST(AlternativesTest, TheSameSeedGivesTheSameBits) {
  Task task;
  AlternativesOptions options = few();
  options.tries = 3;
  LUM_ASSERT_OK(const Alternatives one, task.find(options));
  LUM_ASSERT_OK(const Alternatives two, task.find(options));
  ASSERT_EQ(one.list.size(), two.list.size());
  for (std::size_t i = 0; i < one.list.size(); ++i) {
    EXPECT_EQ(rig_to_toml(one.list[i].state.rig), rig_to_toml(two.list[i].state.rig));
    EXPECT_EQ(one.list[i].distance, two.list[i].distance);
  }
}

TEST(AlternativesTest, StoppedAtOnceTheyAreTheBestSoFar) {
  Task task;
  LUM_ASSERT_OK(const Alternatives found, task.find(few(), [](const ExploreProgress&) { return false; }));
  EXPECT_TRUE(found.stopped);
  EXPECT_EQ(found.tried, 0);
  EXPECT_EQ(found.list.size(), 1U);
}

TEST(AlternativesTest, WatchHearsHowFarItIs) {
  Task task;
  int most = 0;
  LUM_ASSERT_OK(const Alternatives found, task.find(few(), [&](const ExploreProgress& progress) {
    most = std::max(most, progress.done);
    EXPECT_LT(progress.done, progress.planned);
    EXPECT_FALSE(progress.doing.empty());
    return true;
  }));
  EXPECT_GE(most, 6);
  EXPECT_FALSE(found.stopped);
}

TEST(OtherStartsTest, StayInRangeAndGoOnShiningAtTheSamePlace) {
  Task task;
  const SampleCells cells = CellSampler(task.renderer.surface(), task.target).cut(64, 1, 1);
  const Vec3 focus = kSpot;
  const SceneFrame frame = task.renderer.frame();
  OtherStarts starts(task.start, cells, frame, focus, 3);
  const Vec3 home = aim_point(task.start.rig.lights[0], frame, focus);
  for (int i = 0; i < 20; ++i) {
    const OtherStart start = starts.next();
    const Light& light = start.state.rig.lights[0];
    const int position = *light.params.schema().by_role("position");
    const Vec3 place = light.params.vec3(position);
    EXPECT_GT(place.z, home.z);  // before the wall
    const Vec3 way = light.params.vec3(*light.params.schema().by_role("direction"));
    EXPECT_NEAR(glm::length(glm::cross(way, glm::normalize(home - place))), 0.0F, 1e-4F);
    const std::vector<const ParamBlock*> blocks = start.state.blocks();
    const std::vector<double> x = UnitMap::create(blocks, frame).to_unit(blocks);
    EXPECT_NEAR(penalty(x), 0.0, 1e-5);  // a float at the end of its range
    EXPECT_TRUE(start.held.rig.lights[0].params.locked(light.params.schema()[position].first_dof));
  }
}

}  // namespace
}  // namespace luminist
