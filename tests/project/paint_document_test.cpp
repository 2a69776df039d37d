#include "project/paint_document.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "project/layer_document.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

/// A flat wall that fills the picture.
SurfaceBuffer wall(int width, int height) {
  SurfaceBuffer surface;
  surface.width = width;
  surface.height = height;
  const std::size_t pixels = surface.pixels();
  surface.eye = Vec3(0.0F, 0.0F, 5.0F);
  surface.position.assign(pixels, Vec3(0.0F));
  surface.normal.assign(pixels, Vec3(0.0F, 0.0F, 1.0F));
  surface.albedo.assign(pixels, Vec3(0.5F));
  surface.specular.assign(pixels, Vec3(0.04F));
  surface.roughness.assign(pixels, 0.5F);
  surface.object.assign(pixels, 1U);
  surface.material.assign(pixels, 1U);
  surface.object_names = {"", "wall"};
  return surface;
}

bool same_bits(const Image& one, const Image& other) {
  return one.data.size() == other.data.size() &&
         std::memcmp(one.data.data(), other.data.data(), one.data.size() * sizeof(float)) == 0;
}

Stroke stroke_at(float x, float y) {
  Stroke stroke;
  stroke.brush.diameter = 0.2F;
  stroke.brush.gradient = 0.5F;
  stroke.points = {{x, y}};
  return stroke;
}

/// 150 x 70 pixels are 3 x 2 tiles, the last of them cut.
struct Painted {
  SurfaceBuffer surface = wall(150, 70);
  Image picture = Image(150, 70, 3, 0.2F);
  Canvas canvas = Canvas(surface, picture, nullptr);
};

TEST(PaintDocument, KeepsEveryBitOfACanvas) {
  Painted painted;
  painted.canvas.set_importance(0.3F, 0.7F);
  LUM_EXPECT_OK(painted.canvas.apply(stroke_at(0.5F, 0.5F), ""));
  painted.canvas.rebase(painted.picture);
  LUM_EXPECT_OK(painted.canvas.apply(stroke_at(0.7F, 0.4F), ""));
  Stroke importance = stroke_at(1.5F, 0.5F);
  importance.brush.tool = PaintTool::kImportance;
  importance.brush.gradient = 0.0F;
  LUM_EXPECT_OK(painted.canvas.apply(importance, ""));

  Document document;
  TileStore tiles;
  LUM_EXPECT_OK(write_paint(painted.canvas.state(), document, tiles));
  EXPECT_TRUE(has_paint(document));
  Canvas fresh(painted.surface, painted.picture, nullptr);
  LUM_ASSERT_OK(const CanvasState read, read_paint(document, tiles, fresh.state()));
  const CanvasState& written = painted.canvas.state();
  EXPECT_TRUE(same_bits(read.target.color, written.target.color));
  EXPECT_TRUE(same_bits(read.target.before, written.target.before));
  EXPECT_TRUE(same_bits(read.target.importance, written.target.importance));
  EXPECT_TRUE(same_bits(read.paint_left, written.paint_left));
  EXPECT_TRUE(same_bits(read.importance.previous, written.importance.previous));
  EXPECT_TRUE(same_bits(read.importance.paint, written.importance.paint));
  EXPECT_EQ(read.target.stroke, written.target.stroke);
  EXPECT_EQ(read.strokes, written.strokes);
  ASSERT_EQ(read.peak.has_value(), written.peak.has_value());
  EXPECT_EQ(read.peak->direction, written.peak->direction);
  EXPECT_EQ(read.importance.nu, 0.3F);
  EXPECT_EQ(read.importance.delta, 0.7F);
}

TEST(PaintDocument, AStrokeChangesTheTilesUnderIt) {
  Painted painted;
  Document before;
  Document after;
  TileStore tiles;
  LUM_EXPECT_OK(painted.canvas.apply(stroke_at(0.3F, 0.3F), ""));
  LUM_EXPECT_OK(write_paint(painted.canvas.state(), before, tiles));
  LUM_EXPECT_OK(painted.canvas.apply(stroke_at(0.3F, 0.3F), ""));
  LUM_EXPECT_OK(write_paint(painted.canvas.state(), after, tiles));
  for (const Edit& edit : difference(before, after)) {
    // The dab has a radius of 7 pixels around (21, 21), its tail ends within the first tile.
    const bool in_first_tile = edit.path.ends_with("/0,0");
    const bool of_strokes =
        edit.path == "paint/strokes" || edit.path == "paint/layers/0" || edit.path == "paint/kept/2";
    EXPECT_TRUE(in_first_tile || of_strokes) << edit.path;
  }
}

