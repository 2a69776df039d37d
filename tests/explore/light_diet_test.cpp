#include "explore/light_diet.h"

#include <gtest/gtest.h>

#include "explore/locks.h"
#include "render/metric.h"
#include "solve/fake_renderer.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

Light light_at(const FakeRenderer& renderer, const std::string& name, const Vec3& place, const Vec3& color) {
  Light light = renderer.cinematic(name);
  const ParamSchema& schema = light.params.schema();
  light.params.set_param_locked(-1, true);
  light.params.set_param_locked(*schema.by_role("color"), false);
  light.params.set_vec3(*schema.by_role("position"), place);
  light.params.set_vec3(*schema.by_role("direction"), glm::normalize(Vec3(0.0F, 0.5F, 0.0F) - place));
  light.params.set_vec3(*schema.by_role("color"), color);
  return light;
}

/// Two lights at one place, which can do each other's work, a strong one elsewhere and one that shows nothing.
class DietTest : public testing::Test {
 protected:
  DietTest() : renderer_(48, 36), state_(renderer_.empty_state()) {
    const Vec3 left(-2.5F, 3.0F, 2.0F);
    state_.rig.lights = {light_at(renderer_, "key", Vec3(3.0F, 3.0F, 2.0F), Vec3(0.9F)),
                         light_at(renderer_, "twin", left, Vec3(0.3F, 0.2F, 0.1F)),
                         light_at(renderer_, "other_twin", left, Vec3(0.1F, 0.2F, 0.3F)),
                         light_at(renderer_, "dark", Vec3(0.0F, 4.0F, 1.0F), Vec3(0.0F))};
  }
  Result<Diet> diet(const DietOptions& options = {}, const ExploreWatch& watch = {}) {
    return light_diet(renderer_, state_, options, watch);
  }
  double epsilon_of(const DietStep& step, const Diet& diet) {
    const auto picture = renderer_.render(step.state, {});
    return picture_error(*picture, diet.target, renderer_.style().metric);
  }

  FakeRenderer renderer_;
  ParamState state_;
};

TEST_F(DietTest, WhatDoesNotShowGoesFirstAndTwinsBecomeOne) {
  LUM_ASSERT_OK(const Diet found, diet());
  ASSERT_EQ(found.steps.size(), 4U);
  EXPECT_EQ(found.steps[0].removed, "");
  EXPECT_EQ(found.steps[1].removed, "dark");
  EXPECT_EQ(found.steps[1].epsilon, 0.0);
  EXPECT_NE(found.steps[2].removed.find("twin"), std::string::npos);
  EXPECT_GT(found.steps[2].epsilon_removed, 0.05 * found.black);
  EXPECT_LT(found.steps[2].epsilon, 0.001 * found.black);  // one lamp with the sum of their colours
  EXPECT_GT(found.steps[3].epsilon, 0.05 * found.black);
  EXPECT_EQ(found.chosen, 2U);
  for (const DietStep& step : found.steps) EXPECT_NEAR(step.epsilon, epsilon_of(step, found), 1e-9);
}

TEST_F(DietTest, NamesAndLocksAreKept) {
  LUM_ASSERT_OK(const Diet found, diet());
  for (const DietStep& step : found.steps) {
    for (const Light& light : step.state.rig.lights) {
      const Light* before = state_.rig.find(light.name);
      ASSERT_NE(before, nullptr);
      for (int dof = 0; dof < light.params.schema().dofs(); ++dof) {
        EXPECT_EQ(light.params.locked(dof), before->params.locked(dof));
      }
    }
  }
}

TEST_F(DietTest, TheFrontLeavesOutWhatFewerLightsDoAsWell) {
  LUM_ASSERT_OK(const Diet found, diet());
  EXPECT_FALSE(found.steps[0].on_front);  // three lights make the same picture to the bit
  EXPECT_TRUE(found.steps.back().on_front);
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = found.steps.size(); i-- > 0;) {
    EXPECT_EQ(found.steps[i].on_front, found.steps[i].epsilon < lowest);
    lowest = std::min(lowest, found.steps[i].epsilon);
  }
}

