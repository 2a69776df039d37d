#include "verdict/stroke_region.h"

#include <gtest/gtest.h>

#include <set>
#include <span>

#include "solve/fake_renderer.h"

namespace luminist {
namespace {

class StrokeRegionTest : public testing::Test {
 protected:
  StrokeRegionTest() {
    ParamState state = fake_.empty_state();
    target_ = fake_.target_of(state, state);
    for (std::uint32_t i = 0; i < target_.stroke.size(); ++i) {
      if (fake_.surface().object[i] == 3) target_.stroke[i] = 2;
    }
  }
  FakeRenderer fake_{64, 48};
  Target target_;
};

TEST_F(StrokeRegionTest, EveryVisiblePixelThatCountsBelongsToItsStroke) {
  target_.importance.data[5] = 0.0F;
  const std::vector<StrokeRegion> regions = stroke_regions(fake_.surface(), target_);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].stroke, 0U);
  EXPECT_EQ(regions[1].stroke, 2U);
  EXPECT_EQ(regions[1].object, "sphere 1");
  std::size_t visible = 0;
  for (const std::uint32_t object : fake_.surface().object) visible += object != 0 ? 1 : 0;
  EXPECT_EQ(regions[0].pixels.size() + regions[1].pixels.size(), visible - 1);
}

TEST_F(StrokeRegionTest, PaintOnTheBackgroundIsCountedApart) {
  SurfaceBuffer surface = fake_.surface();
  surface.object[7] = 0;
  target_.stroke[7] = 9;
  const std::vector<StrokeRegion> regions = stroke_regions(surface, target_);
  EXPECT_EQ(regions.back().stroke, 9U);
  EXPECT_TRUE(regions.back().pixels.empty());
  EXPECT_EQ(regions.back().empty_pixels, 1U);
  EXPECT_EQ(regions.back().object, "");
}

TEST_F(StrokeRegionTest, TheShortfallIsMeasuredAgainstTheWish) {
  const StrokeRegion region = stroke_regions(fake_.surface(), target_)[1];
  Image picture = target_.before;
  for (const std::uint32_t pixel : region.pixels) {
    target_.color.set_rgb(pixel, target_.before.rgb(pixel) + Vec3(0.4F, 0.0F, 0.0F));
    picture.set_rgb(pixel, target_.before.rgb(pixel) + Vec3(0.3F, 0.0F, 0.0F));
  }
  const Shortfall unchanged = shortfall(region, target_, target_.before);
  EXPECT_NEAR(unchanged.wished, 0.4, 1e-6);
  EXPECT_NEAR(unchanged.missed, 0.4, 1e-6);
  EXPECT_FALSE(unchanged.met());
  EXPECT_NEAR(unchanged.attained(), 0.0, 1e-6);
  const Shortfall near = shortfall(region, target_, picture);
  EXPECT_NEAR(near.missed, 0.1, 1e-6);
  EXPECT_NEAR(near.light, 0.1, 1e-6);
  EXPECT_NEAR(near.dark, 0.0, 1e-6);
  EXPECT_NEAR(near.attained(), 0.75, 1e-5);
  EXPECT_TRUE(near.met());
}

TEST_F(StrokeRegionTest, PaintThatChangesAFewOfItsPixelsIsNotMetByTheOthers) {
  const StrokeRegion region = stroke_regions(fake_.surface(), target_)[1];
  const std::size_t changed = region.pixels.size() / 8;
  for (std::size_t k = 0; k < region.pixels.size(); ++k) {
    const std::uint32_t pixel = region.pixels[k];
    target_.before.set_rgb(pixel, Vec3(0.7F));
    target_.color.set_rgb(pixel, k < changed ? Vec3(0.9F) : Vec3(0.7F));
  }
  const Shortfall unchanged = shortfall(region, target_, target_.before);
  EXPECT_LT(unchanged.missed, 0.005 + 0.04 * unchanged.scale);  // on the whole nobody would see it
  EXPECT_NEAR(unchanged.missed_where_wished, 0.2 * std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(unchanged.scale_where_wished, 0.9 * std::sqrt(3.0), 1e-5);
  EXPECT_FALSE(unchanged.met());
  EXPECT_TRUE(shortfall(region, target_, target_.color).met());
}

TEST_F(StrokeRegionTest, PaintThatChangesAFewOfItsPixelsIsSampledWhereItDoes) {
  const StrokeRegion region = stroke_regions(fake_.surface(), target_)[1];
  const std::size_t changed = region.pixels.size() / 20;
  ASSERT_GT(changed, 2U);
  const std::span middle = std::span(region.pixels).subspan(region.pixels.size() / 2, changed);
  for (const std::uint32_t pixel : middle) target_.color.set_rgb(pixel, Vec3(3.0F));
  const SampledWish wish = only_region(sample_regions({region}, fake_.surface(), target_, 40), 0);
  double share = 0.0;
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < wish.weight.size(); ++i) {
    if (wish.target[i] != Vec3(3.0F)) continue;
    share += wish.weight[i];
    ++drawn;
  }
  EXPECT_GE(drawn, 3 * changed / 4);  // but for those at an edge; evenly drawn it would be a twentieth of 40
  EXPECT_NEAR(share, static_cast<double>(changed) / static_cast<double>(region.pixels.size()), 1e-9);
}

TEST_F(StrokeRegionTest, AStrokeIsCalledAfterWhatItChangesNotWhatItCovers) {
  const std::vector<std::uint32_t>& object = fake_.surface().object;
  for (std::size_t i = 0; i < object.size(); ++i) target_.stroke[i] = object[i] == 0 ? 0 : 5;
  const StrokeRegion covered = stroke_regions(fake_.surface(), target_).back();
  const auto first = std::find(object.begin(), object.end(), 3) - object.begin();
  ASSERT_NE(covered.object, "sphere 1");
  target_.color.set_rgb(static_cast<std::size_t>(first), Vec3(2.0F));
  EXPECT_EQ(stroke_regions(fake_.surface(), target_).back().object, "sphere 1");
}

TEST_F(StrokeRegionTest, SamplesKeepTheShareOfEachStroke) {
  for (std::uint32_t i = 0; i < target_.stroke.size(); ++i) {
    target_.importance.data[i] = target_.stroke[i] == 2 ? 1.0F : 0.1F;
  }
  const std::vector<StrokeRegion> regions = stroke_regions(fake_.surface(), target_);
  const SampledWish wish = sample_regions(regions, fake_.surface(), target_, 20);
  EXPECT_EQ(wish.samples.pixels.size(), 40U);
  EXPECT_EQ(std::set<std::uint32_t>(wish.samples.pixels.begin(), wish.samples.pixels.end()).size(), 40U);
  double share = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < wish.weight.size(); ++i) {
    sum += wish.weight[i];
    share += wish.region[i] == 1 ? wish.weight[i] : 0.0;
  }
  const auto painted = static_cast<double>(regions[1].pixels.size());
  const auto rest = static_cast<double>(regions[0].pixels.size());
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR(share, painted / (painted + 0.1 * rest), 1e-6);  // importance is stored as floats
  const SampledWish part = only_region(wish, 1);
  EXPECT_EQ(part.samples.pixels.size(), 20U);
  EXPECT_NE(part.samples.id, wish.samples.id);
}

}  // namespace
}  // namespace luminist
