#include "app/pen.h"

#include <gtest/gtest.h>

#include <array>

namespace luminist {
namespace {

TEST(PressureAxis, MapsItsRangeToPressure) {
  const PressureAxis axis{2, 0.0, 8191.0};
  EXPECT_EQ(axis.pressure(0.0), 0.0F);
  EXPECT_FLOAT_EQ(axis.pressure(8191.0 / 4.0), 0.25F);
  EXPECT_EQ(axis.pressure(8191.0), 1.0F);
  EXPECT_EQ(axis.pressure(9000.0), 1.0F);
  EXPECT_EQ(axis.pressure(-5.0), 0.0F);
  EXPECT_FLOAT_EQ((PressureAxis{2, -100.0, 100.0}.pressure(0.0)), 0.5F);
}

TEST(PressureAxis, PressesFullyWithoutARange) {
  EXPECT_EQ((PressureAxis{-1, 0.0, 100.0}.pressure(3.0)), 1.0F);
  EXPECT_EQ((PressureAxis{2, 5.0, 5.0}.pressure(3.0)), 1.0F);
}

TEST(PressureAxis, IsFoundAmongTheAxesThatAnEventTells) {
  const std::array<unsigned char, 2> mask = {0b00100101, 0b1};  // axes 0, 2, 5 and 8
  const std::array<double, 4> values = {10.0, 20.0, 50.0, 80.0};
  double value = -1.0;
  EXPECT_TRUE(axis_value(mask.data(), 2, values.data(), 2, value));
  EXPECT_EQ(value, 20.0);
  EXPECT_TRUE(axis_value(mask.data(), 2, values.data(), 8, value));
  EXPECT_EQ(value, 80.0);
  value = -1.0;
  for (const int axis : {1, 15, 16, -1}) EXPECT_FALSE(axis_value(mask.data(), 2, values.data(), axis, value));
  EXPECT_EQ(value, -1.0) << "what is not told is left as it was";
}

}  // namespace
}  // namespace luminist
