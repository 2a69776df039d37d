#include "paint/canvas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "paint/ball.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

constexpr int kCanvasWidth = 120;
constexpr int kCanvasHeight = 100;
constexpr int kMiddleX = 60;
constexpr int kMiddleY = 50;

class CanvasTest : public ::testing::Test {
 protected:
  [[nodiscard]] Canvas canvas() {
    return Canvas(
        surface_, picture_,
        [this](ShadowPicture which) -> Result<Image> {
          ++rendered_;
          return which == ShadowPicture::kFreeLightsOff ? dark_ : bright_;
        },
        [this](const std::string& /*path*/) -> Result<Image> { return copied_; });
  }
  [[nodiscard]] Vec3 before(int x, int y) const { return picture_.rgb(picture_.index(x, y)); }
  static Vec3 color(const Canvas& c, int x, int y) { return c.target().color.rgb(c.target().color.index(x, y)); }
  static std::uint32_t id(const Canvas& c, int x, int y) { return c.target().stroke[c.target().color.index(x, y)]; }
  static void expect_near(const Vec3& actual, const Vec3& wanted) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], wanted[c], 2e-5F) << c;  // float coordinates, sigma 5 pixels
  }
  static Brush of_tool(PaintTool tool) {
    Brush brush;
    brush.tool = tool;
    return brush;
  }
  static bool same(const CanvasState& a, const CanvasState& b) {
    return a.target.color.data == b.target.color.data && a.target.before.data == b.target.before.data &&
           a.target.importance.data == b.target.importance.data && a.target.stroke == b.target.stroke &&
           a.paint_left.data == b.paint_left.data && a.importance.paint.data == b.importance.paint.data &&
           a.importance.previous.data == b.importance.previous.data && a.strokes == b.strokes &&
           a.peak.has_value() == b.peak.has_value();
  }

  SurfaceBuffer surface_ = ball_surface(kCanvasWidth, kCanvasHeight);
  Image picture_ = varied_picture(kCanvasWidth, kCanvasHeight);
  Image dark_ = varied_picture(kCanvasWidth, kCanvasHeight, 0.02F);
  Image bright_ = varied_picture(kCanvasWidth, kCanvasHeight, 0.7F);
  Image copied_ = varied_picture(kCanvasWidth, kCanvasHeight, 0.5F);
  int rendered_ = 0;
  /// The middle of the middle pixel.
  static constexpr float kX = (kMiddleX + 0.5F) / kCanvasHeight;
  static constexpr float kY = (kMiddleY + 0.5F) / kCanvasHeight;
};

TEST_F(CanvasTest, StartsUnpainted) {
  const Canvas c = canvas();
  EXPECT_FALSE(c.painted());
  EXPECT_EQ(c.target().color.data, picture_.data);
  EXPECT_EQ(c.target().before.data, picture_.data);
}

TEST_F(CanvasTest, CompositesAStrokeByTheFormulasOfThePaper) {
  Brush brush;
  brush.color = {1.0F, 0.5F, 2.0F};
  brush.diameter = 0.2F;  // sigma is 5 pixels
  brush.opacity = 0.8F;
  brush.texture = 0.6F;
  brush.gradient = 0.7F;
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(brush, kX, kY), ""));
  const Vec3 peak = surface_.normal[surface_.index(kMiddleX, kMiddleY)];
  for (const int d : {0, 2, 5, 9, 15}) {
    const std::size_t pixel = surface_.index(kMiddleX + d, kMiddleY);
    const float alpha = 0.8F * std::exp(-static_cast<float>(d * d) / 50.0F);
    const Vec3 c_p = 0.4F * brush.color + 0.6F * brush.color * surface_.albedo[pixel];
    const Vec3 c_gamma = c_p * (0.3F + 0.7F * std::max(0.0F, glm::dot(surface_.normal[pixel], peak)));
    expect_near(color(c, kMiddleX + d, kMiddleY), (1.0F - alpha) * before(kMiddleX + d, kMiddleY) + alpha * c_gamma);
  }
}

TEST_F(CanvasTest, WithinOneStrokePaintDoesNotPileUp) {
  Brush brush = flat_brush();
  brush.opacity = 0.5F;
  Canvas c = canvas();
  const Stroke back_and_forth{brush, {{kX - 0.1F, kY}, {kX + 0.1F, kY}, {kX - 0.1F, kY}, {kX + 0.1F, kY}}};
  LUM_EXPECT_OK(c.apply(back_and_forth, ""));
  expect_near(color(c, kMiddleX, kMiddleY), 0.5F * before(kMiddleX, kMiddleY) + 0.5F * brush.color);
}

