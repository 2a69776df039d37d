#include "raster/metric_pass.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>

#include "render/metric.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

class MetricPassTest : public testing::Test {
 protected:
  static constexpr int kWidth = 157;  // neither a power of two nor a multiple of a work group
  static constexpr int kHeight = 89;

  void SetUp() override {
    LUM_ASSERT_OK(device_, Device::create_headless());
    LUM_ASSERT_OK(pass_, MetricPass::create(*device_, AssetRoots::standard(), kWidth * kHeight));
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    picture_ = Image(kWidth, kHeight, 3);
    target_.color = Image(kWidth, kHeight, 3);
    target_.before = Image(kWidth, kHeight, 3);
    target_.importance = Image(kWidth, kHeight, 1);
    for (float& v : picture_.data) v = 2.0F * unit(random);
    for (float& v : target_.color.data) v = unit(random);
    for (float& v : target_.importance.data) v = unit(random) * unit(random);
    target_.stroke.assign(picture_.pixels(), 0);
  }
  double error() {
    std::vector<Vec4> pixels;
    for (std::size_t i = 0; i < picture_.pixels(); ++i) pixels.emplace_back(picture_.rgb(i), 1.0F);
    auto buffer = GlBuffer::create(*device_, BufferUse::kStorage, std::span<const Vec4>(pixels), "picture");
    return pass_->error(buffer.value(), target_).value();
  }

  std::optional<Device> device_;
  std::optional<MetricPass> pass_;
  Image picture_;
  Target target_;
};

TEST_F(MetricPassTest, AgreesWithTheReference) {
  const double reference = picture_error(picture_, target_, {});
  // A length and a product in single precision a pixel: 2e-7 each; their sum is in double.
  EXPECT_NEAR(error(), reference, 1e-6 * reference);
}

TEST_F(MetricPassTest, RepeatsItsBitsAndSeesAnotherTarget) {
  const double first = error();
  EXPECT_EQ(error(), first);
  target_.importance.data[7] += 0.5F;
  const double changed = error();
  EXPECT_NE(changed, first);
  EXPECT_NEAR(changed, picture_error(picture_, target_, {}), 1e-6 * changed);
  target_.color.data[100] += 0.25F;
  EXPECT_NE(error(), changed);
}

TEST_F(MetricPassTest, IsZeroWhereNothingCountsAndForEqualPictures) {
  target_.color = picture_;
  EXPECT_EQ(error(), 0.0);
  target_.color.data[0] += 1.0F;
  std::fill(target_.importance.data.begin(), target_.importance.data.end(), 0.0F);
  EXPECT_EQ(error(), 0.0);
}

}  // namespace
}  // namespace luminist
