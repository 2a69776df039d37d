#include "solve/picture_parts.h"

#include <gtest/gtest.h>

#include "solve/fake_renderer.h"
#include "solve/gauss_newton.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

constexpr int kBright = 2;  // of the fake's two tones
constexpr int kShade = 3;

/// One light in a style of two tones, whose colours are free.
class StyleColorsTest : public testing::Test {
 protected:
  explicit StyleColorsTest(FakeStyle style = FakeStyle::kTwoTone)
      : renderer_(96, 96, style), wanted_(renderer_.empty_state()) {
    wanted_.rig.ambient.set_vec3(0, Vec3(0.1F, 0.05F, 0.2F));
    wanted_.rig.lights.push_back(hidden_light(renderer_, "spot", 6));
    wanted_.style.set_vec3(kBright, Vec3(0.8F, 0.6F, 0.4F));
    wanted_.style.set_vec3(kShade, Vec3(0.1F, 0.3F, 0.2F));
    target_ = renderer_.target_of(wanted_, renderer_.empty_state());
    const CellSampler sampler(renderer_.surface(), target_);
    level_ = {sampler.cut(600, 1, 1), {}, 0.004, 0.003, 30};
  }
  Result<CellProblem> problem(const ParamState& start) {
    LUM_TRY(parts_, PictureParts::create(renderer_, start, level_.cells.samples));
    return CellProblem::create(renderer_, parts_, level_, start, Norm::kUnsquared);
  }
  [[nodiscard]] ParamState with_other_colors() const {
    ParamState start = wanted_;
    start.style.set_vec3(kBright, Vec3(1.5F, 0.1F, 1.0F));
    start.style.set_vec3(kShade, Vec3(0.9F, 0.9F, 0.0F));
    return start;
  }

  FakeRenderer renderer_;
  ParamState wanted_;
  Target target_;
  Level level_;
  PictureParts parts_;
};

TEST_F(StyleColorsTest, ALightFallsIntoARestAndAPartForEachColour) {
  LUM_ASSERT_OK(const PictureParts parts, PictureParts::create(renderer_, wanted_, level_.cells.samples));
  ASSERT_EQ(parts.list().size(), 6U);  // what is left without lights, and the light
  EXPECT_EQ(parts.list()[3].style_color, -1);
  EXPECT_EQ(parts.list()[4].style_color, kBright);
  EXPECT_EQ(parts.list()[5].style_color, kShade);
  for (int part = 3; part < 6; ++part) EXPECT_EQ(parts.list()[static_cast<std::size_t>(part)].rest, 3);
  EXPECT_EQ(parts.touched_by(wanted_, {1, 0, 0}), (std::vector<int>{3, 4, 5}));
}

TEST_F(StyleColorsTest, LockedColoursOfTheStyleAreNoParts) {
  wanted_.style.set_param_locked(-1, true);
  LUM_ASSERT_OK(const PictureParts parts, PictureParts::create(renderer_, wanted_, level_.cells.samples));
  EXPECT_EQ(parts.list().size(), 2U);
}

TEST_F(StyleColorsTest, PartsAddUpToThePicture) {
  LUM_ASSERT_OK(const CellProblem cells, problem(wanted_));
  LUM_ASSERT_OK(const CellPoint point, cells.measure_as_is(wanted_));
  EXPECT_LT(point.cost, 1e-5);  // of a picture of brightness 1: floats
}

TEST_F(StyleColorsTest, AreFoundByMeasuringOnceIfTheLightsAreLocked) {
  ParamState start = with_other_colors();
  start.rig.lights[0].params.set_param_locked(-1, true);
  LUM_ASSERT_OK(const CellProblem cells, problem(start));
  LUM_ASSERT_OK(const CellPoint point, cells.measure(start));
  EXPECT_LT(glm::distance(point.state.style.vec3(kBright), wanted_.style.vec3(kBright)), 2e-3F);  // a ridge, floats
  EXPECT_LT(glm::distance(point.state.style.vec3(kShade), wanted_.style.vec3(kShade)), 2e-3F);
}

TEST_F(StyleColorsTest, AreFoundTogetherWithTheColourOfALight) {
  ParamState start = with_other_colors();
  Light& light = start.rig.lights[0];
  light.params.set_vec3(*light.params.schema().by_role("color"), Vec3(0.2F, 2.0F, 0.4F));
  LUM_ASSERT_OK(const CellProblem cells, problem(start));
  LUM_ASSERT_OK(const CellPoint before, cells.measure_as_is(start));
  LUM_ASSERT_OK(const CellPoint point, cells.measure(start));
  EXPECT_LT(point.cost, 0.05 * before.cost);  // a few turns of each kind; only their product counts
}

TEST_F(StyleColorsTest, ADescentFindsALightThatWasMovedAndTheColours) {
  ParamState start = with_other_colors();
  ParamBlock& light = start.rig.lights[0].params;
  const int position = *light.schema().by_role("position");
  light.set_vec3(position, light.vec3(position) + Vec3(0.06F, -0.04F, 0.04F));
  LUM_ASSERT_OK(const CellProblem cells, problem(start));
  LUM_ASSERT_OK(CellPoint point, cells.measure(start));
  const double before = point.cost;
  GaussNewton descent(cells, std::move(point), renderer_.frame().center);
  for (bool more = true; more;) {
    LUM_ASSERT_OK(more, descent.iterate());
  }
  EXPECT_LT(descent.point().cost, 0.2 * before);
}

class GlowingTest : public StyleColorsTest {
 protected:
  GlowingTest() : StyleColorsTest(FakeStyle::kGlowing) {}
};

TEST_F(GlowingTest, OnlyColoursThatScaleArePartsOfThePicture) {
  LUM_ASSERT_OK(const PictureParts parts, PictureParts::create(renderer_, wanted_, level_.cells.samples));
  ASSERT_EQ(parts.list().size(), 4U);
  EXPECT_EQ(parts.list()[3].style_color, kShade);
  EXPECT_EQ(parts.color_of({2, kBright, 0}), -1);
  EXPECT_GE(parts.color_of({2, kShade, 0}), 0);
}

}  // namespace
}  // namespace luminist
