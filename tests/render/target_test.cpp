#include "render/target.h"

#include <gtest/gtest.h>

#include <limits>

#include "render/metric.h"

namespace luminist {
namespace {

constexpr float kNanPaint = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

Target target() {
  Target target;
  target.color = Image(3, 2, 3, 0.5F);
  target.before = Image(3, 2, 3, 0.25F);
  target.importance = Image(3, 2, 1, 1.0F);
  return target;
}

TEST(Sanitize, LeavesAGoodTargetAlone) {
  Target t = target();
  const SanitizeReport report = sanitize(t);
  EXPECT_EQ(report.masked, 0U);
  EXPECT_EQ(report.first_x, -1);
  EXPECT_EQ(report.first_y, -1);
  EXPECT_EQ(t.color.data, target().color.data);
  EXPECT_EQ(t.importance.data, target().importance.data);
}

TEST(Sanitize, MasksWhatCannotBeComparedAndTellsWhereItBegins) {
  Target t = target();
  t.color.at(2, 0, 1) = kNanPaint;
  t.color.at(0, 1, 0) = -kInf;
  t.importance.at(1, 1, 0) = -0.5F;
  t.importance.at(2, 1, 0) = kInf;
  const SanitizeReport report = sanitize(t);
  EXPECT_EQ(report.masked, 4U);
  EXPECT_EQ(report.first_x, 2);
  EXPECT_EQ(report.first_y, 0);
  EXPECT_EQ(t.importance.data, (std::vector{1.0F, 1.0F, 0.0F, 0.0F, 0.0F, 0.0F}));
  EXPECT_EQ(t.color.rgb(2), Vec3(0.25F));  // the picture under the paint
  EXPECT_EQ(t.color.rgb(0), Vec3(0.5F));
}

TEST(Sanitize, PutsBlackWhereThePictureUnderThePaintIsNotFiniteEither) {
  Target t = target();
  t.color.at(1, 0, 0) = kNanPaint;
  t.before.at(1, 0, 2) = kInf;
  t.before.at(0, 0, 0) = kNanPaint;  // under good paint
  EXPECT_EQ(sanitize(t).masked, 1U);
  EXPECT_EQ(t.color.rgb(1), Vec3(0.0F));
  EXPECT_EQ(t.before.rgb(1), Vec3(0.0F));
  EXPECT_EQ(t.before.rgb(0), Vec3(0.0F));
  EXPECT_EQ(t.importance.data[0], 1.0F);
}

TEST(Sanitize, KeepsNegativeColoursWhichPaintMayHave) {
  Target t = target();
  t.color.at(0, 0, 0) = -3.0F;
  EXPECT_EQ(sanitize(t).masked, 0U);
  EXPECT_EQ(t.color.at(0, 0, 0), -3.0F);
}

TEST(Sanitize, GivesTheErrorOfTheTargetWithoutTheMaskedPixels) {
  const Image picture(3, 2, 3, 0.1F);
  Target masked = target();
  masked.importance.data[4] = 0.0F;
  Target broken = target();
  broken.color.at(1, 1, 0) = kNanPaint;
  sanitize(broken);
  EXPECT_EQ(picture_error(picture, broken, {}), picture_error(picture, masked, {}));
  // A blur carries the masked pixel's colour into its neighbours, which must stay finite.
  EXPECT_TRUE(std::isfinite(picture_error(picture, broken, StyleMetric{0.5F})));
}

}  // namespace
}  // namespace luminist
