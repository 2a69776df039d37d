#include "raster/shadow_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/files.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

const SceneFrame kScene{Vec3(1, 2, 3), 4.0F};

/// The light types of the source tree, and a light of one of them.
class ShadowLights : public ::testing::Test {
 protected:
  void SetUp() override {
    auto loaded = LightTypes::load(AssetRoots::standard());
    ASSERT_TRUE(loaded) << loaded.error().message();
    types_.emplace(std::move(loaded).value());
  }
  Light make(const std::string& type) { return make_light(*types_, type, "light", SceneFrame{}).value(); }
  static void set(Light& light, const char* role, const Vec3& value) {
    const int param = *light.params.schema().by_role(role);
    for (int c = 0; c < light.params.schema()[param].components(); ++c) light.params.set(param, c, value[c]);
  }
  std::optional<LightTypes> types_;
};

TEST_F(ShadowLights, SpotCoversItsShapeWhicheverWayItIsTurned) {
  Light light = make("cinematic");
  set(light, "shape", Vec3(0.5F, 0.3F, 0.1F));
  const ShadowLight shadow = shadow_light(light, *types_, kScene);
  EXPECT_EQ(shadow.kind, ShadowKind::kSpot);
  EXPECT_GE(shadow.extent, std::pow(std::pow(0.6F, 4.0F) + std::pow(0.4F, 4.0F), 0.25F));
  EXPECT_LE(shadow.extent, 1.0F);  // no more than a step of sqrt(2) above
}

TEST_F(ShadowLights, SmallChangeOfShapeKeepsTheMap) {
  Light light = make("cinematic");
  set(light, "shape", Vec3(0.5F, 0.5F, 0.1F));
  const ShadowLight before = shadow_light(light, *types_, kScene);
  set(light, "shape", Vec3(0.502F, 0.5F, 0.1F));
  EXPECT_EQ(shadow_light(light, *types_, kScene), before);
}

TEST_F(ShadowLights, ColourAndDistancesDoNotTouchShadows) {
  Light light = make("cinematic");
  const ShadowLight before = shadow_light(light, *types_, kScene);
  set(light, "color", Vec3(3, 2, 1));
  set(light, "cutoff", Vec3(0.1F, 0.2F, 0));
  set(light, "shadow", Vec3(0.3F));
  EXPECT_EQ(shadow_light(light, *types_, kScene), before);
}

TEST_F(ShadowLights, FilterIsTwoToFourTexelsWide) {
  Light light = make("cinematic");
  for (const float softness : {0.003F, 0.008F, 0.015F, 0.02F}) {
    set(light, "size", Vec3(softness));
    const ShadowLight shadow = shadow_light(light, *types_, kScene);
    EXPECT_EQ(shadow.softness, softness);
    EXPECT_GE(shadow.softness / shadow.texel(), 1.999F);
    EXPECT_LE(shadow.softness / shadow.texel(), 4.001F);
  }
}

TEST_F(ShadowLights, FilterIsWidenedWhereTheLargestMapIsTooCoarse) {
  Light light = make("cinematic");
  set(light, "shape", Vec3(1.5F, 1.5F, 0.5F));
  set(light, "size", Vec3(0.001F));
  const ShadowLight shadow = shadow_light(light, *types_, kScene);
  EXPECT_EQ(shadow.size_px, 2048);
  EXPECT_FLOAT_EQ(shadow.softness, 2.0F * shadow.texel());
}

TEST_F(ShadowLights, NumbersThatMakeNoSenseLeaveEverythingLit) {
  Light light = make("cinematic");
  set(light, "position", Vec3(std::numeric_limits<float>::quiet_NaN(), 0, 0));
  EXPECT_EQ(shadow_light(light, *types_, kScene).kind, ShadowKind::kNone);
  light = make("cinematic");
  set(light, "direction", Vec3(0.0F));
  EXPECT_EQ(shadow_light(light, *types_, kScene).kind, ShadowKind::kNone);
  light = make("point");
  set(light, "position", Vec3(std::numeric_limits<float>::infinity(), 0, 0));
  EXPECT_EQ(shadow_light(light, *types_, kScene).kind, ShadowKind::kNone);
}

TEST_F(ShadowLights, ShapesOutsideTheirRangeStayFinite) {
  Light light = make("cinematic");
  for (const float size : {-3.0F, 0.0F, 1e30F, std::numeric_limits<float>::quiet_NaN()}) {
    set(light, "shape", Vec3(size));
    const ShadowLight shadow = shadow_light(light, *types_, kScene);
    EXPECT_GT(shadow.extent, 0.0F);
    EXPECT_LE(shadow.extent, 4.0F);
    EXPECT_GE(shadow.size_px, 256);
  }
}

