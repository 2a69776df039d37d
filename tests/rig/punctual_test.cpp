#include <gtest/gtest.h>

#include "rig/light_rig.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

class PunctualTest : public ::testing::Test {
 protected:
  PunctualTest() {
    auto types = LightTypes::load(AssetRoots::standard());
    EXPECT_TRUE(types) << (types ? "" : types.error().message());
    types_ = *types;
  }
  std::vector<Light> converted(const std::vector<PunctualLight>& lights) const {
    auto made = from_punctual(lights, types_, frame_);
    EXPECT_TRUE(made) << (made ? "" : made.error().message());
    return *made;
  }
  static Vec3 vec3(const Light& light, const char* name) {
    return light.params.vec3(*light.params.schema().find(name));
  }
  static float number(const Light& light, const char* name) {
    return light.params.scalar(*light.params.schema().find(name));
  }
  /// Radiance of a white diffuser that faces the light at a distance, as the light's GLSL has it.
  static float radiance(const Light& light, float distance) {
    const float ratio = distance / number(light, "falloff_distance");
    return vec3(light, "color").x * std::pow(2.0F / (1.0F + ratio * ratio), 0.5F * number(light, "falloff_exponent"));
  }

  LightTypes types_;
  SceneFrame frame_{Vec3(0.0F, 1.0F, 0.0F), 2.0F};
};

TEST_F(PunctualTest, ASpotShowsItsPhysicalRadianceAtTheCentreOfTheScene) {
  PunctualLight spot;
  spot.kind = PunctualLight::Kind::kSpot;
  spot.name = "key";
  spot.position = Vec3(0.0F, 1.0F, 5.0F);
  spot.direction = Vec3(0.0F, 0.0F, -2.0F);
  spot.intensity = 100.0F;
  spot.color = Vec3(1.0F, 0.5F, 0.25F);
  spot.inner_angle = 0.3F;
  spot.outer_angle = 0.5F;
  const Light light = converted({spot})[0];
  EXPECT_EQ(light.type, "cinematic");
  EXPECT_EQ(light.name, "key");
  EXPECT_EQ(vec3(light, "position"), spot.position);
  EXPECT_EQ(vec3(light, "direction"), Vec3(0.0F, 0.0F, -1.0F));
  const float expected = 100.0F / (kPiF * 25.0F);  // I / (pi d^2), d = 5
  EXPECT_FLOAT_EQ(radiance(light, 5.0F), expected);
  EXPECT_FLOAT_EQ(vec3(light, "color").y, 0.5F * expected);
  // Full inside the inner angle, dark outside the outer one.
  EXPECT_FLOAT_EQ(vec3(light, "barn").x, std::tan(0.3F));
  EXPECT_FLOAT_EQ(vec3(light, "barn").y, std::tan(0.3F));
  EXPECT_FLOAT_EQ(vec3(light, "barn").x + vec3(light, "barn").z, std::tan(0.5F));
}

TEST_F(PunctualTest, APointFallsOffWithTheSquareOfTheDistance) {
  PunctualLight point;
  point.position = Vec3(3.0F, 1.0F, 0.0F);
  point.intensity = 10.0F;
  const Light light = converted({point})[0];
  EXPECT_EQ(light.type, "point");
  EXPECT_EQ(number(light, "falloff_exponent"), 2.0F);
  EXPECT_FLOAT_EQ(radiance(light, 3.0F), 10.0F / (kPiF * 9.0F));
  EXPECT_NEAR(radiance(light, 300.0F) / radiance(light, 600.0F), 4.0F, 1e-3F);  // the law of the far field
}

TEST_F(PunctualTest, ALightInTheCentreOfTheSceneStaysFinite) {
  PunctualLight point;
  point.position = frame_.center;
  const Light light = converted({point})[0];
  EXPECT_FLOAT_EQ(number(light, "falloff_distance"), 0.2F);  // a tenth of the radius
  EXPECT_TRUE(is_finite(vec3(light, "color")));
}

