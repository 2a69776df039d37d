#include "paint/compositing.h"

#include <gtest/gtest.h>

namespace luminist {
namespace {

const Vec3 kBelow{0.2F, 0.5F, 1.5F};
const Vec3 kAlbedo{0.5F, 0.25F, 1.0F};

Dose dose(float amount, float shading = 1.0F) {
  Dose d;
  d.coverage = amount;
  d.amount = amount;
  d.shading = shading;
  return d;
}

void expect_color(const Vec3& actual, const Vec3& wanted) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], wanted[c], 1e-6F) << c;  // a few roundings of numbers near 1
}

TEST(Compositing, OfPlainPaintIsTheOverOperator) {
  Brush brush;
  brush.color = {1.0F, 0.0F, 2.0F};
  brush.texture = 0.0F;
  expect_color(composited(brush, kBelow, kAlbedo, dose(0.25F)), 0.75F * kBelow + 0.25F * brush.color);
}

TEST(Compositing, TextureStrengthMixesTheColourWithColourTimesAlbedo) {
  Brush brush;
  brush.color = {1.0F, 0.8F, 2.0F};
  brush.texture = 0.3F;
  const Vec3 textured = 0.7F * brush.color + 0.3F * brush.color * kAlbedo;
  expect_color(composited(brush, kBelow, kAlbedo, dose(1.0F)), textured);
}

TEST(Compositing, GradientShadesTheColourNotTheOpacity) {
  Brush brush;
  brush.color = {1.0F, 0.8F, 2.0F};
  brush.texture = 0.0F;
  expect_color(composited(brush, kBelow, kAlbedo, dose(0.5F, 0.2F)), 0.5F * kBelow + 0.5F * 0.2F * brush.color);
}

TEST(Compositing, AddLightNeverDarkensAnyChannel) {
  Brush brush;
  brush.color = {1.0F, 0.1F, 1.0F};
  brush.texture = 0.0F;
  brush.add_light = true;
  expect_color(composited(brush, kBelow, kAlbedo, dose(0.5F)), {0.6F, 0.5F, 1.5F});
}

TEST(Compositing, BrightenMultipliesByPowersOfTwoAndDarkenUndoesIt) {
  Brush brush;
  brush.tool = PaintTool::kBrighten;
  brush.strength = 2.0F;
  const Vec3 brighter = composited(brush, kBelow, kAlbedo, dose(0.5F));
  expect_color(brighter, 2.0F * kBelow);
  brush.tool = PaintTool::kDarken;
  expect_color(composited(brush, brighter, kAlbedo, dose(0.5F)), kBelow);
}

TEST(Compositing, BrightenStaysFiniteHoweverOftenItIsRepeated) {
  Brush brush;
  brush.tool = PaintTool::kBrighten;
  brush.strength = 16.0F;
  Vec3 color = kBelow;
  for (int i = 0; i < 20; ++i) color = composited(brush, color, kAlbedo, dose(1.0F));
  expect_color(color, Vec3(kBrightest));
}

TEST(Compositing, CopyIsOverWithPremultipliedAlpha) {
  Brush brush;
  brush.tool = PaintTool::kCopy;
  Dose d = dose(0.5F);
  d.source = {0.3F, 0.1F, 0.0F, 0.5F};
  expect_color(composited(brush, kBelow, kAlbedo, d), 0.75F * kBelow + 0.5F * Vec3(0.3F, 0.1F, 0.0F));
}

TEST(Compositing, AddLightDoesNotStopTheEraser) {
  Brush brush;
  brush.tool = PaintTool::kErase;
  brush.add_light = true;
  Dose d = dose(1.0F);
  d.source = {0.0F, 0.1F, 0.2F, 1.0F};
  expect_color(composited(brush, kBelow, kAlbedo, d), {0.0F, 0.1F, 0.2F});
}

TEST(Compositing, OnlyAGradientByNormalsOfTheColourToolShades) {
  Brush brush;
  EXPECT_FALSE(fades_amount(brush));
  brush.screen_gradient = true;
  EXPECT_TRUE(fades_amount(brush));
  brush.screen_gradient = false;
  brush.tool = PaintTool::kBrighten;
  EXPECT_TRUE(fades_amount(brush));
}

}  // namespace
}  // namespace luminist
