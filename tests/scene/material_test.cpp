#include "scene/material.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luminist {
namespace {

/// Red 0, 1, 2 from the left in the upper row, 3, 4, 5 in the lower one.
Texture ramp(bool repeat) {
  Texture texture{"ramp", Image(3, 2, 3), repeat, repeat};
  for (std::size_t i = 0; i < 6; ++i) texture.image.set_rgb(i, Vec3(static_cast<float>(i), 9.0F, 9.0F));
  return texture;
}

TEST(Texture, IsLinearBetweenTheCentresOfItsPixels) {
  const Texture texture = ramp(false);
  EXPECT_FLOAT_EQ(texture.red_at({0.5F / 3.0F, 0.25F}), 0.0F);
  EXPECT_FLOAT_EQ(texture.red_at({0.5F, 0.25F}), 1.0F);
  EXPECT_FLOAT_EQ(texture.red_at({2.0F / 3.0F, 0.25F}), 1.5F);
  EXPECT_FLOAT_EQ(texture.red_at({0.5F, 0.5F}), 2.5F) << "row 0 is on top";
}

TEST(Texture, EndsInItsLastPixelsOrBeginsAgain) {
  EXPECT_FLOAT_EQ(ramp(false).red_at({-5.0F, -5.0F}), 0.0F);
  EXPECT_FLOAT_EQ(ramp(false).red_at({9.0F, 9.0F}), 5.0F);
  EXPECT_NEAR(ramp(true).red_at({-0.5F, 7.25F}), 1.0F, 1e-5F) << "a coordinate of 7 has steps of 5e-7";
  EXPECT_NEAR(ramp(true).red_at({0.0F, 0.25F}), 1.0F, 1e-5F) << "half-way between the last and the first";
}

TEST(Texture, AnswersForAnyCoordinate) {
  for (const float wild : {std::nanf(""), INFINITY, -INFINITY, 1e30F, -1e30F}) {
    for (const bool repeat : {false, true}) {
      const float red = ramp(repeat).red_at({wild, -wild});
      EXPECT_GE(red, 0.0F);
      EXPECT_LE(red, 5.0F);
    }
  }
}

}  // namespace
}  // namespace luminist
