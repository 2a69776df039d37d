// Golden pictures on other devices than the one that drew them.
#include "studio/golden.h"

#include <gtest/gtest.h>

namespace luminist {
namespace {

TEST(Golden, AGraphicsProcessorMayDifferAsMuchAsTheStyleSays) {
  Style style;
  GoldenCase golden;
  golden.max_difference = 0.2;
  golden.mean_difference = 0.001;
  golden.reason = "Edges.";
  DeviceInfo gpu;
  EXPECT_EQ(golden_on(gpu, style, golden).max_difference, 0.2) << "the style says nothing";
  style.golden_gpu = GoldenAllowance{0.1, 0.004, "Textures."};
  const GoldenCase there = golden_on(gpu, style, golden);
  EXPECT_EQ(there.max_difference, 0.2) << "no less than what is allowed anywhere";
  EXPECT_EQ(there.mean_difference, 0.004);
  EXPECT_EQ(there.reason, "Edges. Textures.");
  DeviceInfo software;
  software.software = true;
  EXPECT_EQ(golden_on(software, style, golden).mean_difference, 0.001);
  EXPECT_EQ(golden_on(software, style, golden).reason, "Edges.");
}

}  // namespace
}  // namespace luminist
