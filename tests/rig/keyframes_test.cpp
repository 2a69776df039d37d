#include "rig/keyframes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rig/light_rig.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

class KeyframesTest : public testing::Test {
 protected:
  KeyframesTest() : types_(*LightTypes::load(AssetRoots::standard())), rig_(empty_rig(types_, frame_)) {
    rig_.lights.push_back(*make_light(types_, "cinematic", "key", frame_));
  }
  [[nodiscard]] int param(const char* name) const { return *rig_.lights[0].params.schema().find(name); }
  void key(const char* name, double frame, const Vec3& value, KeyInterpolation how) {
    rig_.lights[0].params.set_vec3(param(name), value);
    set_key(rig_, {"key", param(name)}, frame, how);
  }
  [[nodiscard]] Vec3 at(const char* name, double frame) {
    pose(rig_, frame);
    return rig_.lights[0].params.vec3(param(name));
  }
  Result<LightRig> parse(const std::string& keys) const {
    return parse_rig("[[light]]\nname = \"key\"\ntype = \"cinematic\"\n" + keys, "a.toml", types_, frame_);
  }

  SceneFrame frame_;
  LightTypes types_;
  LightRig rig_;
};

TEST_F(KeyframesTest, StandStillOutsideOfTheirKeysAndAreExactAtThem) {
  key("color", 10, Vec3(0.1F), KeyInterpolation::kSmooth);
  key("color", 20, Vec3(0.7F), KeyInterpolation::kSmooth);
  EXPECT_EQ(at("color", -5), Vec3(0.1F));
  EXPECT_EQ(at("color", 10), Vec3(0.1F));
  EXPECT_EQ(at("color", 20), Vec3(0.7F));
  EXPECT_EQ(at("color", 99), Vec3(0.7F));
}

TEST_F(KeyframesTest, StepJumpsAndLinearIsHalfWayInTheMiddle) {
  key("color", 0, Vec3(1.0F, 0.0F, 0.5F), KeyInterpolation::kLinear);
  key("color", 10, Vec3(3.0F, 1.0F, 0.5F), KeyInterpolation::kStep);
  key("color", 20, Vec3(0.0F), KeyInterpolation::kLinear);
  EXPECT_EQ(at("color", 5), Vec3(2.0F, 0.5F, 0.5F));
  EXPECT_EQ(at("color", 19.9), Vec3(3.0F, 1.0F, 0.5F));
}

TEST_F(KeyframesTest, SmoothNeverLeavesTheRangeBetweenTwoKeysAndHasNoKinks) {
  const float values[] = {0.0F, 0.1F, 4.0F, 4.0F, 1.0F};
  for (int i = 0; i < 5; ++i) key("position", 10.0 * i, Vec3(values[i]), KeyInterpolation::kSmooth);
  for (int i = 0; i < 4; ++i) {
    const float low = std::min(values[i], values[i + 1]);
    const float high = std::max(values[i], values[i + 1]);
    for (double f = 10.0 * i; f <= 10.0 * i + 10.0; f += 0.25) {
      const float value = at("position", f).x;
      EXPECT_GE(value, low - 1e-6F) << f;
      EXPECT_LE(value, high + 1e-6F) << f;
    }
  }
  // The slope left and right of the second key agrees up to the second derivative over the step.
  const float left = (at("position", 10).x - at("position", 9.99).x) / 0.01F;
  const float right = (at("position", 10.01).x - at("position", 10).x) / 0.01F;
  EXPECT_NEAR(left, right, 0.005F);
  EXPECT_GT(right, 0.005F);
}

TEST_F(KeyframesTest, DirectionsGoAlongTheGreatCircleAndStayUnit) {
  key("direction", 0, Vec3(1, 0, 0), KeyInterpolation::kLinear);
  key("direction", 10, Vec3(0, 0, -1), KeyInterpolation::kLinear);
  const Vec3 third = at("direction", 10.0 / 3.0);
  EXPECT_NEAR(glm::distance(third, Vec3(std::cos(kPi / 6), 0, -std::sin(kPi / 6))), 0.0F, 1e-6F);
  key("direction", 20, Vec3(0, 0, 1), KeyInterpolation::kSmooth);  // the opposite of the one before
  for (double f = 0; f <= 20; f += 0.5) EXPECT_NEAR(glm::length(at("direction", f)), 1.0F, 1e-6F);
}