TEST_F(DietTest, ABudgetIsAShareOrAnEpsilon) {
  DietOptions options;
  options.budget = {0.0, false};
  LUM_ASSERT_OK(const Diet none, diet(options));
  EXPECT_EQ(none.chosen, 1U);  // the dark light costs nothing
  options.budget = {1.0, true};
  LUM_ASSERT_OK(const Diet all, diet(options));
  EXPECT_EQ(all.chosen, 3U);
  EXPECT_DOUBLE_EQ(all.budget, all.black);
}

TEST_F(DietTest, GoesDownToTheFewestAndStopsWhenTold) {
  DietOptions options;
  options.fewest = 3;
  LUM_ASSERT_OK(const Diet some, diet(options));
  EXPECT_EQ(some.steps.size(), 2U);
  LUM_ASSERT_OK(const Diet stopped, diet({}, [](const ExploreProgress& progress) { return progress.done < 2; }));
  EXPECT_TRUE(stopped.stopped);
  EXPECT_GE(stopped.steps.size(), 2U);
  EXPECT_LT(stopped.steps.size(), 4U);
}

TEST_F(DietTest, OneLightCannotBecomeFewer) {
  state_.rig.lights.resize(1, state_.rig.lights[0]);
  EXPECT_EQ(error_of(diet()).kind, ErrorKind::kNothingToDo);
}

TEST_F(DietTest, ARemovalAsksForThePictureWithTheLight) {
  state_.rig.shadow_light = "twin";
  LUM_ASSERT_OK(const RemovalTask task, removal_task(renderer_, state_, "twin"));
  EXPECT_EQ(task.start.rig.find("twin"), nullptr);
  EXPECT_EQ(task.start.rig.shadow_light, "");
  EXPECT_GT(task.facts.epsilon, 0.0);
  LUM_ASSERT_OK(const Image before, renderer_.render(state_, {}));
  EXPECT_EQ(task.target.color.data, before.data);
  for (const float importance : task.target.importance.data) EXPECT_EQ(importance, 1.0F);
  EXPECT_EQ(error_of(removal_task(renderer_, state_, "dork")).hint, "did you mean \"dark\"?");
}

TEST_F(DietTest, ALightWithoutShadowsHasNoShadowShare) {
  LUM_ASSERT_OK(const RemovalTask shadows, removal_task(renderer_, state_, "key"));
  EXPECT_GT(shadows.facts.shadow_share, 0.02);
  Light& key = state_.rig.lights[0];
  key.params.set(*key.params.schema().by_role("shadow"), 0, 0.0);
  LUM_ASSERT_OK(const RemovalTask none, removal_task(renderer_, state_, "key"));
  EXPECT_NEAR(none.facts.shadow_share, 0.0, 1e-6);
}

TEST_F(DietTest, WhatWasLockedOnPurposeStaysLocked) {
  for (Light& light : state_.rig.lights) light.params.set_param_locked(-1, true);
  EXPECT_EQ(error_of(removal_task(renderer_, state_, "key", MakeUp::kUnlocked)).kind, ErrorKind::kNothingToDo);
  DietOptions as_locked;
  as_locked.who = MakeUp::kUnlocked;
  LUM_ASSERT_OK(const Diet diet, light_diet(renderer_, state_, as_locked, {}));
  for (const DietStep& step : diet.steps) {
    for (const Light& light : step.state.rig.lights) {
      EXPECT_TRUE(light.params.same_values(state_.rig.find(light.name)->params)) << light.name;
    }
  }
}

TEST_F(DietTest, WhereEverythingIsLockedTheTypesSayWhatMakesUp) {
  for (Light& light : state_.rig.lights) light.params.set_param_locked(-1, true);
  const ParamState freed = with_free_lights(state_, MakeUp::kUnlockedOrByType);
  for (const Light& light : freed.rig.lights) {
    for (const ParamSpec& spec : light.params.schema().specs()) {
      for (int k = 0; k < spec.dofs(); ++k) EXPECT_EQ(light.params.locked(spec.first_dof + k), !spec.solve);
    }
  }
}

}  // namespace
}  // namespace luminist