TEST_F(CanvasTest, AcrossStrokesPaintPilesUp) {
  Brush brush = flat_brush();
  brush.opacity = 0.5F;
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(brush, kX, kY), ""));
  LUM_EXPECT_OK(c.apply(click(brush, kX, kY), ""));
  expect_near(color(c, kMiddleX, kMiddleY), 0.25F * before(kMiddleX, kMiddleY) + 0.75F * brush.color);
}

TEST_F(CanvasTest, AddLightNeverDarkensAPixel) {
  Brush brush;
  brush.color = {1.0F, 0.0F, 0.15F};
  brush.gradient = 1.0F;
  brush.diameter = 0.6F;
  brush.add_light = true;
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(brush, kX, kY), ""));
  for (std::size_t i = 0; i < picture_.data.size(); ++i) ASSERT_GE(c.target().color.data[i], picture_.data[i]);
  EXPECT_TRUE(c.painted());
}

TEST_F(CanvasTest, PaintedIsWhatLiesInTheBrushesCircle) {
  Brush brush = flat_brush();
  brush.diameter = 0.2F;
  brush.opacity = 0.05F;  // a faint glaze is paint all the same
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(brush, kX, kY), ""));
  for (int y = 0; y < kCanvasHeight; ++y) {
    for (int x = 0; x < kCanvasWidth; ++x) {
      const double distance = std::hypot(x - kMiddleX, y - kMiddleY);
      if (std::abs(distance - 10.0) < 1e-6) continue;  // on the circle rounding decides
      EXPECT_EQ(id(c, x, y), distance < 10.0 ? 1U : 0U) << x << ", " << y;
      EXPECT_EQ(c.target().importance.at(x, y, 0), distance < 10.0 ? 1.0F : 0.1F);
    }
  }
}

TEST_F(CanvasTest, NumbersStrokesAndKeepsTheLastOnTop) {
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(flat_brush(), 0.3F, 0.5F), ""));
  LUM_EXPECT_OK(c.apply(click(of_tool(PaintTool::kImportance), 0.3F, 0.5F), ""));  // counted, but no colour
  LUM_EXPECT_OK(c.apply(click(flat_brush(), 0.9F, 0.5F), ""));
  EXPECT_EQ(id(c, 30, 50), 1U);
  EXPECT_EQ(id(c, 90, 50), 3U);
  c.rebase(picture_);
  EXPECT_FALSE(c.painted());
  LUM_EXPECT_OK(c.apply(click(flat_brush(), 0.3F, 0.5F), ""));
  EXPECT_EQ(id(c, 30, 50), 1U);
}

TEST_F(CanvasTest, TouchesOnlyTheBoxItReturns) {
  Brush brush = flat_brush();
  brush.diameter = 0.1F;
  Canvas c = canvas();
  LUM_ASSERT_OK(const PixelBox box, c.apply(click(brush, 0.3F, 0.4F), ""));
  EXPECT_LE(box.width(), 21);
  for (int y = 0; y < kCanvasHeight; ++y) {
    for (int x = 0; x < kCanvasWidth; ++x) {
      const bool inside = x >= box.x0 && x < box.x1 && y >= box.y0 && y < box.y1;
      if (inside) continue;
      ASSERT_EQ(color(c, x, y), before(x, y));
    }
  }
}

TEST_F(CanvasTest, AStrokeOfNoOpacityPaintsNothing) {
  Brush brush = flat_brush();
  brush.opacity = 0.0F;
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(brush, kX, kY), ""));
  EXPECT_FALSE(c.painted());
  EXPECT_EQ(c.target().color.data, picture_.data);
}

TEST_F(CanvasTest, PaintThatBehavesLikeLightLeavesTheBackgroundBlack) {
  picture_ = Image(kCanvasWidth, kCanvasHeight, 3, 0.0F);
  Brush brush;
  brush.bucket = true;
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply({brush, {}}, ""));
  EXPECT_EQ(color(c, 0, 0), Vec3(0.0F));
  EXPECT_EQ(color(c, 40, 50), Vec3(0.8F, 0.4F, 0.2F));  // white times the albedo
  brush.texture = 0.0F;
  LUM_EXPECT_OK(c.apply({brush, {}}, ""));
  EXPECT_EQ(color(c, 0, 0), Vec3(1.0F));
}

TEST_F(CanvasTest, BucketCoversEveryPixelOfTheObjectAndNoOther) {
  Brush brush = flat_brush();
  brush.bucket = true;
  brush.clip = "ball right";
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply({brush, {}}, ""));
  for (std::size_t i = 0; i < surface_.pixels(); ++i) {
    ASSERT_EQ(c.target().color.rgb(i), surface_.object[i] == 2 ? brush.color : picture_.rgb(i));
    ASSERT_EQ(c.target().stroke[i], surface_.object[i] == 2 ? 1U : 0U);
  }
}

