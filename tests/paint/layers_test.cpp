// Layers of strokes: the composite is a function of the stack, however it came about.
#include <gtest/gtest.h>

#include <random>

#include "paint/canvas_fixture.h"

namespace luminist {
namespace {

class LayersTest : public CanvasOnBall {
 protected:
  static constexpr std::size_t kMiddle = 35 * kWidth + 45;

  /// The layers of a canvas laid once more from nothing.
  Canvas again(const Canvas& canvas) {
    Canvas other = canvas;
    LUM_EXPECT_OK(other.relayer(canvas.state().layers, folder_.path()));
    return other;
  }
  static LayerStack layers(std::size_t count) {
    LayerStack stack;
    while (stack.layers.size() < count) stack.layers.push_back({.name = stack.unused_name()});
    return stack;
  }
  Stroke random_stroke() {
    const auto share = [&] { return static_cast<float>(random_() % 1000) / 1000.0F; };
    Stroke stroke;
    stroke.brush.tool = static_cast<PaintTool>(random_() % 8);
    stroke.brush.copy_from = stroke.brush.tool == PaintTool::kCopy ? "x.exr" : "";
    stroke.brush.color = Vec3(share(), share(), 1.5F * share());
    stroke.brush.diameter = 0.1F + 0.3F * share();
    stroke.brush.opacity = share();
    stroke.brush.gradient = random_() % 2 == 0 ? 0.0F : share();
    stroke.brush.repeat_peak = random_() % 3 == 0;
    stroke.brush.screen_gradient = random_() % 4 == 0;
    stroke.brush.add_light = random_() % 3 == 0;
    stroke.brush.bucket = random_() % 7 == 0;
    stroke.brush.clip = random_() % 3 == 0 ? "ball left" : "";
    stroke.points = {{0.5F, 0.5F}, {0.45F + 0.4F * share(), 0.3F + 0.4F * share(), share()}, {share(), share()}};
    return stroke;
  }
  /// Blue over all of the middle, as it is.
  static Stroke blue() {
    Brush brush = flat_brush();
    brush.color = Vec3(0.0F, 0.0F, 1.0F);
    brush.bucket = true;
    return click(brush, 0.6F, 0.5F);
  }

