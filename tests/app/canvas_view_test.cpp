#include "app/canvas_view.h"

#include <gtest/gtest.h>

namespace luminist {
namespace {

CanvasView placed() {
  CanvasView view;
  view.place({{100.0F, 50.0F}, {900.0F, 650.0F}}, 640, 480);
  return view;
}

TEST(CanvasView, APictureThatNobodyMovedFillsItsPlace) {
  CanvasView view = placed();
  const Vec2 center = view.to_screen({320.0F, 240.0F});
  EXPECT_FLOAT_EQ(center.x, 500.0F);
  EXPECT_FLOAT_EQ(center.y, 350.0F);
  view.place({{100.0F, 50.0F}, {420.0F, 650.0F}}, 640, 480);
  EXPECT_LT(640.0F * view.zoom(), 320.0F);
  EXPECT_GT(640.0F * view.zoom(), 280.0F);
}

TEST(CanvasView, ZoomingKeepsThePlaceUnderThePointer) {
  CanvasView view = placed();
  const Vec2 pointer(300.0F, 200.0F);
  const Vec2 before = view.to_picture(pointer);
  view.zoom_by(2.0F, pointer);
  // Floats of some hundred pixels: a thousandth of a pixel is rounding.
  EXPECT_NEAR(view.to_picture(pointer).x, before.x, 1e-3F);
  EXPECT_NEAR(view.to_picture(pointer).y, before.y, 1e-3F);
}

TEST(CanvasView, ZoomStaysInItsLimitsAndSomeOfThePictureInSight) {
  CanvasView view = placed();
  for (int i = 0; i < 100; ++i) view.zoom_by(2.0F, {500.0F, 350.0F});
  EXPECT_EQ(view.zoom(), CanvasView::kMostZoom);
  view.pan({1e9F, -1e9F});
  const Vec2 seen = view.to_picture(view.rect().center());
  EXPECT_TRUE(seen.x >= 0.0F && seen.x <= 640.0F && seen.y >= 0.0F && seen.y <= 480.0F);
}

TEST(CanvasView, ScreenAndPictureAreInverse) {
  CanvasView view = placed();
  view.zoom_by(3.7F, {222.0F, 333.0F});
  view.pan({-17.0F, 40.0F});
  const Vec2 there = view.to_picture(view.to_screen({12.5F, 400.25F}));
  EXPECT_NEAR(there.x, 12.5F, 1e-3F);
  EXPECT_NEAR(there.y, 400.25F, 1e-3F);
}

TEST(CanvasView, AnotherPictureIsFittedAnew) {
  CanvasView view = placed();
  view.zoom_by(8.0F, {500.0F, 350.0F});
  view.place(view.rect(), 320, 240);
  EXPECT_FLOAT_EQ(view.to_screen({160.0F, 120.0F}).x, 500.0F);
}

}  // namespace
}  // namespace luminist
