#include "params/unit_map.h"

#include <gtest/gtest.h>

namespace luminist {
namespace {

TEST(Penalty, IsZeroInsideTheUnitCubeAndClimbsOutside) {
  EXPECT_EQ(penalty(0.0), 0.0);
  EXPECT_EQ(penalty(0.5), 0.0);
  EXPECT_EQ(penalty(1.0), 0.0);
  EXPECT_NEAR(penalty(-0.1), 0.44, 1e-12);  // exact up to rounding
  EXPECT_NEAR(penalty(1.5), 3.0, 1e-12);
}

}  // namespace
}  // namespace luminist
