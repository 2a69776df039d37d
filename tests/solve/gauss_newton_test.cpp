#include "solve/gauss_newton.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solve/fake_renderer.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

class GaussNewtonTest : public testing::Test {
 protected:
  explicit GaussNewtonTest(FakeStyle style = FakeStyle::kMatte)
      : renderer_(96, 96, style), wanted_(renderer_.empty_state()) {
    wanted_.rig.lights.push_back(hidden_light(renderer_, "spot", 6));
    target_ = renderer_.target_of(wanted_, renderer_.empty_state());
    const CellSampler sampler(renderer_.surface(), target_);
    level_ = {sampler.cut(600, 1, 1), {}, 0.004, 0.003, 30};
  }
  Result<CellProblem> problem(const ParamState& start) {
    LUM_TRY(const PictureParts parts, PictureParts::create(renderer_, start, level_.cells.samples));
    parts_ = parts;
    return CellProblem::create(renderer_, parts_, level_, start, Norm::kUnsquared);
  }
  ParamBlock& light(ParamState& state) { return state.rig.lights[0].params; }
  int position_of(ParamState& state) { return *light(state).schema().by_role("position"); }
  void move_light(ParamState& state, const Vec3& by) {
    light(state).set_vec3(position_of(state), light(state).vec3(position_of(state)) + by);
  }

  FakeRenderer renderer_;
  ParamState wanted_;
  Target target_;
  Level level_;
  PictureParts parts_;
};

TEST_F(GaussNewtonTest, ColoursAreFoundByMeasuringOnce) {
  ParamState start = wanted_;
  light(start).set_vec3(*light(start).schema().by_role("color"), Vec3(0.01F, 3.0F, 0.5F));
  LUM_ASSERT_OK(const CellProblem cells, problem(start));
  LUM_ASSERT_OK(const CellPoint point, cells.measure(start));
  EXPECT_LT(point.cost, 1e-4);  // of a picture of brightness 1: floats
}

TEST_F(GaussNewtonTest, FindsBackToALightThatWasMovedALittle) {
  ParamState start = wanted_;
  move_light(start, Vec3(0.06F, -0.04F, 0.04F));
  LUM_ASSERT_OK(const CellProblem cells, problem(start));
  LUM_ASSERT_OK(CellPoint point, cells.measure(start));
  const double before = point.cost;
  GaussNewton descent(cells, std::move(point), renderer_.frame().center);
  for (bool more = true; more;) {
    LUM_ASSERT_OK(more, descent.iterate());
  }
  EXPECT_LT(descent.point().cost, 0.1 * before);
}

TEST_F(GaussNewtonTest, NeverCostsMoreFromOneIterationToTheNextAndStaysInTheUnitCube) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    ParamState start = renderer_.empty_state();
    start.rig.lights.push_back(hidden_light(renderer_, "spot", seed + 20));
    LUM_ASSERT_OK(const CellProblem cells, problem(start));
    LUM_ASSERT_OK(CellPoint point, cells.measure(start));
    double cost = point.cost;
    GaussNewton descent(cells, std::move(point), renderer_.frame().center);
    for (bool more = true; more;) {
      LUM_ASSERT_OK(more, descent.iterate());
      EXPECT_LE(descent.point().cost, cost);
      cost = descent.point().cost;
    }
    const std::vector<const ParamBlock*> blocks = std::as_const(descent.point().state).blocks();
    const UnitMap map = UnitMap::create(blocks, renderer_.frame());
    EXPECT_NEAR(penalty(map.to_unit(blocks)), 0.0, 1e-5);  // values are floats
  }
}

TEST_F(GaussNewtonTest, OnlyTheTouchedPartsOfAPictureAreEvaluated) {
  ParamState start = wanted_;
  start.rig.lights.push_back(hidden_light(renderer_, "locked", 9));
  start.rig.lights[1].params.set_param_locked(-1, true);
  LUM_ASSERT_OK(const CellProblem cells, problem(start));
  EXPECT_EQ(cells.free_parts(), (std::vector<int>{1}));
  LUM_ASSERT_OK(CellPoint point, cells.measure(start));
  const double before = renderer_.work().shades;
  GaussNewton descent(cells, std::move(point), renderer_.frame().center);
  LUM_ASSERT_OK([[maybe_unused]] const bool more, descent.iterate());
  const double shades = (renderer_.work().shades - before) / static_cast<double>(level_.cells.samples.pixels.size());
  EXPECT_LE(shades, 15.0 + 6.0);  // 18 degrees of freedom without three colours, at most six trials; one light each
}

TEST_F(GaussNewtonTest, OneBlockTurnsAloneAndTheOthersStay) {
  wanted_.rig.lights.push_back(hidden_light(renderer_, "other", 9));
  target_ = renderer_.target_of(wanted_, renderer_.empty_state());
  level_.cells = CellSampler(renderer_.surface(), target_).cut(600, 1, 1);
  ParamState start = wanted_;
  move_light(start, Vec3(0.06F, -0.04F, 0.04F));
  LUM_ASSERT_OK(const CellProblem cells, problem(start));
  LUM_ASSERT_OK(CellPoint point, cells.measure(start));
  const double cost = point.cost;
  const double before = renderer_.work().shades;
  GaussNewton descent(cells, std::move(point), renderer_.frame().center, {.secants = 0, .block = 1});
  LUM_ASSERT_OK([[maybe_unused]] bool more, descent.iterate());
  const double shades = (renderer_.work().shades - before) / static_cast<double>(level_.cells.samples.pixels.size());
  EXPECT_LE(shades, 15.0 + 6.0);  // as if there were no other light
  while (more) {
    LUM_ASSERT_OK(more, descent.iterate());
  }
  EXPECT_LT(descent.point().cost, 0.2 * cost);
  const int position = position_of(start);
  EXPECT_EQ(descent.point().state.rig.lights[1].params.vec3(position), wanted_.rig.lights[1].params.vec3(position));
}