  std::mt19937 random_{7};
};

TEST_F(LayersTest, StrokesLaidAgainAreTheSameBits) {
  Canvas c = canvas();
  for (int i = 0; i < 40; ++i) LUM_EXPECT_OK(c.apply(random_stroke(), folder_.path()));
  EXPECT_EQ(c.state().layers.strokes.size(), 40U);
  expect_same(c.state(), again(c).state());
}

TEST_F(LayersTest, PaintingBetweenLayersIsAsLayingThemAllAnew) {
  Canvas c = canvas();
  LayerStack stack = layers(4);
  stack.layers[1].opacity = 0.6F;
  stack.layers[2].visible = false;
  stack.layers[3].opacity = 0.3F;
  LUM_EXPECT_OK(c.relayer(stack, ""));
  for (int i = 0; i < 60; ++i) {
    c.choose_layer(std::array{0U, 1U, 3U}[random_() % 3]);
    LUM_EXPECT_OK(c.apply(random_stroke(), folder_.path()));
    if (i % 6 == 0) expect_same(c.state(), again(c).state());
  }
  expect_same(c.state(), again(c).state());
}

TEST_F(LayersTest, AStrokeThatArrivesPointByPointIsTheSameAmongLayers) {
  Canvas base = canvas();
  LayerStack stack = layers(3);
  stack.layers[1].opacity = 0.5F;
  LUM_EXPECT_OK(base.relayer(stack, ""));
  for (const std::size_t layer : {0U, 1U, 2U}) {
    base.choose_layer(layer);
    for (int i = 0; i < 5; ++i) LUM_EXPECT_OK(base.apply(random_stroke(), folder_.path()));
  }
  for (int i = 0; i < 24; ++i) {
    Stroke stroke = random_stroke();
    stroke.brush.bucket = false;
    base.choose_layer(static_cast<std::size_t>(i) % 3);
    Canvas once = base;
    Canvas live = base;
    LUM_EXPECT_OK(once.apply(stroke, folder_.path()));
    LUM_EXPECT_OK(live.begin_stroke({stroke.brush, {stroke.points[0]}}, folder_.path()));
    LUM_EXPECT_OK(live.extend_stroke(std::span(stroke.points).subspan(1, 1)));
    LUM_EXPECT_OK(live.extend_stroke(std::span(stroke.points).subspan(2)));
    LUM_EXPECT_OK(live.end_stroke());
    expect_same(once.state(), live.state());
    expect_same(once.state(), again(live).state());
  }
}

TEST_F(LayersTest, ALayerIsShownAsMuchAsItsOpacitySays) {
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(blue(), ""));
  for (const float opacity : {1.0F, 0.25F}) {
    LayerStack stack = c.state().layers;
    stack.layers[0].opacity = opacity;
    LUM_EXPECT_OK(c.relayer(stack, ""));
    const Vec3 before = picture_.rgb(kMiddle);
    const Vec3 shown = c.target().color.rgb(kMiddle);
    EXPECT_FLOAT_EQ(shown.z, before.z + opacity * (1.0F - before.z));
    EXPECT_EQ(c.target().importance.data[kMiddle], 1.0F) << "a faint layer is as deliberate as a thick one";
  }
  for (const bool hidden : {true, false}) {
    LayerStack stack = c.state().layers;
    stack.layers[0].visible = !hidden;
    stack.layers[0].opacity = hidden ? 1.0F : 0.0F;
    LUM_EXPECT_OK(c.relayer(stack, ""));
    EXPECT_EQ(c.target().color.data, picture_.data);
    EXPECT_FALSE(c.painted());
  }
}

TEST_F(LayersTest, AnEraserTakesItsOwnLayersPaint) {
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(blue(), ""));
  const Image below = c.target().color;
  LUM_EXPECT_OK(c.relayer(
      [&] {
        LayerStack stack = c.state().layers;
        stack.layers.push_back({.name = "above"});
        stack.active = 1;
        return stack;
      }(),
      ""));
  Stroke red = blue();
  red.brush.color = Vec3(1.0F, 0.0F, 0.0F);
  LUM_EXPECT_OK(c.apply(red, ""));
  EXPECT_EQ(c.target().stroke[kMiddle], 2U);
  Stroke eraser = red;
  eraser.brush.tool = PaintTool::kErase;
  LUM_EXPECT_OK(c.apply(eraser, ""));
  EXPECT_EQ(c.target().color.data, below.data);
  EXPECT_EQ(c.target().stroke[kMiddle], 1U);
}

TEST_F(LayersTest, ThePaintOfAHiddenLayerCannotGrow) {
  Canvas c = canvas();
  LayerStack stack;
  stack.layers[0].visible = false;
  LUM_EXPECT_OK(c.relayer(stack, ""));
  EXPECT_EQ(error_of(c.apply(blue(), "")).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(c.begin_stroke(click(flat_brush(), 0.5F, 0.5F), "")).field, "layer");
  EXPECT_EQ(c.state().strokes, 0U);
}

TEST_F(LayersTest, AStrokeThatIsChangedIsAsIfPaintedSo) {
  Canvas wanted = canvas();
  Canvas c = canvas();
  std::vector<Stroke> strokes;
  for (int i = 0; i < 8; ++i) strokes.push_back(random_stroke());
  for (const Stroke& stroke : strokes) LUM_EXPECT_OK(c.apply(stroke, folder_.path()));
  strokes[3].brush = flat_brush();
  strokes[3].brush.tool = PaintTool::kShadow;
  strokes[3].points[0].x += 0.1F;
  for (Stroke& stroke : strokes) {
    stroke.brush.repeat_peak = false;  // the peak of a stroke before it is another matter
    LUM_EXPECT_OK(wanted.apply(stroke, folder_.path()));
  }
  LayerStack stack = c.state().layers;
  for (std::uint32_t i = 1; i <= 8; ++i) {
    stack.strokes[i] = std::make_shared<const KeptStroke>(KeptStroke{strokes[i - 1]});
  }
  LUM_EXPECT_OK(c.relayer(stack, folder_.path()));
  expect_same(c.state(), wanted.state());
}

