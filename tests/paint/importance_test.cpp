#include "paint/importance.h"

#include <gtest/gtest.h>

#include "paint/ball.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

constexpr int kMapSide = 64;

Canvas::ShadowSource no_shadows() {
  return [](ShadowPicture) -> Result<Image> { return Error{ErrorKind::kGl, "no shadows here", "", "", ""}; };
}

/// Figure 4 of the paper: fruit painted in the past, the jug now. Left is the fruit, right the jug.
struct Figure4 {
  SurfaceBuffer surface = ball_surface(kMapSide, kMapSide);
  Canvas canvas{surface, Image(kMapSide, kMapSide, 3, 0.1F), no_shadows()};

  Figure4(float nu, float delta) {
    canvas.set_importance(nu, delta);
    fill("ball left");
    canvas.rebase(Image(kMapSide, kMapSide, 3, 0.2F));
    fill("ball right");
  }
  void fill(const std::string& object) {
    Brush brush;
    brush.bucket = true;
    brush.clip = object;
    LUM_EXPECT_OK(canvas.apply({brush, {}}, ""));
  }
  [[nodiscard]] float background() const { return canvas.target().importance.at(0, 0, 0); }
  [[nodiscard]] float fruit() const { return canvas.target().importance.at(kMapSide / 2 - 5, kMapSide / 2, 0); }
  [[nodiscard]] float jug() const { return canvas.target().importance.at(kMapSide / 2 + 5, kMapSide / 2, 0); }
};

TEST(Importance, FollowsFigure4ForEveryNuAndDelta) {
  for (const float nu : {0.0F, 0.2F, 0.7F, 1.0F}) {
    for (const float delta : {0.0F, 0.1F, 0.8F, 1.0F}) {
      const Figure4 f(nu, delta);
      EXPECT_FLOAT_EQ(f.jug(), 1.0F);
      EXPECT_FLOAT_EQ(f.fruit(), (1.0F - delta) * nu + delta * 1.0F);
      EXPECT_FLOAT_EQ(f.background(), (1.0F - delta) * nu + delta * nu);
    }
  }
}

TEST(Importance, OfAFreshCanvasIsNu) {
  const SurfaceBuffer surface = ball_surface(kMapSide, kMapSide);
  Canvas canvas(surface, Image(kMapSide, kMapSide, 3), no_shadows());
  canvas.set_importance(0.3F, 0.9F);
  for (const float i : canvas.target().importance.data) EXPECT_FLOAT_EQ(i, 0.3F);
  canvas.set_importance(0.6F, 0.2F);  // the previous map starts as nu, whatever nu becomes before the first solve
  for (const float i : canvas.target().importance.data) EXPECT_FLOAT_EQ(i, 0.6F);
}

TEST(Importance, DoesNotAdvanceUntilASolveIsAccepted) {
  Figure4 f(0.2F, 0.5F);
  const float fruit = f.fruit();
  f.fill("ball right");
  f.canvas.set_importance(0.9F, 0.9F);
  f.canvas.set_importance(0.2F, 0.5F);
  EXPECT_FLOAT_EQ(f.fruit(), fruit);
  f.canvas.rebase(Image(kMapSide, kMapSide, 3));
  EXPECT_FLOAT_EQ(f.fruit(), 0.5F * 0.2F + 0.5F * fruit);
  EXPECT_FLOAT_EQ(f.jug(), 0.5F * 0.2F + 0.5F * 1.0F);
}

TEST(Importance, PaintStartsFromTheImpliedMap) {
  Figure4 f(0.2F, 0.5F);
  Brush brush;
  brush.tool = PaintTool::kImportance;
  brush.importance = 0.0F;
  brush.opacity = 0.5F;
  brush.bucket = true;
  LUM_EXPECT_OK(f.canvas.apply(Stroke{brush, {}}, ""));
  EXPECT_FLOAT_EQ(f.jug(), 0.5F);
  EXPECT_FLOAT_EQ(f.fruit(), 0.5F * 0.6F);
  EXPECT_FLOAT_EQ(f.background(), 0.5F * 0.2F);
  f.canvas.set_importance(0.8F, 0.0F);  // the sliders still move what lies below
  EXPECT_FLOAT_EQ(f.background(), 0.5F * 0.8F);
}

TEST(Importance, PaintedByHandWinsOverColourPaintedLater) {
  Figure4 f(0.2F, 0.5F);
  Brush brush;
  brush.tool = PaintTool::kImportance;
  brush.importance = 0.0F;
  brush.bucket = true;
  LUM_EXPECT_OK(f.canvas.apply(Stroke{brush, {}}, ""));
  f.fill("ball left");
  EXPECT_FLOAT_EQ(f.fruit(), 0.0F);
}

TEST(Importance, PaintedByHandBecomesHistory) {
  Figure4 f(0.2F, 0.5F);
  Brush brush;
  brush.tool = PaintTool::kImportance;
  brush.importance = 0.0F;
  brush.bucket = true;
  LUM_EXPECT_OK(f.canvas.apply(Stroke{brush, {}}, ""));
  f.canvas.rebase(Image(kMapSide, kMapSide, 3));
  EXPECT_FLOAT_EQ(f.background(), 0.5F * 0.2F + 0.5F * 0.0F);
}

TEST(Importance, PaintAloneIsNoPaintInColour) {
  const SurfaceBuffer surface = ball_surface(kMapSide, kMapSide);
  Canvas canvas(surface, Image(kMapSide, kMapSide, 3), no_shadows());
  Brush brush;
  brush.tool = PaintTool::kImportance;
  LUM_EXPECT_OK(canvas.apply(click(brush, 0.5F, 0.5F), ""));
  EXPECT_FALSE(canvas.painted());
  EXPECT_GT(canvas.target().importance.at(kMapSide / 2, kMapSide / 2, 0), 0.9F);
}

/// A canvas in which a verdict's remedy has said how much counts what is not painted.
struct Remedied {
  SurfaceBuffer surface = ball_surface(kMapSide, kMapSide);
  Canvas canvas{surface, Image(kMapSide, kMapSide, 3), no_shadows()};

  Remedied() {
    canvas.set_importance(0.3F, 0.5F);
    LayerStack layers;
    layers.counts[0] = 0.05F;
    LUM_EXPECT_OK(canvas.relayer(std::move(layers), ""));
  }
  [[nodiscard]] float corner() const { return canvas.target().importance.at(0, 0, 0); }
  [[nodiscard]] float middle() const { return canvas.target().importance.at(kMapSide / 2, kMapSide / 2, 0); }
};

TEST(Importance, PaintedWinsOverWhatARemedySays) {
  Remedied r;
  EXPECT_FLOAT_EQ(r.middle(), 0.05F);
  Brush brush;
  brush.tool = PaintTool::kImportance;
  brush.importance = 0.8F;
  brush.diameter = 0.5F;
  LUM_EXPECT_OK(r.canvas.apply({brush, {{0.5F, 0.5F}}}, ""));
  EXPECT_NEAR(r.middle(), 0.8F, 0.01F) << "a dab is a little less beside its middle";
  EXPECT_FLOAT_EQ(r.corner(), 0.05F);
}

TEST(Importance, TurningNuOrDeltaWinsOverWhatARemedySays) {
  Remedied r;
  r.canvas.set_importance(0.3F, 0.5F);
  EXPECT_FLOAT_EQ(r.corner(), 0.05F) << "nothing was turned";
  r.canvas.set_importance(0.4F, 0.5F);
  EXPECT_FLOAT_EQ(r.corner(), 0.4F);
}

}  // namespace
}  // namespace luminist