TEST_F(KeyframesTest, WhatIsTurnedAtAFrameStaysThere) {
  key("color", 0, Vec3(0.0F), KeyInterpolation::kLinear);
  key("color", 10, Vec3(1.0F), KeyInterpolation::kLinear);
  key("position", 0, Vec3(1, 2, 3), KeyInterpolation::kStep);
  pose(rig_, 5);
  EXPECT_EQ(follow_with_keys(rig_, 5), 0);
  rig_.lights[0].params.set_vec3(param("color"), Vec3(4.0F));
  rig_.lights[0].params.set(param("shadow_density"), 0, 0.25);  // has no keys
  EXPECT_EQ(follow_with_keys(rig_, 5), 1);
  EXPECT_EQ(at("color", 5), Vec3(4.0F));
  EXPECT_EQ(at("color", 2.5), Vec3(2.0F));
  EXPECT_EQ(key_frames(rig_, "key"), (std::vector<double>{0, 5, 10}));
  EXPECT_EQ(key_frames(rig_, ""), std::vector<double>());
}

TEST_F(KeyframesTest, ConstraintsHoldAtEveryFrame) {
  rig_.constraints.push_back({"key", OnPlane{{Vec3(0, 2, 0), Vec3(0, 1, 0)}}});
  key("position", 0, Vec3(0, 0, 0), KeyInterpolation::kLinear);
  key("position", 10, Vec3(4, 8, 0), KeyInterpolation::kLinear);
  EXPECT_EQ(at("position", 5), Vec3(2, 2, 0));
}

TEST_F(KeyframesTest, RigFilesReadBackToTheSameKeys) {
  key("color", 0, Vec3(0.1F, 0.7F, 1.0F / 3.0F), KeyInterpolation::kLinear);
  key("position", 0, Vec3(1, 2, 3), KeyInterpolation::kLinear);
  key("color", 7.5, Vec3(2.0F), KeyInterpolation::kStep);
  set_key(rig_, {"", 0}, 3, KeyInterpolation::kSmooth);
  LUM_ASSERT_OK(LightRig back, parse_rig(rig_to_toml(rig_), "a.toml", types_, frame_));
  EXPECT_EQ(rig_to_toml(back), rig_to_toml(rig_));
  EXPECT_EQ(key_frames(back, "*"), (std::vector<double>{0, 3, 7.5}));
  for (const double f : {0.0, 2.0, 7.5}) {
    pose(back, f);
    EXPECT_EQ(back.lights[0].params.vec3(param("color")), at("color", f));
  }
}

TEST_F(KeyframesTest, RigFilesSayWhatIsWrongWithAKey) {
  EXPECT_EQ(error_of(parse("[[key]]\nframe = 1\nlight = \"kay\"\ncolor = [1, 1, 1]\n")).hint, "did you mean \"key\"?");
  EXPECT_EQ(error_of(parse("[[key]]\nframe = 1\nlight = \"key\"\ncolour = [1, 1, 1]\n")).field, "colour");
  EXPECT_EQ(error_of(parse("[[key]]\nframe = 1\nlight = \"key\"\n")).field, "frame");
  EXPECT_EQ(error_of(parse("[[key]]\nlight = \"key\"\ncolor = [1, 1, 1]\n")).field, "frame");
  EXPECT_EQ(error_of(parse("[[key]]\nframe = 1\nlight = \"key\"\ninterpolation = \"soft\"\ncolor = [1, 1, 1]\n")).field,
            "interpolation");
  const std::string twice = "[[key]]\nframe = 1\nlight = \"key\"\ncolor = [1, 1, 1]\n";
  EXPECT_EQ(error_of(parse(twice + twice)).field, "color");
}

TEST_F(KeyframesTest, OneNumberOfAParameterGoesItsOwnWay) {
  rig_.lights[0].params.set_vec3(param("position"), Vec3(1, 2, 3));
  set_key(rig_, {"key", param("position"), 1}, 0, KeyInterpolation::kLinear);
  rig_.lights[0].params.set_vec3(param("position"), Vec3(7, 4, 3));
  set_key(rig_, {"key", param("position"), 1}, 10, KeyInterpolation::kLinear);
  EXPECT_EQ(at("position", 5), Vec3(7, 3, 3));
  rig_.lights[0].params.set_vec3(param("position"), Vec3(8, 3, 9));
  EXPECT_EQ(follow_with_keys(rig_, 5), 0);  // x and z have no keys
  rig_.lights[0].params.set(param("position"), 1, 0.5);
  EXPECT_EQ(follow_with_keys(rig_, 5), 1);
  EXPECT_EQ(at("position", 5).y, 0.5F);
}