TEST(PaintDocument, WritesAnEvenTileAsItsValue) {
  Painted painted;
  LUM_EXPECT_OK(painted.canvas.apply(stroke_at(0.3F, 0.3F), ""));
  Document document;
  TileStore tiles;
  LUM_EXPECT_OK(write_paint(painted.canvas.state(), document, tiles));
  EXPECT_EQ(document.get("paint/before/2,1"), "[0.2,0.2,0.2]");
  EXPECT_EQ(document.get("paint/stroke/2,1"), "0.0");
}

TEST(PaintDocument, LeavesNoPixelsOfAnUnpaintedCanvas) {
  const Painted painted;
  Document document;
  document.set("paint/future", "1");
  document.set("paint/color/0,0", "[1,1,1]");
  TileStore tiles;
  LUM_EXPECT_OK(write_paint(painted.canvas.state(), document, tiles));
  EXPECT_FALSE(has_paint(document));
  EXPECT_EQ(document.entries().size(), 3U);  // nu, delta and what this version does not know
  EXPECT_TRUE(document.has("paint/future"));
}

TEST(PaintDocument, KeepsPixelsThatAreNotNumbers) {
  Painted painted;
  CanvasState state = painted.canvas.state();
  state.strokes = 1;
  for (float& value : state.target.color.data) value = std::numeric_limits<float>::quiet_NaN();
  Document document;
  TileStore tiles;
  LUM_EXPECT_OK(write_paint(state, document, tiles));
  LUM_ASSERT_OK(const CanvasState read, read_paint(document, tiles, painted.canvas.state()));
  EXPECT_TRUE(same_bits(read.target.color, state.target.color));
}

TEST(PaintDocument, KeepsLayersAndTheirStrokes) {
  Painted painted;
  painted.canvas = Canvas(painted.surface, painted.picture, [](ShadowPicture which) -> Result<Image> {
    return Image(150, 70, 3, which == ShadowPicture::kFreeLightsOff ? 0.05F : 0.9F);
  });
  LayerStack stack;
  stack.layers.push_back({.name = "Rim \"light\"", .visible = true, .opacity = 0.3F});
  LUM_EXPECT_OK(painted.canvas.relayer(stack, ""));
  LUM_EXPECT_OK(painted.canvas.apply(stroke_at(0.5F, 0.5F), ""));
  painted.canvas.choose_layer(1);
  Stroke shadow = stroke_at(0.6F, 0.5F);
  shadow.brush.tool = PaintTool::kShadow;
  shadow.brush.repeat_peak = true;
  LUM_EXPECT_OK(painted.canvas.apply(shadow, ""));
  stack = painted.canvas.state().layers;
  stack.counts[2] = 0.4F;
  LUM_EXPECT_OK(painted.canvas.relayer(stack, ""));
  Document document;
  TileStore tiles;
  LUM_EXPECT_OK(write_paint(painted.canvas.state(), document, tiles));
  Canvas other(painted.surface, painted.picture, nullptr);
  LUM_ASSERT_OK(const CanvasState read, read_paint(document, tiles, other.state()));
  const LayerStack& layers = read.layers;
  ASSERT_EQ(layers.layers.size(), 2U);
  EXPECT_EQ(layers.layers[1].name, "Rim \"light\"");
  EXPECT_EQ(layers.layers[1].opacity, 0.3F);
  EXPECT_EQ(layers.layers[1].strokes, std::vector<std::uint32_t>{2});
  EXPECT_EQ(layers.counts.at(2), 0.4F);
  EXPECT_EQ(layers.strokes.at(2)->stroke.points[0].x, 0.6F);
  ASSERT_TRUE(layers.strokes.at(2)->peak);
  ASSERT_TRUE(layers.strokes.at(2)->source);
  EXPECT_EQ(layers.ground, nullptr);
  // Laid again they are what was read.
  other.restore(read);
  LUM_EXPECT_OK(other.relayer(read.layers, ""));
  EXPECT_TRUE(same_bits(other.target().color, read.target.color));
  EXPECT_TRUE(same_bits(other.target().importance, read.target.importance));
  Document second;
  LUM_EXPECT_OK(write_paint(other.state(), second, tiles));
  EXPECT_EQ(second.hash(), document.hash());
}

