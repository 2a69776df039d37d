#include "solve/exploration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "solve/fake_renderer.h"
#include "solve/light_variants.h"
#include "solve/sample_simplex.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

/// Two hidden lights on the fake scene; the cells are of their picture.
class ExplorationTest : public testing::Test {
 protected:
  ExplorationTest() : renderer_(96, 96), wanted_(renderer_.empty_state()) {
    wanted_.rig.lights.push_back(hidden_light(renderer_, "a", 6));
    wanted_.rig.lights.push_back(hidden_light(renderer_, "b", 21));
    target_ = renderer_.target_of(wanted_, renderer_.empty_state());
    level_ = {CellSampler(renderer_.surface(), target_).cut(160, 1, 1), {}, 0.004, 0.003, 12};
  }
  Result<CellProblem> problem(const ParamState& free) {
    LUM_TRY(parts_, PictureParts::create(renderer_, free, level_.cells.samples));
    return CellProblem::create(renderer_, parts_, level_, free, Norm::kUnsquared);
  }
  ParamState moved(int light, const Vec3& by) const {
    ParamState state = wanted_;
    ParamBlock& params = state.rig.lights[static_cast<std::size_t>(light)].params;
    const int position = *params.schema().by_role("position");
    params.set_vec3(position, params.vec3(position) + by);
    return state;
  }
  static Result<std::vector<FastFind>> all_of(Exploration& exploration, std::size_t count) {
    Random random(1);
    for (bool more = true; more;) {
      LUM_TRY(more, exploration.step(random));
    }
    return exploration.take(count);
  }

  FakeRenderer renderer_;
  ParamState wanted_;
  Target target_;
  Level level_;
  PictureParts parts_;
};

TEST_F(ExplorationTest, FindsBetterPlacesForALightThatWasMovedAndFairlyForBoth) {
  const ParamState start = moved(0, Vec3(0.8F, 0.3F, -0.5F));
  LUM_ASSERT_OK(const CellProblem cells, problem(start));
  LUM_ASSERT_OK(const CellPoint home, cells.measure(start));
  Exploration exploration(cells, start, start, {1, 2}, renderer_.frame().center, false);
  LUM_ASSERT_OK(const std::vector<FastFind> finds, all_of(exploration, 12));
  ASSERT_FALSE(finds.empty());
  EXPECT_LE(finds.size(), 12U);
  EXPECT_LT(finds.front().point.cost, home.cost);
  std::map<int, std::size_t> of;
  for (const FastFind& find : finds) ++of[find.block];
  for (const auto& [block, count] : of)
    EXPECT_LE(count, 6U) << "block " << block;  // two blocks or more share 12 places
  EXPECT_TRUE(exploration.take(12).empty()) << "taken once";
}

TEST_F(ExplorationTest, LightsInEachOthersPlaceAreExchanged) {
  // What is locked stays with its light, so the exchanged rig makes another picture.
  for (Light& light : wanted_.rig.lights) light.params.set_param_locked(*light.params.schema().by_role("shape"), true);
  std::vector<ParamState> exchanged = light_exchange(wanted_, 1, 2);
  ASSERT_EQ(exchanged.size(), 1U);
  LUM_ASSERT_OK(const CellProblem cells, problem(exchanged.front()));
  LUM_ASSERT_OK(const CellPoint home, cells.measure(exchanged.front()));
  const ParamState start = moved(0, Vec3(0.5F));
  Exploration exploration(cells, exchanged.front(), start, {1, 2}, renderer_.frame().center, false);
  LUM_ASSERT_OK(const std::vector<FastFind> finds, all_of(exploration, 8));
  ASSERT_FALSE(finds.empty());
  EXPECT_EQ(finds.front().block, -1);
  EXPECT_LT(finds.front().point.cost, 1e-3 * home.cost);  // the hidden lights themselves, up to floats
}

TEST_F(ExplorationTest, LockedLightsExchangeNothing) {
  wanted_.rig.lights[1].params.set_param_locked(-1, true);
  EXPECT_TRUE(light_exchange(wanted_, 1, 2).empty());
}

TEST_F(ExplorationTest, WhatIsKnownIsNotMeasuredAgain) {
  LUM_ASSERT_OK(const CellProblem cells, problem(wanted_));
  double shades[2] = {};
  for (const bool known : {false, true}) {
    const double before = renderer_.work().shades;
    Exploration exploration(cells, wanted_, moved(1, Vec3(0.4F)), {1, 2}, renderer_.frame().center, known);
    LUM_ASSERT_OK([[maybe_unused]] const std::vector<FastFind> finds, all_of(exploration, 4));
    shades[known ? 1 : 0] = renderer_.work().shades - before;
  }
  EXPECT_LT(shades[1], 0.7 * shades[0]);  // scans are about as many as random variants or more
}

TEST_F(ExplorationTest, AScanMovesOneEdgeOfALightAndKeepsTheOther) {
  const ParamBlock& before = wanted_.rig.lights[0].params;
  const int shape = *before.schema().by_role("shape");
  const int direction = *before.schema().by_role("direction");
  int kept = 0;
  for (const auto& scan : light_scans(wanted_, wanted_, 1, renderer_.frame())) {
    for (const ParamState& variant : scan) {
      const ParamBlock& after = variant.rig.lights[0].params;
      const double half = before.get(shape, 0);
      const double left = after.get(shape, 0);
      const float cosine = glm::dot(glm::normalize(before.vec3(direction)), glm::normalize(after.vec3(direction)));
      const double turn = std::acos(std::min(1.0F, cosine));
      if (left == half || turn < 1e-3) continue;
      // Edges are at the turn plus or minus the angle of a half size: one of them is where it was.
      if (std::abs(std::abs(std::atan(half) - std::atan(left)) - turn) < 1e-3) ++kept;
    }
  }
  EXPECT_GE(kept, 8 * 8);  // eight ways, eight widths
}

TEST_F(ExplorationTest, TheSimplexTurnsOneLightAndNeverEndsAboveItsStart) {
  const ParamState start = moved(0, Vec3(0.4F, 0.0F, 0.0F));
  LUM_ASSERT_OK(const CellProblem cells, problem(start));
  LUM_ASSERT_OK(const CellPoint home, cells.measure(start));
  auto simplex = SampleSimplex::create(cells, home, 1, renderer_.frame().center, 0.1);
  ASSERT_NE(simplex, nullptr);
  int slices = 0;
  for (bool more = true; more; ++slices) {
    ASSERT_LT(slices, 100) << "the walk ends";
    LUM_ASSERT_OK(more, simplex->walk(25));
  }
  EXPECT_LT(simplex->best().cost, home.cost);
  const ParamBlock& other = simplex->best().state.rig.lights[1].params;
  const int position = *other.schema().by_role("position");
  EXPECT_EQ(other.vec3(position), wanted_.rig.lights[1].params.vec3(position));
}

TEST_F(ExplorationTest, ThereIsNoSimplexOverColoursAlone) {
  ParamBlock& params = wanted_.rig.lights[0].params;
  params.set_param_locked(-1, true);
  params.set_param_locked(*params.schema().by_role("color"), false);
  LUM_ASSERT_OK(const CellProblem cells, problem(wanted_));
  LUM_ASSERT_OK(const CellPoint home, cells.measure(wanted_));
  EXPECT_EQ(SampleSimplex::create(cells, home, 1, renderer_.frame().center, 0.1), nullptr);
}

}  // namespace
}  // namespace luminist