TEST_F(KeyframesTest, KeyingOneNumberLeavesTheCurveOfAllAsItWas) {
  const Vec3 values[] = {Vec3(0, 1, 2), Vec3(3, 1, -4), Vec3(3.5F, 9, -5), Vec3(1, 0, 0)};
  for (int i = 0; i < 4; ++i) key("position", 10.0 * i, values[i], KeyInterpolation::kSmooth);
  std::vector<Vec3> before;
  for (double f = -1; f < 32; f += 0.5) before.push_back(at("position", f));
  pose(rig_, 10);
  set_key(rig_, {"key", param("position"), 0}, 10, KeyInterpolation::kSmooth);  // where it is anyway
  EXPECT_EQ(rig_.keys.size(), 3U);
  std::size_t i = 0;
  for (double f = -1; f < 32; f += 0.5) EXPECT_EQ(at("position", f), before[i++]) << f;
  EXPECT_TRUE(remove_key(rig_, {"key", param("position"), 0}, 20));
  EXPECT_NE(at("position", 20).x, 3.5F);
  EXPECT_EQ(at("position", 20).y, 9.0F);
  EXPECT_FALSE(remove_key(rig_, {"key", param("position"), 0}, 20));
  EXPECT_TRUE(remove_key(rig_, {"key", param("position")}, 20));  // the others
  EXPECT_EQ(key_frames(rig_, "key"), (std::vector<double>{0, 10, 30}));
}

TEST_F(KeyframesTest, AKeyOfAllIsAKeyOfEachNumberWhereTheyGoTheirOwnWay) {
  set_key(rig_, {"key", param("color"), 2}, 0, KeyInterpolation::kStep);
  key("color", 4, Vec3(1, 2, 3), KeyInterpolation::kLinear);
  EXPECT_EQ(rig_.keys.size(), 3U);
  EXPECT_EQ(at("color", 4), Vec3(1, 2, 3));
  EXPECT_EQ(at("color", 0), Vec3(1, 2, 1));
}

TEST_F(KeyframesTest, AreMovedAndInterpolatedOtherwise) {
  key("color", 0, Vec3(0.0F), KeyInterpolation::kStep);
  key("color", 10, Vec3(1.0F), KeyInterpolation::kStep);
  EXPECT_TRUE(set_interpolation(rig_, {"key", param("color")}, 0, KeyInterpolation::kLinear));
  EXPECT_EQ(at("color", 5), Vec3(0.5F));
  EXPECT_TRUE(move_key(rig_, {"key", param("color")}, 10, 20));
  EXPECT_EQ(at("color", 5), Vec3(0.25F));
  EXPECT_TRUE(move_key(rig_, {"key", param("color")}, 0, 20));  // in place of the one there
  EXPECT_EQ(key_frames(rig_, "key"), std::vector<double>{20});
  EXPECT_EQ(at("color", 20), Vec3(0.0F));
  EXPECT_FALSE(move_key(rig_, {"key", param("color")}, 3, 4));
  EXPECT_FALSE(set_interpolation(rig_, {"key", param("position")}, 0, KeyInterpolation::kStep));
}

TEST_F(KeyframesTest, NumbersWithKeysReadBackToTheSameBits) {
  rig_.lights[0].params.set_vec3(param("position"), Vec3(1.0F / 3.0F, 0.1F, -7e-9F));
  set_key(rig_, {"key", param("position"), 0}, 0, KeyInterpolation::kLinear);
  set_key(rig_, {"key", param("position"), 2}, 0, KeyInterpolation::kLinear);
  set_key(rig_, {"key", param("position"), 0}, 2.5, KeyInterpolation::kStep);
  set_key(rig_, {"", 0, 1}, 3, KeyInterpolation::kSmooth);
  const std::string text = rig_to_toml(rig_);
  EXPECT_NE(text.find("\nposition.x = 0.33333334\n"), std::string::npos) << text;
  LUM_ASSERT_OK(LightRig back, parse_rig(text, "a.toml", types_, frame_));
  EXPECT_EQ(rig_to_toml(back), text);
  ASSERT_EQ(back.keys.size(), 3U);
  pose(back, 0);
  EXPECT_EQ(back.lights[0].params.vec3(param("position")), Vec3(1.0F / 3.0F, 0.1F, -7e-9F));
}

TEST_F(KeyframesTest, RigFilesSayWhatIsWrongWithAKeyOfANumber) {
  const std::string head = "[[key]]\nframe = 1\nlight = \"key\"\n";
  EXPECT_EQ(error_of(parse(head + "direction.x = 1\n")).what, "a direction is keyed as a whole");
  EXPECT_EQ(error_of(parse(head + "position.w = 1\n")).field, "w");
  EXPECT_EQ(error_of(parse(head + "positron.x = 1\n")).field, "positron");
  EXPECT_EQ(error_of(parse(head + "position.x = \"1\"\n")).field, "x");
  EXPECT_EQ(error_of(parse(head + "position = [1, 2, 3]\n" + head + "position.x = 1\n")).field, "x");
  EXPECT_EQ(error_of(parse(head + "position.x = 1\n" + head + "position = [1, 2, 3]\n")).field, "position");
}

TEST_F(KeyframesTest, GoWithTheirLight) {
  key("color", 0, Vec3(1.0F), KeyInterpolation::kLinear);
  remove_light(rig_, "key");
  EXPECT_TRUE(rig_.keys.empty());
}

}  // namespace
}  // namespace luminist
