#include "bench/perturbation.h"

#include <gtest/gtest.h>

#include "bench/crowd.h"
#include "bench/method.h"
#include "bench/nlopt_solver.h"
#include "solve/fake_renderer.h"
#include "solve/objective.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

/// One light in front of the spheres with position and colour free.
ParamState original(const FakeRenderer& renderer) {
  ParamState state = renderer.empty_state();
  Light light = renderer.cinematic("key");
  light.params.set_param_locked(-1, true);
  const std::vector<std::string_view> roles{"position", "color"};
  unlock_roles(light, roles);
  state.rig.lights.push_back(std::move(light));
  return state;
}

TEST(Perturbation, RolesNameWhatIsFree) {
  const FakeRenderer renderer(16, 12);
  const std::vector<std::string> names = free_names(original(renderer), renderer.frame());
  ASSERT_EQ(names.size(), 6U);
  EXPECT_EQ(names.front(), "lights/key/position.x");
}

TEST(Perturbation, EveryDegreeOfFreedomMovesByItsShareAndStaysInItsRange) {
  const FakeRenderer renderer(16, 12);
  const ParamState state = original(renderer);
  const std::vector<const ParamBlock*> blocks = state.blocks();
  const UnitMap map = UnitMap::create(blocks, renderer.frame());
  const std::vector<double> home = map.to_unit(blocks);
  std::vector<UnitRange> ranges;
  for (const double x : home) ranges.push_back({std::max(0.0, x - 0.1), std::min(1.0, x + 0.3)});
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const ParamState moved = perturbed(state, renderer.frame(), ranges, {}, random);
    const std::vector<const ParamBlock*> moved_blocks = moved.blocks();
    const std::vector<double> x = map.to_unit(moved_blocks);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double width = ranges[k].high - ranges[k].low;
      constexpr double kFloat = 1e-6;  // values are stored as floats
      EXPECT_GE(x[k], ranges[k].low - kFloat);
      EXPECT_LE(x[k], ranges[k].high + kFloat);
      EXPECT_GE(std::abs(x[k] - home[k]), 0.1 * width - kFloat);
      EXPECT_LE(std::abs(x[k] - home[k]), 0.5 * width + kFloat);
    }
  }
}

TEST(Perturbation, TheSameSeedMovesLightsAlike) {
  const FakeRenderer renderer(16, 12);
  const ParamState state = original(renderer);
  const std::vector<UnitRange> ranges(6);
  Random one(7);
  Random same(7);
  Random other(8);
  const ParamState a = perturbed(state, renderer.frame(), ranges, {}, one);
  const ParamState b = perturbed(state, renderer.frame(), ranges, {}, same);
  const ParamState c = perturbed(state, renderer.frame(), ranges, {}, other);
  EXPECT_TRUE(a.rig.lights[0].params.same_values(b.rig.lights[0].params));
  EXPECT_FALSE(a.rig.lights[0].params.same_values(c.rig.lights[0].params));
}

TEST(Perturbation, AtTheEndOfAUsefulRangeHalfOfTheLightsWorkIsUndone) {
  FakeRenderer renderer(48, 36);
  const ParamState state = original(renderer);
  LUM_ASSERT_OK(const std::vector<UnitRange> ranges, useful_ranges(renderer, state));
  const Target target = renderer.target_of(state, state);
  ParamState without = state;
  without.rig.lights[0].muted = true;
  LUM_ASSERT_OK(const double loss, renderer.error(without, target));
  Objective objective(renderer, state, target);
  const std::vector<double> home = objective.unit(state);
  ASSERT_EQ(ranges.size(), home.size());
  int inner = 0;
  for (std::size_t k = 0; k < home.size(); ++k) {
    for (const double end : {ranges[k].low, ranges[k].high}) {
      std::vector<double> x = home;
      x[k] = end;
      LUM_ASSERT_OK(const double epsilon, objective.evaluate(x));
      EXPECT_LE(epsilon, 0.5 * loss * (1.0 + 1e-5));  // floats on the way through the state
      inner += end > 0.0 && end < 1.0 ? 1 : 0;
    }
  }
  EXPECT_GT(inner, 0) << "some ends are the light's, not the manifest's";
}

TEST(Methods, EveryMethodFindsAColorAgainAndCountsItsPictures) {
  FakeRenderer renderer(24, 18);
  ParamState wanted = original(renderer);
  wanted.rig.lights[0].params.set_param_locked(-1, true);
  const std::vector<std::string_view> color{"color"};
  unlock_roles(wanted.rig.lights[0], color);
  BenchTask task{wanted, renderer.target_of(wanted, wanted)};
  Random random(3);
  task.start = perturbed(wanted, renderer.frame(), std::vector<UnitRange>(3), {}, random);
  LUM_ASSERT_OK(const double epsilon, renderer.error(task.start, task.target));
  task.goal = 0.05 * epsilon;
  for (const Method method : {Method::kFast, Method::kSimplex, Method::kNloptNelderMead, Method::kNloptBobyqa}) {
    LUM_ASSERT_OK(const BenchRun run, run_method(renderer, task, method, {}, 1));
    EXPECT_TRUE(run.success) << to_word(method);
    EXPECT_GT(run.equivalents, 0.0) << to_word(method);
    EXPECT_EQ(run.dofs, 3);
    if (method != Method::kFast) {
      EXPECT_NEAR(run.equivalents, run.evals, 1e-6) << to_word(method) << " does nothing but compare pictures";
    }
  }
}

TEST(Methods, ACappedRunSaysSo) {
  FakeRenderer renderer(24, 18);
  const ParamState wanted = original(renderer);
  BenchTask task{wanted, renderer.target_of(wanted, wanted)};
  Random random(3);
  task.start = perturbed(wanted, renderer.frame(), std::vector<UnitRange>(6), {}, random);
  task.goal = 1e-9;
  for (const Method method : {Method::kSimplex, Method::kNloptNelderMead, Method::kNloptBobyqa}) {
    LUM_ASSERT_OK(const BenchRun run, run_method(renderer, task, method, {20, 200.0}, 1));
    EXPECT_TRUE(run.capped) << to_word(method);
    EXPECT_FALSE(run.success) << to_word(method);
    EXPECT_EQ(run.evals, 20) << to_word(method);
  }
}

TEST(Crowd, LightsAreRepeatedUnderNamesOfTheirOwn) {
  const FakeRenderer renderer(16, 12);
  const ParamState state = crowded(original(renderer), renderer.frame(), 5);
  ASSERT_EQ(state.rig.lights.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(state.rig.lights[i].name, state.rig.lights[j].name);
  }
  EXPECT_EQ(free_dofs(state, renderer.frame()), 30);
}

}  // namespace
}  // namespace luminist
