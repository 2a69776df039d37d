#include "base/image.h"

#include <gtest/gtest.h>

namespace luminist {
namespace {

TEST(Srgb, RoundTripsWithinRounding) {
  for (int i = 0; i <= 100; ++i) {
    const float v = static_cast<float>(i) / 100.0F;
    EXPECT_NEAR(linear_from_srgb(srgb_from_linear(v)), v, 1e-5F);
  }
}

TEST(Resized, KeepsTheMeanWhenShrinkingAndAConstantWhenGrowing) {
  Image image(6, 4, 1);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = static_cast<float>(i);
  const Image small = resized(image, 3, 2);
  float sum = 0.0F;
  for (float v : small.data) sum += v;
  EXPECT_NEAR(sum / 6.0F, 11.5F, 1e-4F);
  EXPECT_NEAR(small.at(0, 0, 0), (0.0F + 1.0F + 6.0F + 7.0F) / 4.0F, 1e-5F);
  for (float v : resized(Image(3, 3, 2, 0.25F), 7, 5).data) EXPECT_NEAR(v, 0.25F, 1e-6F);
}

TEST(Blurred, KeepsAConstantAndSpreadsAnImpulseSymmetrically) {
  for (float v : blurred(Image(9, 7, 3, 0.5F), 1.5F).data) EXPECT_NEAR(v, 0.5F, 1e-6F);
  Image impulse(21, 21, 1);
  impulse.at(10, 10, 0) = 1.0F;
  const Image soft = blurred(impulse, 2.0F);
  EXPECT_NEAR(soft.at(8, 10, 0), soft.at(12, 10, 0), 1e-7F);
  EXPECT_NEAR(soft.at(10, 8, 0), soft.at(8, 10, 0), 1e-7F);
  EXPECT_NEAR(soft.at(12, 10, 0) / soft.at(10, 10, 0), std::exp(-0.5F), 1e-4F);
}

}  // namespace
}  // namespace luminist
