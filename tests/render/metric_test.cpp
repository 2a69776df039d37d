#include "render/metric.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/fixtures.h"

namespace luminist {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Target flat_target(int width, int height, const Vec3& color, float importance) {
  Target target;
  target.color = Image(width, height, 3);
  for (std::size_t pixel = 0; pixel < target.color.pixels(); ++pixel) target.color.set_rgb(pixel, color);
  target.before = Image(width, height, 3);
  target.importance = Image(width, height, 1, importance);
  return target;
}

TEST(PictureError, IsTheImportanceWeightedMeanOfColourDistances) {
  Target target = flat_target(2, 1, Vec3(0.0F), 0.0F);
  target.color.set_rgb(0, Vec3(1.0F, 2.0F, 3.0F));
  target.importance.data = {3.0F, 1.0F};
  Image picture(2, 1, 3);
  picture.set_rgb(0, Vec3(1.0F, 5.0F, -1.0F));  // distance 5
  picture.set_rgb(1, Vec3(2.0F, 3.0F, 6.0F));   // distance 7
  EXPECT_DOUBLE_EQ(picture_error(picture, target, {}), (3.0 * 5.0 + 1.0 * 7.0) / 4.0);
}

TEST(PictureError, IsZeroForTheTargetItself) {
  const Target target = flat_target(5, 4, Vec3(0.3F, 7.0F, 0.1F), 2.0F);
  EXPECT_EQ(picture_error(target.color, target, {}), 0.0);
}

TEST(PictureError, IsZeroWhereNothingCounts) {
  Target target = flat_target(3, 3, Vec3(1.0F), 0.0F);
  EXPECT_EQ(picture_error(Image(3, 3, 3), target, {}), 0.0);
}

TEST(PictureError, DoesNotLookAtPixelsThatDoNotCount) {
  Target target = flat_target(2, 1, Vec3(1.0F, 0.0F, 0.0F), 1.0F);
  target.importance.data[1] = 0.0F;
  Image picture(2, 1, 3);
  const double expected = picture_error(picture, target, {});
  target.color.set_rgb(1, Vec3(kNan));
  picture.set_rgb(1, Vec3(kNan));
  EXPECT_EQ(picture_error(picture, target, {}), expected);
}

TEST(PictureError, DoesNotDependOnTheScaleOfTheImportance) {
  Target target = flat_target(4, 4, Vec3(0.5F), 1.0F);
  const Image picture(4, 4, 3, 0.25F);
  const double once = picture_error(picture, target, {});
  for (float& value : target.importance.data) value *= 1000.0F;
  EXPECT_DOUBLE_EQ(picture_error(picture, target, {}), once);
}

TEST(PictureError, OfABlurredStyleComparesBlurredPictures) {
  // Black and white columns against their mean: nothing is alike pixel by pixel, all is after a blur.
  const int size = 64;
  const Target target = flat_target(size, size, Vec3(0.5F), 1.0F);
  Image picture(size, size, 3);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) picture.set_rgb(picture.index(x, y), Vec3(static_cast<float>(x % 2)));
  }
  EXPECT_NEAR(picture_error(picture, target, {}), 0.5 * std::sqrt(3.0), 1e-12);
  const StyleMetric metric{0.05F};  // sigma 3.2 px
  const double error = picture_error(picture, target, metric);
  EXPECT_GT(error, 0.0);
  EXPECT_LT(error, 0.05);  // what the clamped left and right edges keep
  // The width of the blur is a fraction of the height.
  Target blurred_target = target;
  blurred_target.color = blurred(target.color, 3.2F);
  EXPECT_DOUBLE_EQ(picture_error(blurred(picture, 0.05F * 64.0F), blurred_target, {}), error);
}

TEST(RowErrors, OfRowsThatChangedAreThoseOfTheWholePicture) {
  Target target = flat_target(7, 9, Vec3(0.4F, 0.1F, 0.9F), 0.3F);
  const Image picture(7, 9, 3, 0.7F);
  RowErrors rows;
  rows.compare(picture, target.color, target.importance);
  EXPECT_EQ(rows.error(), picture_error(picture, target, {}));
  for (const int y : {3, 4, 8}) {
    target.color.set_rgb(target.color.index(y % 7, y), Vec3(1.0F, 0.01F * static_cast<float>(y), 0.0F));
    target.importance.data[target.importance.index(6, y)] = 0.9F;
  }
  rows.compare(picture, target.color, target.importance, 3, 5);
  EXPECT_NE(rows.error(), picture_error(picture, target, {})) << "the last row changed, too";
  rows.compare(picture, target.color, target.importance, 8, 9);
  EXPECT_EQ(rows.error(), picture_error(picture, target, {}));
}

TEST(ResidualMap, ShowsWhereTheErrorIs) {
  Target target = flat_target(2, 2, Vec3(0.0F), 0.0F);
  target.importance.data = {0.0F, 2.0F, 1.0F, 0.0F};
  Image picture(2, 2, 3);
  picture.set_rgb(1, Vec3(0.0F, 3.0F, 4.0F));
  picture.set_rgb(2, Vec3(0.0F, 0.0F, 0.0F));
  picture.set_rgb(3, Vec3(kNan));
  const Image map = residual_map(picture, target);
  EXPECT_EQ(map.channels, 1);
  EXPECT_EQ(map.data, (std::vector{0.0F, 10.0F, 0.0F, 0.0F}));
}

TEST(ResidualMap, SumsToTheErrorTimesTheImportance) {
  Target target = flat_target(3, 2, Vec3(0.2F, 0.4F, 0.6F), 0.5F);
  const Image picture(3, 2, 3, 0.1F);
  double sum = 0.0;
  for (const float value : residual_map(picture, target).data) sum += static_cast<double>(value);
  EXPECT_NEAR(sum, picture_error(picture, target, {}) * 3.0, 1e-6);  // the map holds floats
}

TEST(MetricDeathTest, TakesASizeThatDiffersForOurBug) {
  const Target target = flat_target(3, 2, Vec3(0.0F), 1.0F);
  EXPECT_DEATH((void)picture_error(Image(2, 3, 3), target, {}), "all are of one size");
  EXPECT_DEATH((void)residual_map(Image(3, 2, 1), target), "three channels");
}

}  // namespace
}  // namespace luminist
