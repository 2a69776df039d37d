#include "app/timeline.h"

#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace luminist {
namespace {

TEST(TimeScale, GoesFromFramesToTheScreenAndBack) {
  const TimeScale scale{100.0F, 500.0F, 0, 40};
  EXPECT_EQ(scale.x_of(0), 100.0F);
  EXPECT_EQ(scale.x_of(40), 500.0F);
  EXPECT_EQ(scale.frame_at(scale.x_of(7)), 7.0);
  EXPECT_EQ(scale.frame_at(173.0F), 7.0);  // 7.3
  EXPECT_EQ(scale.frame_at(-9.0F), 0.0);
  EXPECT_EQ(scale.frame_at(900.0F), 40.0);
}

TEST(TimeScale, ASingleFrameIsNoDivisionByZero) {
  const TimeScale scale{100.0F, 100.0F, 5, 5};
  EXPECT_EQ(scale.x_of(5), 100.0F);
  EXPECT_EQ(scale.frame_at(100.0F), 5.0);
}

TEST(TimeScale, LabelsAreRoundNumbersAndDoNotTouch) {
  const TimeScale scale{0.0F, 400.0F, 0, 240};
  EXPECT_EQ(scale.step(30.0F), 20);  // 18 frames are 30 pixels
  EXPECT_EQ((TimeScale{0.0F, 400.0F, 0, 10}.step(30.0F)), 1);
}

class KeyRowsTest : public testing::Test {
 protected:
  KeyRowsTest() : types_(*LightTypes::load(AssetRoots::standard())), rig_(empty_rig(types_, SceneFrame{})) {
    for (const char* name : {"key", "rim"}) rig_.lights.push_back(*make_light(types_, "cinematic", name, SceneFrame{}));
    const int position = *rig_.lights[0].params.schema().find("position");
    const int color = *rig_.lights[0].params.schema().find("color");
    set_key(rig_, {"key", position, 0}, 0, KeyInterpolation::kStep);
    set_key(rig_, {"key", color}, 0, KeyInterpolation::kStep);
    set_key(rig_, {"key", color}, 12, KeyInterpolation::kLinear);
    set_key(rig_, {"", 0}, 3, KeyInterpolation::kLinear);
  }
  LightTypes types_;
  LightRig rig_;
};

TEST_F(KeyRowsTest, TheSelectedLightHasARowForEachTrack) {
  const std::vector<KeyRow> rows = key_rows(rig_, "key");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].name, "position.x");
  EXPECT_EQ(rows[0].pattern, "lights/key/position.x");
  EXPECT_EQ(rows[1].pattern, "lights/key/color");
  EXPECT_EQ(rows[1].keys.size(), 2U);
  EXPECT_TRUE(key_rows(rig_, "rim").empty());
  ASSERT_EQ(key_rows(rig_, "ambient").size(), 1U);
  EXPECT_EQ(key_rows(rig_, "ambient")[0].pattern, "ambient/color");
}

TEST_F(KeyRowsTest, WithoutASelectionEachLightHasOneRow) {
  const std::vector<KeyRow> rows = key_rows(rig_, "");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].pattern, "lights/key");
  EXPECT_EQ(rows[0].keys.size(), 2U);  // the two at frame 0 are one sign
  EXPECT_EQ(rows[1].name, "ambient");
}

}  // namespace
}  // namespace luminist