TEST_F(LayersTest, AStrokeKeepsItsNumberWhenOthersGo) {
  Canvas c = canvas();
  for (int i = 0; i < 3; ++i) LUM_EXPECT_OK(c.apply(blue(), ""));
  LayerStack stack = c.state().layers;
  stack.strokes.erase(2);
  stack.layers[0].strokes = {1, 3};
  LUM_EXPECT_OK(c.relayer(stack, ""));
  EXPECT_EQ(c.target().stroke[kMiddle], 3U);
  LUM_EXPECT_OK(c.apply(blue(), ""));
  EXPECT_EQ(c.target().stroke[kMiddle], 4U);
  stack = LayerStack();
  LUM_EXPECT_OK(c.relayer(stack, ""));
  EXPECT_EQ(c.state().strokes, 0U) << "without strokes it is as unpainted";
  EXPECT_EQ(c.target().color.data, picture_.data);
}

TEST_F(LayersTest, WhatAStrokeCountsStandsAboveAllElse) {
  Canvas c = canvas();
  Stroke small = click(flat_brush(), 0.6F, 0.5F);
  LUM_EXPECT_OK(c.apply(small, ""));
  LayerStack stack = c.state().layers;
  stack.counts[1] = 3.0F;
  stack.counts[0] = 0.5F;
  LUM_EXPECT_OK(c.relayer(stack, ""));
  for (std::size_t i = 0; i < c.target().stroke.size(); ++i) {
    EXPECT_EQ(c.target().importance.data[i], c.target().stroke[i] == 1 ? 3.0F : 0.5F);
  }
}

TEST_F(LayersTest, StrokesThatCannotBeLaidLeaveTheCanvasAlone) {
  Canvas c = canvas();
  LUM_EXPECT_OK(c.apply(blue(), ""));
  const CanvasState before = c.state();
  LayerStack stack = before.layers;
  KeptStroke lost = *stack.strokes[1];
  lost.stroke.brush.clip = "ball lfet";
  stack.strokes[1] = std::make_shared<const KeptStroke>(lost);
  const Error error = error_of(c.relayer(stack, ""));
  EXPECT_EQ(error.field, "strokes[1].clip");
  EXPECT_NE(error.hint.find("ball left"), std::string::npos);
  stack = before.layers;
  stack.layers.push_back({.name = "Layer 1"});
  EXPECT_EQ(error_of(c.relayer(stack, "")).kind, ErrorKind::kBadContent);
  expect_same(c.state(), before);
}

TEST_F(LayersTest, StrokesUnderAPlaceAreToldFromAbove) {
  Canvas c = canvas();
  Brush brush = flat_brush();
  brush.diameter = 0.2F;
  LUM_EXPECT_OK(c.apply({brush, {{0.3F, 0.5F}, {0.9F, 0.5F}}}, ""));
  LUM_EXPECT_OK(c.apply({brush, {{0.6F, 0.2F}, {0.6F, 0.8F}}}, ""));
  brush.bucket = true;
  brush.clip = "ball left";
  LUM_EXPECT_OK(c.apply(click(brush, 0.0F, 0.0F), ""));
  const LayerStack& stack = c.state().layers;
  using Numbers = std::vector<std::uint32_t>;
  EXPECT_EQ(strokes_under(stack, surface_, {0.6F, 0.5F}), (Numbers{3, 2, 1}));
  EXPECT_EQ(strokes_under(stack, surface_, {0.85F, 0.55F}), (Numbers{1}));
  EXPECT_EQ(strokes_under(stack, surface_, {0.85F, 0.65F}), (Numbers{}));
  EXPECT_EQ(strokes_under(stack, surface_, {-1.0F, 0.5F}), (Numbers{}));
  LayerStack hidden = stack;
  hidden.layers[0].visible = false;
  EXPECT_EQ(strokes_under(hidden, surface_, {0.6F, 0.5F}), (Numbers{}));
}

}  // namespace
}  // namespace luminist
