#include "verdict/attainable.h"

#include <gtest/gtest.h>

#include "render/metric.h"
#include "solve/fake_renderer.h"
#include "solve/random.h"
#include "support/fixtures.h"
#include "verdict/known_case.h"

namespace luminist {
namespace {

/// Two lights on the spheres, everything locked.
ParamState two_lights(const FakeRenderer& fake, std::uint64_t seed) {
  ParamState state = fake.empty_state();
  state.rig.lights = {hidden_light(fake, "key", seed), hidden_light(fake, "fill", seed + 100)};
  for (Light& light : state.rig.lights) light.params.set_param_locked(-1, true);
  return state;
}

Result<std::optional<AttainableColors>> bound_of(FakeRenderer& fake, const ParamState& state) {
  const Image picture = fake.render(state, {}).value();
  return AttainableColors::create(fake, state, picture);
}

TEST(AttainableColors, NoSettingOfWhatIsFreeGetsBelowTheBound) {
  FakeRenderer fake(48, 36);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    for (const bool all_free : {false, true}) {
      ParamState state = two_lights(fake, seed);
      Light& key = state.rig.lights[0];
      if (all_free) {
        key = fake.cinematic("key");
      } else {
        key.params.set_param_locked(param(key, "color"), false);
      }
      const Target target = fake.target_of(two_lights(fake, seed + 50), state);
      LUM_ASSERT_OK(const auto colors, bound_of(fake, state));
      ASSERT_TRUE(colors);
      const double bound = colors->least_error(target, {});
      const UnitMap map = UnitMap::create(std::as_const(state).blocks(), fake.frame());
      Random random(seed);
      for (int trial = 0; trial < 60; ++trial) {
        std::vector<double> x(static_cast<std::size_t>(map.dofs()));
        for (double& coordinate : x) coordinate = random.uniform();
        map.from_unit(x, state.blocks());
        // Sums of a picture's floats: the bound is exact up to their rounding.
        EXPECT_GE(fake.error(state, target).value(), bound - 1e-6);
      }
    }
  }
}

TEST(AttainableColors, TheBoundIsTightWhereOnlyColoursAreFree) {
  FakeRenderer fake(48, 36);
  ParamState state = two_lights(fake, 3);
  for (Light& light : state.rig.lights) light.params.set_param_locked(param(light, "color"), false);
  ParamState wanted = state;
  wanted.rig.lights[0].params.set_vec3(param(wanted.rig.lights[0], "color"), Vec3(1.5F, 0.3F, 0.9F));
  Target target = fake.target_of(wanted, state);
  LUM_ASSERT_OK(const auto colors, bound_of(fake, state));
  ASSERT_TRUE(colors);
  EXPECT_NEAR(colors->least_error(target, {}), 0.0, 1e-5);
  // A pattern on it that no light makes: the best colours miss about as much as the wanted ones.
  for (std::size_t i = 0; i < target.color.pixels(); ++i) {
    target.color.set_rgb(i, target.color.rgb(i) + Vec3(i % 2 == 0 ? 0.1F : -0.1F));
  }
  const double missed = fake.error(wanted, target).value();
  const double bound = colors->least_error(target, {});
  EXPECT_LE(bound, missed + 1e-6);
  EXPECT_GE(bound, 0.9 * missed);  // reweighting stops near the optimum of the un-squared norm
}

TEST(AttainableColors, WhatFollowsAFreeLightIsFreeToo) {
  FakeRenderer fake(48, 36);
  for (const Constraint& tie : {Constraint{"fill", SameColor{"key"}},
                                Constraint{"fill", MirrorOf{"key", {Vec3(0.0F), Vec3(1.0F, 0.0F, 0.0F)}}}}) {
    ParamState state = two_lights(fake, 4);
    Light& key = state.rig.lights[0];
    key.params.set_param_locked(param(key, "color"), false);
    state.rig.constraints = {tie};
    keep_constraints(state.rig);
    ParamState brighter = state;
    ParamBlock& block = brighter.rig.lights[0].params;
    block.set_vec3(param(key, "color"), 1.5F * block.vec3(param(key, "color")));
    keep_constraints(brighter.rig);
    const Target target = fake.target_of(brighter, state);
    LUM_ASSERT_OK(const auto colors, bound_of(fake, state));
    ASSERT_TRUE(colors);
    EXPECT_LE(colors->least_error(target, {}), 1e-6);  // it can be had; sums of floats
  }
}

TEST(AttainableColors, DarkerThanTheLockedLightsIsCertainlyMissed) {
  FakeRenderer fake(48, 36);
  ParamState state = two_lights(fake, 5);
  state.rig.lights[0] = fake.cinematic("key");
  state.rig.lights[0].params.set_vec3(param(state.rig.lights[0], "color"), Vec3(0.0F));
  Target target = fake.target_of(state, state);
  for (float& value : target.color.data) value *= 0.25F;
  LUM_ASSERT_OK(const auto colors, bound_of(fake, state));
  ASSERT_TRUE(colors);
  EXPECT_NEAR(colors->least_error(target, {}), fake.error(state, target).value(), 1e-6);
}

TEST(AttainableColors, ThereIsNoBoundWithoutAPromiseOfTheStyle) {
  FakeRenderer joint(16, 12, FakeStyle::kToon);
  LUM_ASSERT_OK(const auto of_joint, bound_of(joint, two_lights(joint, 1)));
  EXPECT_FALSE(of_joint);
  FakeRenderer fake(16, 12);
  ParamState state = two_lights(fake, 1);
  state.rig.ambient.set_param_locked(-1, false);
  LUM_ASSERT_OK(const auto of_ambient, bound_of(fake, state));
  EXPECT_FALSE(of_ambient);
  state = two_lights(fake, 1);
  state.rig.shadow_light = "key";
  state.rig.lights[0] = fake.cinematic("key");
  LUM_ASSERT_OK(const auto of_shared, bound_of(fake, state));
  EXPECT_FALSE(of_shared);
}

}  // namespace
}  // namespace luminist