TEST_F(PunctualTest, ARangeBecomesTheFarCutoffAndNoRangeReachesThroughTheScene) {
  PunctualLight point;
  point.position = Vec3(100.0F, 1.0F, 0.0F);
  Light light = converted({point})[0];
  const int cutoff = *light.params.schema().find("far_cutoff");
  EXPECT_FLOAT_EQ(light.params.vec2(cutoff).x, 104.0F);  // distance and a diameter
  point.range = 10.0F;
  light = converted({point})[0];
  EXPECT_FLOAT_EQ(light.params.vec2(cutoff).x + light.params.vec2(cutoff).y, 10.0F);
}

TEST_F(PunctualTest, ASunShinesItsWayAsStrongEverywhere) {
  PunctualLight sun;
  sun.kind = PunctualLight::Kind::kSun;
  sun.direction = glm::normalize(Vec3(1.0F, -2.0F, 0.5F));
  sun.intensity = 3.0F;
  sun.color = Vec3(1.0F, 0.5F, 0.25F);
  const Light light = converted({sun})[0];
  EXPECT_EQ(light.type, "sun");
  EXPECT_EQ(vec3(light, "direction"), sun.direction);
  EXPECT_FLOAT_EQ(vec3(light, "color").y, 1.5F / kPiF);
}

TEST_F(PunctualTest, NamesAreUniqueAndUsableInPaths) {
  PunctualLight point;
  PunctualLight sun;
  sun.kind = PunctualLight::Kind::kSun;
  PunctualLight odd;
  odd.name = "Light/01:*=\n";
  const std::vector<Light> lights = converted({point, point, sun, odd});
  EXPECT_EQ(lights[0].name, "point");
  EXPECT_EQ(lights[1].name, "point-2");
  EXPECT_EQ(lights[2].name, "sun");
  EXPECT_EQ(lights[3].name, "Light_01____");
}

TEST_F(PunctualTest, AHalfSphereAndAZeroDirectionMakeAUsableLight) {
  PunctualLight spot;
  spot.kind = PunctualLight::Kind::kSpot;
  spot.outer_angle = kPiF / 2.0F;
  spot.direction = Vec3(0.0F);
  const Light light = converted({spot})[0];
  EXPECT_TRUE(is_finite(vec3(light, "barn")));
  EXPECT_FLOAT_EQ(glm::length(vec3(light, "direction")), 1.0F);
}

TEST_F(PunctualTest, LightsOfTheSceneMoveWithItUnlessTheyWereMovedOrKeyed) {
  PunctualLight torch;
  torch.name = "torch";
  torch.kind = PunctualLight::Kind::kSpot;
  torch.position = Vec3(1.0F, 2.0F, 3.0F);
  PunctualLight sun;
  sun.name = "sun";
  sun.kind = PunctualLight::Kind::kSun;
  const std::vector<Light> before = converted({torch, sun});
  torch.position = Vec3(4.0F, 5.0F, 6.0F);
  sun.direction = Vec3(1.0F, 0.0F, 0.0F);
  const std::vector<Light> after = converted({torch, sun});
  LightRig rig = empty_rig(types_, frame_);
  rig.lights = before;
  rig.lights[0].params.set_vec3(*rig.lights[0].params.schema().by_role("color"), Vec3(7.0F));  // no matter of place
  LightRig keyed = rig;
  LightRig moved = rig;
  EXPECT_TRUE(follow_scene(rig, before, after));
  EXPECT_EQ(vec3(rig.lights[0], "position"), torch.position);
  EXPECT_EQ(vec3(rig.lights[0], "color"), Vec3(7.0F));
  EXPECT_EQ(vec3(rig.lights[1], "direction"), sun.direction);
  EXPECT_FALSE(follow_scene(rig, before, after));  // it is there
  set_key(keyed, {"torch", *keyed.lights[0].params.schema().find("position"), 1}, 3, KeyInterpolation::kStep);
  follow_scene(keyed, before, after);
  EXPECT_EQ(vec3(keyed.lights[0], "position"), Vec3(1.0F, 2.0F, 3.0F));
  moved.lights[0].params.set(*moved.lights[0].params.schema().find("position"), 0, 1.5);
  follow_scene(moved, before, after);
  EXPECT_EQ(vec3(moved.lights[0], "position"), Vec3(1.5F, 2.0F, 3.0F));
}

}  // namespace
}  // namespace luminist
