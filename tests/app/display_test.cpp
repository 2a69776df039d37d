#include "app/display.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace luminist {
namespace {

TEST(Display, ATableHoldsTheCurveToWithinOneCode) {
  for (const DisplayOptions options :
       {DisplayOptions{}, DisplayOptions{1.5F, ViewTransform::kStandard}, DisplayOptions{0.0F, ViewTransform::kSoft},
        DisplayOptions{-1.0F, ViewTransform::kRaw}}) {
    const DisplayTable table(options);
    for (float x = 1e-4F; x < 20.0F; x *= 1.003F) {
      // A step of the table is 2^-10 of the value: less than one code of 255 everywhere, rounded differently.
      EXPECT_NEAR(table(x), 255.0F * displayed(x, options), 1.0F) << x;
    }
  }
}

TEST(Display, WhatIsNoLightIsBlackAndTooMuchIsWhite) {
  const DisplayTable table{DisplayOptions()};
  EXPECT_EQ(table(-1.0F), 0);
  EXPECT_EQ(table(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(table(0.0F), 0);
  EXPECT_EQ(table(1.0F), 255);
  EXPECT_EQ(table(1e30F), 255);
  EXPECT_EQ(table(std::numeric_limits<float>::infinity()), 255);
}

TEST(Display, SoftHighlightsKeepTheirOrderWhereStandardClips) {
  const DisplayOptions soft{0.0F, ViewTransform::kSoft};
  EXPECT_LT(displayed(1.0F, soft), displayed(2.0F, soft));
  EXPECT_LT(displayed(2.0F, soft), displayed(4.0F, soft));
  EXPECT_LT(displayed(100.0F, soft), 1.0F);
  EXPECT_FLOAT_EQ(displayed(0.3F, soft), displayed(0.3F, DisplayOptions()));
}

TEST(Display, AStopDoublesLight) {
  EXPECT_FLOAT_EQ(displayed(0.2F, {1.0F, ViewTransform::kStandard}), displayed(0.4F, DisplayOptions()));
}

TEST(Display, PixelsAreRedGreenBlueFromTheLowestByte) {
  Image image(1, 1, 3);
  image.set_rgb(0, Vec3(1.0F, 0.0F, 0.0F));
  std::uint32_t code = 0;
  to_display(image, DisplayTable{DisplayOptions()}, {&code, 1});
  EXPECT_EQ(code, 0xFF0000FFU);
}

}  // namespace
}  // namespace luminist
