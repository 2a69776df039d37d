#include <gtest/gtest.h>

#include <limits>

#include "paint/canvas_fixture.h"

namespace luminist {
namespace {

class OpenStrokeTest : public CanvasOnBall {
 protected:
  /// Across the ball and its edge, with a loop over itself.
  static std::vector<StrokePoint> points() {
    return {{0.4F, 0.4F, 1.0F}, {0.5F, 0.5F, 0.7F},  {0.7F, 0.45F, 1.0F}, {0.6F, 0.3F, 0.4F},
            {0.5F, 0.5F, 1.0F}, {0.95F, 0.9F, 0.2F}, {0.9F, 0.2F, 1.0F}};
  }
  static void expect_same(const CanvasState& a, const CanvasState& b) {
    CanvasOnBall::expect_same(a, b);
    EXPECT_EQ(a.peak.has_value(), b.peak.has_value());
  }
  /// Paint of both kinds underneath.
  static void prepare(Canvas& c) {
    Brush brush;
    brush.diameter = 0.3F;
    LUM_EXPECT_OK(c.apply(click(brush, 0.6F, 0.4F), ""));
  }
};

TEST_F(OpenStrokeTest, PaintsTheSameBitsPointByPointAsAtOnceWithEveryTool) {
  for (const PaintTool tool :
       {PaintTool::kColor, PaintTool::kBrighten, PaintTool::kDarken, PaintTool::kCopy, PaintTool::kShadow,
        PaintTool::kShadowEraser, PaintTool::kErase, PaintTool::kImportance}) {
    for (const bool screen : {false, true}) {
      Stroke stroke{{}, points()};
      stroke.brush.tool = tool;
      stroke.brush.copy_from = tool == PaintTool::kCopy ? "x.exr" : "";
      stroke.brush.diameter = 0.25F;
      stroke.brush.opacity = 0.7F;
      stroke.brush.gradient = 0.6F;
      stroke.brush.screen_gradient = screen;
      stroke.brush.clip = tool == PaintTool::kColor ? "@" : "";
      Canvas once = canvas();
      prepare(once);
      Canvas live = once;
      LUM_EXPECT_OK(once.apply(stroke, folder_.path()));
      LUM_EXPECT_OK(live.begin_stroke({stroke.brush, {points()[0]}}, folder_.path()));
      LUM_EXPECT_OK(live.extend_stroke(std::span(stroke.points).subspan(1, 1)));
      LUM_EXPECT_OK(live.extend_stroke(std::span(stroke.points).subspan(2, 3)));
      LUM_EXPECT_OK(live.extend_stroke(std::span(stroke.points).subspan(5)));
      LUM_EXPECT_OK(live.end_stroke());
      expect_same(once.state(), live.state());
    }
  }
}

TEST_F(OpenStrokeTest, IsAtAnyTimeWhatItsPointsSoFarMake) {
  Stroke stroke{{}, points()};
  stroke.brush.gradient = 1.0F;
  Canvas live = canvas();
  LUM_EXPECT_OK(live.begin_stroke({stroke.brush, {stroke.points[0]}}, ""));
  for (std::size_t count = 1; count <= stroke.points.size(); ++count) {
    if (count > 1) LUM_EXPECT_OK(live.extend_stroke(std::span(stroke.points).subspan(count - 1, 1)));
    Canvas once = canvas();
    Stroke part = stroke;
    part.points.resize(count);
    LUM_EXPECT_OK(once.apply(part, ""));
    expect_same(once.state(), live.state());
  }
}

TEST_F(OpenStrokeTest, NamesABoxOutsideOfWhichNothingChanges) {
  Stroke stroke{flat_brush(), {{0.3F, 0.3F}}};
  Canvas live = canvas();
  LUM_EXPECT_OK(live.begin_stroke(stroke, ""));
  for (const StrokePoint& point : points()) {
    const Target before = live.target();
    LUM_ASSERT_OK(const PixelBox box, live.extend_stroke({&point, 1}));
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        if (x >= box.x0 && x < box.x1 && y >= box.y0 && y < box.y1) continue;
        const std::size_t i = before.color.index(x, y);
        ASSERT_EQ(before.color.rgb(i), live.target().color.rgb(i));
        ASSERT_EQ(before.importance.data[i], live.target().importance.data[i]);
      }
    }
  }
}

TEST_F(OpenStrokeTest, LaysNothingUntilItsGradientMeetsASurface) {
  Stroke stroke{{}, {{0.05F, 0.05F}, {0.1F, 0.1F}, {0.6F, 0.5F}}};
  stroke.brush.gradient = 1.0F;
  Canvas live = canvas();
  LUM_EXPECT_OK(live.begin_stroke({stroke.brush, {stroke.points[0]}}, ""));
  LUM_EXPECT_OK(live.extend_stroke(std::span(stroke.points).subspan(1, 1)));
  EXPECT_EQ(live.target().color.data, picture_.data);
  Canvas given_up = live;
  LUM_EXPECT_OK(live.extend_stroke(std::span(stroke.points).subspan(2)));
  LUM_EXPECT_OK(live.end_stroke());
  Canvas once = canvas();
  LUM_EXPECT_OK(once.apply(stroke, ""));
  expect_same(once.state(), live.state());
  EXPECT_EQ(error_of(given_up.end_stroke()).field, "gradient");
  expect_same(canvas().state(), given_up.state());
}

TEST_F(OpenStrokeTest, RefusesPointsThatAreNotFiniteAndGoesOn) {
  Canvas live = canvas();
  LUM_EXPECT_OK(live.begin_stroke(click(flat_brush(), 0.5F, 0.5F), ""));
  const StrokePoint bad{std::numeric_limits<float>::quiet_NaN(), 0.5F, 1.0F};
  EXPECT_EQ(error_of(live.extend_stroke({&bad, 1})).kind, ErrorKind::kBadContent);
  const StrokePoint good{0.6F, 0.5F, 1.0F};
  LUM_EXPECT_OK(live.extend_stroke({&good, 1}));
  LUM_EXPECT_OK(live.end_stroke());
  EXPECT_TRUE(live.painted());
}

}  // namespace
}  // namespace luminist