TEST_F(CanvasTest, BucketBrightensAnObjectUniformly) {
  Brush brush = of_tool(PaintTool::kBrighten);
  brush.bucket = true;
  brush.clip = "@";
  brush.strength = 1.0F;
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(brush, 0.4F, 0.5F), ""));
  for (std::size_t i = 0; i < surface_.pixels(); ++i) {
    const Vec3 wanted = (surface_.object[i] == 1 ? 2.0F : 1.0F) * picture_.rgb(i);
    ASSERT_EQ(c.target().color.rgb(i), wanted);
  }
}

TEST_F(CanvasTest, ClipKeepsPaintOnTheObjectUnderTheFirstPoint) {
  Brush brush = flat_brush();
  brush.clip = "@";
  brush.diameter = 0.4F;
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply({brush, {{0.5F, 0.5F}, {0.7F, 0.5F}}}, ""));
  EXPECT_EQ(id(c, 55, 50), 1U);
  for (std::size_t i = 0; i < surface_.pixels(); ++i) {
    if (surface_.object[i] == 1) continue;
    ASSERT_EQ(c.target().color.rgb(i), picture_.rgb(i));
  }
}

TEST_F(CanvasTest, ClipToAnUnknownObjectNamesTheNearest) {
  Brush brush;
  brush.clip = "bal left";
  Canvas c = canvas();
  const Error error = error_of(c.apply(click(brush, kX, kY), ""));
  EXPECT_EQ(error.kind, ErrorKind::kBadContent);
  EXPECT_EQ(error.field, "clip");
  EXPECT_EQ(error.hint, "did you mean \"ball left\"?");
}

TEST_F(CanvasTest, ClipToNothingUnderTheFirstPointIsAnError) {
  Brush brush;
  brush.clip = "@";
  Canvas c = canvas();
  EXPECT_EQ(error_of(c.apply(click(brush, 0.01F, 0.01F), "")).field, "clip");
  EXPECT_EQ(error_of(c.apply(click(brush, -1.0F, 0.5F), "")).field, "clip");
}

TEST_F(CanvasTest, BrightenAndDarkenFollowStopsTimesCoverage) {
  Brush brush = of_tool(PaintTool::kBrighten);
  brush.diameter = 0.2F;
  brush.strength = 1.5F;
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(brush, kX, kY), ""));
  const float coverage = std::exp(-0.5F);  // one sigma away
  expect_near(color(c, kMiddleX + 5, kMiddleY), before(kMiddleX + 5, kMiddleY) * std::exp2(1.5F * coverage));
  brush.tool = PaintTool::kDarken;
  LUM_EXPECT_OK(c.apply(click(brush, kX, kY), ""));
  expect_near(color(c, kMiddleX + 5, kMiddleY), before(kMiddleX + 5, kMiddleY));
}

TEST_F(CanvasTest, ShadowBrushAndEraserCopyFromPicturesThatAreRenderedOnceEach) {
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(flat_brush(), kX, kY), ""));
  EXPECT_EQ(rendered_, 0);
  Brush brush = of_tool(PaintTool::kShadow);
  brush.bucket = true;
  LUM_EXPECT_OK(c.apply({brush, {}}, ""));
  EXPECT_EQ(c.target().color.data, dark_.data);
  EXPECT_EQ(rendered_, 1) << "the eraser's is not needed";
  brush.tool = PaintTool::kShadowEraser;
  LUM_EXPECT_OK(c.apply({brush, {}}, ""));
  EXPECT_EQ(c.target().color.data, bright_.data);
  LUM_EXPECT_OK(c.apply({brush, {}}, ""));
  EXPECT_EQ(rendered_, 2);
  c.rebase(picture_);
  LUM_EXPECT_OK(c.apply({brush, {}}, ""));
  EXPECT_EQ(rendered_, 3);
}

TEST_F(CanvasTest, ShadowOfHalfOpacityIsHalfAShadow) {
  Brush brush = of_tool(PaintTool::kShadow);
  brush.opacity = 0.5F;
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(brush, kX, kY), ""));
  const std::size_t middle = surface_.index(kMiddleX, kMiddleY);
  expect_near(color(c, kMiddleX, kMiddleY), 0.5F * dark_.rgb(middle) + 0.5F * picture_.rgb(middle));
}

TEST_F(CanvasTest, EraserBringsBackThePictureAndTheImpliedImportance) {
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(flat_brush(), kX, kY), ""));
  LUM_EXPECT_OK(c.apply(click(of_tool(PaintTool::kImportance), kX, kY), ""));
  Brush eraser = of_tool(PaintTool::kErase);
  eraser.bucket = true;
  LUM_EXPECT_OK(c.apply({eraser, {}}, ""));
  EXPECT_EQ(c.target().color.data, picture_.data);
  EXPECT_FALSE(c.painted());
  for (const float i : c.target().importance.data) ASSERT_FLOAT_EQ(i, 0.1F);
}