TEST_F(GaussNewtonTest, SlopesThatFollowTrialsSaveWork) {
  ParamState start = wanted_;
  move_light(start, Vec3(0.12F, -0.08F, 0.08F));
  LUM_ASSERT_OK(const CellProblem cells, problem(start));
  double cost[2] = {};
  double shades[2] = {};
  for (const int secants : {0, 3}) {
    LUM_ASSERT_OK(CellPoint point, cells.measure(start));
    const double goal = 0.05 * point.cost;
    const double before = renderer_.work().shades;
    GaussNewton descent(cells, std::move(point), renderer_.frame().center, {.secants = secants});
    for (bool more = true; more && descent.point().cost > goal;) {
      LUM_ASSERT_OK(more, descent.iterate());
    }
    cost[secants > 0 ? 1 : 0] = descent.point().cost / goal;
    shades[secants > 0 ? 1 : 0] = renderer_.work().shades - before;
  }
  EXPECT_LE(cost[0], 1.0);
  EXPECT_LE(cost[1], 1.0);
  EXPECT_LT(shades[1], shades[0]);
}

TEST_F(GaussNewtonTest, CorrectedSamplesAreExactThereAndOnlyThere) {
  ParamState start = wanted_;
  move_light(start, Vec3(0.3F, -0.1F, 0.2F));
  level_.softness = {0.1F, 0.1F, 0.0F, 1};  // far from the picture
  LUM_ASSERT_OK(CellProblem cells, problem(start));
  LUM_ASSERT_OK(const Image picture, renderer_.render(start, {}));
  std::vector<Vec3> colors;
  for (const std::uint32_t pixel : level_.cells.samples.pixels) colors.push_back(picture.rgb(pixel));
  const CellField shown = level_.cells.average(colors);
  LUM_ASSERT_OK(const CellPoint before, cells.measure_as_is(start));
  EXPECT_GT(std::abs(before.cost - cell_cost(level_.cells, shown, Norm::kUnsquared)), 1e-3);
  cells.correct(before, shown);
  LUM_ASSERT_OK(const CellPoint after, cells.measure_as_is(start));
  EXPECT_NEAR(after.cost, cell_cost(level_.cells, shown, Norm::kUnsquared), 1e-6);  // floats
  cells.correct(after, shown);
  LUM_ASSERT_OK(const CellPoint again, cells.measure_as_is(start));
  EXPECT_NEAR(again.cost, after.cost, 1e-6) << "a second correction at the same state changes nothing";
  LUM_ASSERT_OK(const CellPoint elsewhere, cells.measure_as_is(wanted_));
  EXPECT_GT(elsewhere.cost, 1e-3) << "far away the samples are what they are";
}

TEST_F(GaussNewtonTest, WhatTheRendererSaysOfLightsThatStandStillIsTaken) {
  ParamState start = wanted_;
  start.rig.lights.push_back(hidden_light(renderer_, "still", 9));
  start.rig.lights[1].params.set_param_locked(-1, true);
  LUM_ASSERT_OK(const PictureParts parts, PictureParts::create(renderer_, start, level_.cells.samples));
  const CellField still(level_.cells.target.size(), Vec3(0.25F));
  LUM_ASSERT_OK(const CellProblem cells, CellProblem::create(renderer_, parts, level_, start, Norm::kUnsquared, still));
  light(start).set_vec3(*light(start).schema().by_role("color"), Vec3(0.0F));
  LUM_ASSERT_OK(const CellPoint dark, cells.measure_as_is(start));
  for (const Vec3& color : cells.picture(dark)) ASSERT_EQ(color, Vec3(0.25F));
}

TEST_F(GaussNewtonTest, ALightWhoseShadowEveryoneUsesTouchesEveryone) {
  ParamState start = wanted_;
  start.rig.lights.push_back(hidden_light(renderer_, "other", 9));
  start.rig.shadow_light = "spot";
  LUM_ASSERT_OK(const PictureParts parts, PictureParts::create(renderer_, start, level_.cells.samples));
  const int position = position_of(start);
  const int color = *light(start).schema().by_role("color");
  EXPECT_EQ(parts.touched_by(start, {1, position, 0}), (std::vector<int>{1, 2}));
  EXPECT_EQ(parts.touched_by(start, {1, color, 0}), (std::vector<int>{1}));
  EXPECT_EQ(parts.touched_by(start, {2, position, 0}), (std::vector<int>{2}));
  EXPECT_EQ(parts.color_of({2, color, 1}), 1);
}

class TintedTest : public GaussNewtonTest {
 protected:
  TintedTest() : GaussNewtonTest(FakeStyle::kTinted) {}
};

TEST_F(TintedTest, ColoursThatDoNotScaleAreNotTakenForLinear) {
  LUM_ASSERT_OK(const CellProblem cells, problem(wanted_));
  EXPECT_EQ(cells.parts().list()[1].light_color, -1);
  ParamState start = wanted_;
  light(start).set(*light(start).schema().by_role("color"), 0, 0.2);
  LUM_ASSERT_OK(CellPoint point, cells.measure(start));
  const double before = point.cost;
  GaussNewton descent(cells, std::move(point), renderer_.frame().center);
  for (bool more = true; more;) {
    LUM_ASSERT_OK(more, descent.iterate());
  }
  EXPECT_LT(descent.point().cost, 0.1 * before);
}

}  // namespace
}  // namespace luminist