TEST(PaintDocument, PaintOfAProjectThatKnowsNoLayersLiesUnderThem) {
  Painted painted;
  LUM_EXPECT_OK(painted.canvas.apply(stroke_at(0.5F, 0.5F), ""));
  Document old;
  TileStore tiles;
  LUM_EXPECT_OK(write_paint(painted.canvas.state(), old, tiles));
  old.erase_below("paint/layers/");
  old.erase_below("paint/kept/");
  Canvas canvas(painted.surface, painted.picture, nullptr);
  LUM_ASSERT_OK(CanvasState read, read_paint(old, tiles, canvas.state()));
  ASSERT_TRUE(read.layers.ground);
  EXPECT_TRUE(has_ground(old));
  canvas.restore(std::move(read));
  // More paint, and the eraser, are as they were before there were layers.
  Stroke eraser = stroke_at(0.55F, 0.5F);
  eraser.brush.tool = PaintTool::kErase;
  for (const Stroke& stroke : {stroke_at(0.6F, 0.5F), eraser}) {
    LUM_EXPECT_OK(canvas.apply(stroke, ""));
    LUM_EXPECT_OK(painted.canvas.apply(stroke, ""));
  }
  EXPECT_TRUE(same_bits(canvas.target().color, painted.canvas.target().color));
  EXPECT_EQ(canvas.target().stroke, painted.canvas.target().stroke);
  Document document;
  LUM_EXPECT_OK(write_paint(canvas.state(), document, tiles));
  LUM_ASSERT_OK(const CanvasState again, read_paint(document, tiles, painted.canvas.state()));
  EXPECT_TRUE(same_bits(again.layers.ground->color, canvas.state().layers.ground->color));
  canvas.restore(again);
  LUM_EXPECT_OK(canvas.relayer(again.layers, ""));
  EXPECT_TRUE(same_bits(canvas.target().color, painted.canvas.target().color));
}

TEST(PaintDocument, NamesWhatItCannotReadOfLayers) {
  Painted painted;
  LUM_EXPECT_OK(painted.canvas.apply(stroke_at(0.3F, 0.3F), ""));
  Document whole;
  TileStore tiles;
  LUM_EXPECT_OK(write_paint(painted.canvas.state(), whole, tiles));
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"paint/kept/1", "7"},
      {"paint/kept/1", R"({"stroke":{"points":[[1e9,0]]}})"},
      {"paint/kept/x", "{}"},
      {"paint/layers/0", R"({"name":"a","visible":true,"opacity":1})"},
      {"paint/layers/0", R"({"name":"a","visible":true,"opacity":1,"strokes":[1,2]})"},
      {"paint/layers/0", R"({"name":"a","visible":true,"opacity":7,"strokes":[1]})"},
      {"paint/kept/9", R"({"stroke":{"points":[[0,0]]}})"},
      {"paint/counts/1", "-1"}};
  for (const auto& [path, value] : wrong) {
    Document document = whole;
    document.set(path, value);
    EXPECT_EQ(error_of(read_paint(document, tiles, painted.canvas.state())).kind, ErrorKind::kBadContent) << value;
  }
}

TEST(PaintDocument, NamesWhatItCannotRead) {
  Painted painted;
  LUM_EXPECT_OK(painted.canvas.apply(stroke_at(0.3F, 0.3F), ""));
  Document whole;
  TileStore tiles;
  LUM_EXPECT_OK(write_paint(painted.canvas.state(), whole, tiles));
  for (const char* value : {"", "{}", "[1,2]", "true"}) {
    Document document = whole;
    document.set("paint/color/1,1", value);
    const Error error = error_of(read_paint(document, tiles, painted.canvas.state()));
    EXPECT_EQ(error.kind, ErrorKind::kBadContent);
    EXPECT_EQ(error.field, "paint/color/1,1");
  }
  Document document = whole;
  document.set("paint/color/0,0", "\"00112233445566778899aabbccddeeff\"");
  EXPECT_EQ(error_of(read_paint(document, tiles, painted.canvas.state())).kind, ErrorKind::kMissing);
}

}  // namespace
}  // namespace luminist
