#pragma once
// tests/paint/canvas_fixture.h -- canvases on the ball, with something to copy and something to take shadows from.
#include <gtest/gtest.h>

#include <fstream>

#include "paint/ball.h"
#include "support/fixtures.h"

namespace luminist {

/// 90 x 70 pixels; "x.exr" can be copied from.
class CanvasOnBall : public ::testing::Test {
 protected:
  static constexpr int kWidth = 90;
  static constexpr int kHeight = 70;

  CanvasOnBall() { std::ofstream(folder_.file("x.exr")) << "read by the reader of the canvas"; }
  [[nodiscard]] Canvas canvas() const {
    return Canvas(
        surface_, picture_,
        [](ShadowPicture which) -> Result<Image> {
          return varied_picture(kWidth, kHeight, which == ShadowPicture::kFreeLightsOff ? 0.02F : 0.7F);
        },
        [](const std::string& /*path*/) -> Result<Image> { return varied_picture(kWidth, kHeight, 0.5F); });
  }
  static void expect_same(const CanvasState& a, const CanvasState& b) {
    EXPECT_EQ(a.target.color.data, b.target.color.data);
    EXPECT_EQ(a.target.importance.data, b.target.importance.data);
    EXPECT_EQ(a.target.stroke, b.target.stroke);
    EXPECT_EQ(a.paint_left.data, b.paint_left.data);
    EXPECT_EQ(a.importance.paint.data, b.importance.paint.data);
    EXPECT_EQ(a.strokes, b.strokes);
  }

  TemporaryFolder folder_;
  SurfaceBuffer surface_ = ball_surface(kWidth, kHeight);
  Image picture_ = varied_picture(kWidth, kHeight);
};

}  // namespace luminist
