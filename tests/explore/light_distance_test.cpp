#include "explore/light_distance.h"

#include <gtest/gtest.h>

#include "explore/locks.h"
#include "solve/fake_renderer.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

const Vec3 kFocus(0.0F, 0.5F, 0.0F);

int role(const Light& light, const char* name) {
  return *light.params.schema().by_role(name);
}

/// A light at a place that looks at the focus.
Light light_at(const FakeRenderer& renderer, const std::string& name, const Vec3& place) {
  Light light = renderer.cinematic(name);
  light.params.set_vec3(role(light, "position"), place);
  light.params.set_vec3(role(light, "direction"), glm::normalize(kFocus - place));
  return light;
}

std::vector<LightLook> look(FakeRenderer& renderer, const ParamState& state) {
  auto looks = LightEye(renderer, kFocus).look(state);
  EXPECT_TRUE(looks.has_value());
  return looks ? *looks : std::vector<LightLook>{};
}

class LightDistanceTest : public testing::TestWithParam<FakeStyle> {
 protected:
  LightDistanceTest() : renderer_(48, 36, GetParam()), state_(renderer_.empty_state()) {
    state_.rig.lights.push_back(light_at(renderer_, "left", Vec3(-3.0F, 3.0F, 2.0F)));
    state_.rig.lights.push_back(light_at(renderer_, "right", Vec3(3.0F, 2.0F, 2.0F)));
  }
  double to(const ParamState& other) { return look_distance(look(renderer_, state_), look(renderer_, other)); }

  FakeRenderer renderer_;
  ParamState state_;
};

TEST_P(LightDistanceTest, IsZeroBetweenEqualLightsAlsoIfTheyChangedRoles) {
  ParamState swapped = state_;
  std::swap(swapped.rig.lights[0].params, swapped.rig.lights[1].params);
  EXPECT_EQ(to(state_), 0.0);
  EXPECT_NEAR(to(swapped), 0.0, 1e-6);  // floats of another summation order
}

TEST_P(LightDistanceTest, GrowsWithTheAngleBetweenPlaces) {
  ParamState near = state_;
  near.rig.lights[0].params = light_at(renderer_, "other", Vec3(-3.0F, 3.0F, 2.6F)).params;
  ParamState far = state_;
  far.rig.lights[0].params = light_at(renderer_, "other", Vec3(-1.0F, 4.0F, 3.0F)).params;
  EXPECT_GT(to(near), 0.0);
  EXPECT_GT(to(far), 2.0 * to(near));
}

TEST_P(LightDistanceTest, AParameterThatDoesNotShowDoesNotCount) {
  ParamState other = state_;
  for (Light& light : other.rig.lights) light.params.set(role(light, "cutoff"), 0, 0.05);  // nearer than anything
  EXPECT_NEAR(to(other), 0.0, 1e-6);
  other.rig.lights[0].params.set_vec3(role(other.rig.lights[0], "color"), Vec3(0.2F, 0.5F, 1.0F));
  EXPECT_GT(to(other), 0.1);
}

TEST_P(LightDistanceTest, LooksAtFreeLightsOnly) {
  ParamState half = state_;
  half.rig.lights[0].params.set_param_locked(-1, true);
  EXPECT_EQ(look(renderer_, half).size(), 1U);
  half.rig.lights[1].muted = true;
  EXPECT_TRUE(look(renderer_, half).empty());
  EXPECT_EQ(look_distance(look(renderer_, half), look(renderer_, half)), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Styles, LightDistanceTest, testing::Values(FakeStyle::kMatte, FakeStyle::kToon),
                         [](const auto& each) { return each.param == FakeStyle::kMatte ? "Sum" : "Joint"; });

TEST(LightPlaceTest, AMovedLightKeepsItsAimAndItsFootprint) {
  const FakeRenderer renderer(8, 6);
  Light light = light_at(renderer, "key", Vec3(0.0F, 0.5F, 4.0F));
  const double width = light.params.get(role(light, "shape"), 0);
  move_light(light, Vec3(2.0F, 0.5F, 0.0F), kFocus, renderer.frame());
  const Vec3 aim = aim_point(light, renderer.frame(), kFocus);
  EXPECT_NEAR(glm::distance(aim, kFocus), 0.0F, 1e-5F);
  EXPECT_NEAR(light.params.get(role(light, "shape"), 0), 2.0 * width, 1e-5);  // half as far, twice the tangent
}

TEST(LightPlaceTest, TwiceAsFarAwayIsLessThanAnotherSide) {
  const FakeRenderer renderer(8, 6);
  const auto at = [&](const Vec3& place) { return light_place(light_at(renderer, "other", place), kFocus); };
  const auto home = at(kFocus + Vec3(0.0F, 0.0F, 2.0F));
  EXPECT_NEAR(place_difference(home, at(kFocus + Vec3(0.0F, 0.0F, 4.0F))), 0.125, 1e-6);  // one octave
  EXPECT_NEAR(place_difference(home, at(kFocus + Vec3(0.0F, 2.0F, 0.0F))), std::sqrt(0.5), 1e-6);
  EXPECT_EQ(place_difference(home, std::nullopt), 1.0);
}

}  // namespace
}  // namespace luminist