TEST_F(CanvasTest, EraserLeavesPaintPaintedUntilLittleIsLeft) {
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(flat_brush(), kX, kY), ""));
  Brush eraser = of_tool(PaintTool::kErase);
  eraser.opacity = 0.5F;
  for (const bool painted : {true, true, false}) {  // 1/2, 1/4, 1/8 left
    LUM_EXPECT_OK(c.apply(click(eraser, kX, kY), ""));
    EXPECT_EQ(id(c, kMiddleX, kMiddleY) != 0, painted);
  }
}

TEST_F(CanvasTest, ScreenGradientThinsThePaint) {
  Brush brush = flat_brush();
  brush.bucket = true;
  brush.gradient = 1.0F;
  brush.screen_gradient = true;
  Canvas c = canvas();
  const float pixel = 1.0F / kCanvasHeight;
  LUM_EXPECT_OK(c.apply({brush, {{20.5F * pixel, 0.5F}, {100.5F * pixel, 0.5F}}}, ""));
  expect_near(color(c, 40, 10), 0.25F * before(40, 10) + 0.75F * brush.color);
  EXPECT_EQ(color(c, 110, 10), before(110, 10));
  EXPECT_EQ(id(c, 110, 10), 0U);
}

TEST_F(CanvasTest, RepeatsThePeakOfTheLastStrokeThatHadAGradient) {
  Brush brush;
  brush.gradient = 1.0F;
  brush.bucket = true;
  Canvas wanted = canvas();
  LUM_EXPECT_OK(wanted.apply(click(brush, 0.4F, 0.5F), ""));
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(brush, 0.4F, 0.5F), ""));
  LUM_EXPECT_OK(c.apply(click(flat_brush(), 0.8F, 0.5F), ""));  // has none
  brush.repeat_peak = true;
  LUM_EXPECT_OK(c.apply(click(brush, 0.8F, 0.3F), ""));
  EXPECT_EQ(c.target().color.data, wanted.target().color.data);
}

TEST_F(CanvasTest, CopiedCanvasIsASnapshot) {
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(flat_brush(), 0.3F, 0.5F), ""));
  const Canvas before_stroke = c;
  LUM_EXPECT_OK(c.apply(click(of_tool(PaintTool::kImportance), kX, kY), ""));
  LUM_EXPECT_OK(c.apply(click(flat_brush(), kX, kY), ""));
  EXPECT_FALSE(same(c.state(), before_stroke.state()));
  c.restore(before_stroke.state());
  EXPECT_TRUE(same(c.state(), before_stroke.state()));
}

TEST_F(CanvasTest, IsUnchangedByAStrokeThatFails) {
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(click(flat_brush(), 0.3F, 0.5F), ""));
  const CanvasState kept = c.state();
  Brush brush = of_tool(PaintTool::kShadow);
  brush.clip = "nothing";
  EXPECT_FALSE(c.apply(click(brush, kX, kY), ""));
  EXPECT_EQ(rendered_, 0);  // nothing was rendered for it either
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(c.apply(click(flat_brush(), nan, kY), ""));
  EXPECT_FALSE(c.apply({flat_brush(), {}}, ""));
  brush = flat_brush();
  brush.color.y = nan;
  EXPECT_EQ(error_of(c.apply(click(brush, kX, kY), "")).field, "color");
  brush = flat_brush();
  brush.diameter = -0.1F;
  EXPECT_EQ(error_of(c.apply(click(brush, kX, kY), "")).field, "diameter");
  EXPECT_TRUE(same(c.state(), kept));
}

TEST_F(CanvasTest, AppliesAFileWholeOrNotAtAll) {
  Canvas c = canvas();
  StrokeFile file;
  file.nu = 0.4F;
  file.strokes = {click(flat_brush(), kX, kY), click(flat_brush(), kX, kY)};
  file.strokes[1].brush.clip = "ball lift";
  const CanvasState kept = c.state();
  const Error error = error_of(c.apply(file, "folder/paint.json"));
  EXPECT_EQ(error.where, "folder/paint.json");
  EXPECT_EQ(error.field, "strokes[1].clip");
  EXPECT_TRUE(same(c.state(), kept));
  EXPECT_EQ(c.state().importance.nu, kept.importance.nu);
  file.strokes[1].brush.clip = "ball left";
  LUM_EXPECT_OK(c.apply(file, "folder/paint.json"));
  EXPECT_EQ(c.state().strokes, 2U);
  EXPECT_FLOAT_EQ(c.target().importance.at(0, 0, 0), 0.4F);
}

}  // namespace
}  // namespace luminist