TEST_F(ShadowLights, AllFollowTheSharedShadowLight) {
  LightRig rig = empty_rig(*types_, SceneFrame{});
  rig.lights = {make("cinematic"), make("point")};
  rig.lights[0].name = "key";
  rig.lights[1].name = "fill";
  EXPECT_NE(shadow_lights(rig, *types_, kScene)[0], shadow_lights(rig, *types_, kScene)[1]);
  rig.shadow_light = "key";
  const auto shadows = shadow_lights(rig, *types_, kScene);
  EXPECT_EQ(shadows[0], shadows[1]);
  EXPECT_EQ(shadows[0].kind, ShadowKind::kSpot);
}

TEST(ShadowTap, LiesInTheConeAndNowhereUnderTheReceiversPlane) {
  const ShadowLight light{ShadowKind::kSpot, Vec3(1, 3, 2), Vec3(0, -1, 0), 1.0F, 0.01F, 512};
  const Vec3 receiver(0.2F, 0.1F, -0.3F);
  for (const Vec3& n : {Vec3(0.3F, 1.0F, 0.1F), Vec3(-1.0F, 0.5F, 0.3F), Vec3(1.0F, 0.1F, -0.2F)}) {
    const Vec3 normal = glm::normalize(n);
    const float distance = glm::length(receiver - light.position);
    for (int i = 0; i < 16; ++i) {
      const Vec3 tap = shadow_tap(light, receiver, normal, vogel_disc(i, 16));
      EXPECT_GE(glm::dot(tap - receiver, normal), -1e-6F);
      const float along = glm::dot(tap - light.position, receiver - light.position) / (distance * distance);
      EXPECT_LE(along, 1.0F + 1e-6F);
      const Vec3 across = tap - light.position - along * (receiver - light.position);
      EXPECT_LE(glm::length(across), 0.01001F * along * distance);
    }
  }
}

TEST(ShadowTap, InTheMiddleIsTheReceiver) {
  const ShadowLight light{ShadowKind::kCube, Vec3(1, 3, 2), Vec3(0, -1, 0), 1.0F, 0.01F, 512};
  const Vec3 receiver(0.2F, 0.1F, -0.3F);
  EXPECT_LT(glm::length(shadow_tap(light, receiver, Vec3(0, 1, 0), Vec2(0.0F)) - receiver), 1e-6F);
}

TEST(ReceiverOffset, GrowsWithDistanceAndSlope) {
  const ShadowLight light;
  EXPECT_FLOAT_EQ(receiver_offset(light, 2.0F, 1.0F), 2.0F * receiver_offset(light, 1.0F, 1.0F));
  EXPECT_FLOAT_EQ(receiver_offset(light, 1.0F, 0.0F), 1.5F * light.texel());
  EXPECT_GT(receiver_offset(light, 1.0F, 0.2F), receiver_offset(light, 1.0F, 0.9F));
}

TEST(VogelDisc, IsEvenAndInsideTheUnitDisc) {
  Vec2 sum(0.0F);
  double squares = 0.0;
  for (int i = 0; i < 64; ++i) {
    const Vec2 p = vogel_disc(i, 64);
    EXPECT_LE(glm::length(p), 1.0F);
    sum += p;
    squares += glm::dot(p, p);
  }
  EXPECT_LT(glm::length(sum / 64.0F), 0.01F);
  EXPECT_NEAR(squares / 64.0, 0.5, 1e-3);  // mean squared radius of a disc
}

TEST_F(ShadowLights, ASunCoversTheSceneFromItsMiddle) {
  LUM_ASSERT_OK(Light light, make_light(*types_, "sun", "sun", SceneFrame{}));
  light.params.set(*light.params.schema().by_role("size"), 0, 0.01);
  const ShadowLight shadow = shadow_light(light, *types_, kScene);
  EXPECT_EQ(shadow.kind, ShadowKind::kSun);
  EXPECT_EQ(shadow.position, kScene.center);
  EXPECT_FLOAT_EQ(shadow.softness, 0.04F);
  EXPECT_GE(shadow.extent, kScene.radius);
  EXPECT_TRUE(shadow_covers(shadow, kScene.center + 4.0F * Vec3(1, 0, 0)));
  EXPECT_TRUE(shadow_covers(shadow, kScene.center + 40.0F * shadow.direction));
  EXPECT_EQ(way_to_light(shadow, Vec3(9, 9, 9)), -shadow.direction);
}

TEST_F(ShadowLights, TapsOfASunLieAboveTheReceiversPlaneAndAsWideEverywhere) {
  const ShadowLight sun{ShadowKind::kSun, Vec3(0), glm::normalize(Vec3(1, -1, 0)), 2.0F, 0.05F, 512};
  const Vec3 up(0, 1, 0);
  for (const float away : {1.0F, 50.0F}) {
    const Vec3 receiver(away, 0, away);
    for (int i = 0; i < 16; ++i) {
      const Vec3 tap = shadow_tap(sun, receiver, up, vogel_disc(i, 16));
      EXPECT_GE(tap.y, -1e-5F * away);
      const Vec3 way = tap - receiver;
      EXPECT_NEAR(glm::length(way - glm::dot(way, sun.direction) * sun.direction),
                  0.05F * glm::length(vogel_disc(i, 16)), 1e-5F * away);
    }
  }
}

}  // namespace
}  // namespace luminist
