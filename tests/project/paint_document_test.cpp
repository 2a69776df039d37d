#include "project/paint_document.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

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
    EXPECT_TRUE(in_first_tile || edit.path == "paint/strokes") << edit.path;
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
