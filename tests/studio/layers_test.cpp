// Layers and strokes of a session: changed, recorded, undone.
#include <nlohmann/json.hpp>

#include "studio/paint_layers.h"
#include "studio/script.h"
#include "studio/session_fixture.h"

namespace luminist {
namespace {

class PaintLayersTest : public SessionTest {
 protected:
  Image painted() {
    auto target = session_->target();
    EXPECT_TRUE(target) << target.error().message();
    return target ? (*target)->color : Image();
  }
  LayerStack stack() {
    auto stack = session_->layers().stack();
    EXPECT_TRUE(stack) << stack.error().message();
    return stack ? *stack : LayerStack();
  }
  static StrokeFile floor_strokes() {
    Stroke stroke;
    stroke.brush.color = Vec3(0.1F, 0.2F, 0.9F);
    stroke.brush.texture = 0.0F;
    stroke.brush.diameter = 0.3F;
    stroke.points = {{0.2F, 0.9F}, {1.0F, 0.9F}};
    return {0.1F, 0.5F, {stroke}};
  }
  void paint(const StrokeFile& strokes) { LUM_EXPECT_OK(session_->paint(strokes, "strokes.json")); }
  /// On a layer of its own; it is not merged into what it would reach.
  void expect_an_eraser_above_stays_there() {
    LUM_EXPECT_OK(session_->layers().add("Floor"));
    StrokeFile eraser = floor_strokes();
    eraser.strokes[0].brush.tool = PaintTool::kErase;
    paint(eraser);
    const std::string before = hash();
    EXPECT_EQ(error_of(session_->layers().merge_down("Floor")).kind, ErrorKind::kUsage);
    EXPECT_EQ(hash(), before);
  }
};

TEST_F(PaintLayersTest, EachGestureIsOneCommandAndIsUndone) {
  const std::string start = hash();
  paint(light_strokes());
  LUM_ASSERT_OK(const std::string name, session_->layers().add("Floor"));
  EXPECT_EQ(name, "Floor");
  paint(floor_strokes());
  PaintLayers layers = session_->layers();
  LUM_EXPECT_OK(layers.set_opacity("Floor", 0.5F));
  LUM_EXPECT_OK(layers.set_visible("Layer 1", false));
  LUM_EXPECT_OK(layers.rename("Floor", "Ground"));
  LUM_EXPECT_OK(layers.place("Ground", 0));
  LUM_EXPECT_OK(layers.set_visible("Layer 1", true));
  LUM_EXPECT_OK(layers.move(2, {0.05F, 0.0F}));
  LUM_EXPECT_OK(layers.place_stroke(2, "Layer 1", 0));
  LUM_EXPECT_OK(layers.remove_stroke(1));
  LUM_EXPECT_OK(layers.remove("Ground"));
  EXPECT_EQ(session_->project().undo_steps(), 12U);
  const std::string end = hash();
  const Image last = painted();
  while (session_->project().undo_steps() > 0) LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(hash(), start);
  while (session_->project().redo_steps() > 0) LUM_EXPECT_OK(session_->redo());
  EXPECT_EQ(hash(), end);
  EXPECT_EQ(painted().data, last.data);
}

TEST_F(PaintLayersTest, AProjectIsOpenedWithItsLayers) {
  paint(light_strokes());
  LUM_EXPECT_OK(session_->layers().add("Floor"));
  LUM_EXPECT_OK(session_->layers().set_opacity("Floor", 0.4F));
  paint(floor_strokes());
  LUM_EXPECT_OK(session_->save_as(folder_.path() / "layers.lum"));
  const Image before = painted();
  session_.reset();
  session_ = open_project("layers.lum");
  EXPECT_EQ(painted().data, before.data);
  EXPECT_EQ(stack().layers[1].opacity, 0.4F);
  // What is painted next on the lower layer lies under the other.
  LUM_EXPECT_OK(session_->layers().choose("Layer 1"));
  paint(floor_strokes());
  EXPECT_EQ(stack().layers[0].strokes, (std::vector<std::uint32_t>{1, 3}));
}

TEST_F(PaintLayersTest, AChangedBrushPaintsTheStrokeAnew) {
  paint(floor_strokes());
  const Image blue = painted();
  Brush brush = floor_strokes().strokes[0].brush;
  brush.color = Vec3(0.9F, 0.1F, 0.1F);
  LUM_EXPECT_OK(session_->layers().set_brush(1, brush, ""));
  EXPECT_NE(painted().data, blue.data);
  LUM_ASSERT_OK(const Command command, session_->project().command(1));
  EXPECT_EQ(command.action, R"({"color":[0.9,0.1,0.1],"do":"edit_stroke","stroke":1})");
  brush.diameter = -1.0F;
  EXPECT_EQ(error_of(session_->layers().set_brush(1, brush, "")).field, "strokes[1].diameter");
  brush = floor_strokes().strokes[0].brush;
  LUM_EXPECT_OK(session_->layers().set_brush(1, brush, ""));
  EXPECT_EQ(painted().data, blue.data);
}

/// Shadows are copied when they are painted: other lights do not change them, nor does another stroke.
TEST_F(PaintLayersTest, AShadowStrokeKeepsWhatItCopied) {
  LUM_EXPECT_OK(session_->add_light({.from_paint = false}));
  StrokeFile shadow = floor_strokes();
  shadow.strokes[0].brush.tool = PaintTool::kShadow;
  paint(shadow);
  const Image before = painted();
  LUM_EXPECT_OK(session_->set({"ambient/color=0.9,0.2,0.2"}));
  LUM_EXPECT_OK(session_->layers().add());
  EXPECT_EQ(painted().data, before.data);
}

TEST_F(PaintLayersTest, WithoutItsLastStrokeAPaintingIsUnpainted) {
  paint(light_strokes());
  LUM_EXPECT_OK(session_->layers().remove_stroke(1));
  EXPECT_FALSE(session_->painted());
  EXPECT_EQ(error_of(session_->start_solve(few_evals())).kind, ErrorKind::kNothingToDo);
  EXPECT_EQ(painted().data, picture().data);
}

TEST_F(PaintLayersTest, MergedLayersLookTheSameAndStayStrokes) {
  paint(light_strokes());
  LUM_EXPECT_OK(session_->layers().add("Floor"));
  paint(floor_strokes());
  const Image before = painted();
  LUM_EXPECT_OK(session_->layers().merge_down("Floor"));
  EXPECT_EQ(painted().data, before.data);
  EXPECT_EQ(stack().layers.size(), 1U);
  EXPECT_EQ(stack().layers[0].strokes, (std::vector<std::uint32_t>{1, 2}));
  // One stroke over another at half opacity is the layer's half.
  LUM_EXPECT_OK(session_->undo());
  LUM_EXPECT_OK(session_->layers().set_opacity("Floor", 0.5F));
  const Image half = painted();
  LUM_EXPECT_OK(session_->layers().merge_down("Floor"));
  const Image merged = painted();
  for (std::size_t i = 0; i < half.data.size(); ++i) ASSERT_NEAR(merged.data[i], half.data[i], 1e-6F);
  EXPECT_EQ(error_of(session_->layers().merge_down("Layer 1")).kind, ErrorKind::kUsage);
}

TEST_F(PaintLayersTest, AnEraserIsNotMergedIntoPaintThatItWouldReach) {
  paint(light_strokes());
  expect_an_eraser_above_stays_there();
}

TEST_F(PaintLayersTest, NorIntoThatOfAPictureThatWasTakenAsTarget) {
  LUM_EXPECT_OK(session_->set_target(Image(48, 36, 3, 0.5F), std::nullopt));
  expect_an_eraser_above_stays_there();
}

TEST_F(PaintLayersTest, ErrorsNameWhatIsNotThere) {
  paint(light_strokes());
  PaintLayers layers = session_->layers();
  EXPECT_NE(error_of(layers.remove("Layr 1")).hint.find("Layer 1"), std::string::npos);
  EXPECT_EQ(error_of(layers.remove("Layer 1")).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(layers.add("Layer 1")).field, "name");
  EXPECT_EQ(error_of(layers.move(7, Vec2(0.1F))).field, "stroke");
  EXPECT_EQ(error_of(layers.set_opacity("Layer 1", 1.5F)).field, "opacity");
  EXPECT_EQ(session_->project().undo_steps(), 1U);
}

TEST_F(PaintLayersTest, AVerdictPointsAtItsStrokeWhateverBecameOfOthers) {
  paint(floor_strokes());
  paint(light_strokes());
  LUM_EXPECT_OK(session_->layers().remove_stroke(1));
  LUM_EXPECT_OK(session_->add_light({}));
  LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  LUM_ASSERT_OK(const Verdict* verdict, session_->judge());
  ASSERT_EQ(verdict->strokes.size(), 1U);
  EXPECT_EQ(verdict->strokes[0].stroke, 2U);
  EXPECT_EQ(stack().strokes.begin()->first, 2U);
}

TEST_F(PaintLayersTest, PaintOfAFrameTakesItsLayersAlong) {
  paint(light_strokes());
  LUM_EXPECT_OK(session_->layers().add("Floor"));
  LUM_EXPECT_OK(session_->go_to(5));
  EXPECT_EQ(stack().layers.size(), 1U);
  LUM_EXPECT_OK(session_->go_to(0));
  EXPECT_EQ(stack().layers.size(), 2U);
}

TEST_F(PaintLayersTest, ScriptsDoAllOfIt) {
  std::ofstream(folder_.file("script.jsonl"))
      << R"({"do":"open","scene":"ball.obj","size":[48,36]})" << '\n'
      << R"({"do":"paint","strokes":{"strokes":[{"diameter":0.5,"points":[[0.6,0.4],[0.7,0.5]]}]}})" << '\n'
      << R"({"do":"layer","name":"Rim","opacity":0.5})" << '\n'
      << R"({"do":"paint","strokes":{"strokes":[{"points":[[0.5,0.5]]},{"points":[[0.6,0.5]]}]}})" << '\n'
      << R"({"do":"paint","layer":"Layer 1","strokes":{"strokes":[{"points":[[0.5,0.5]]}]}})" << '\n'
      << R"({"do":"edit_stroke","stroke":3,"color":[0.9,0.5,0.1],"diameter":0.3})" << '\n'
      << R"({"do":"move_stroke","stroke":3,"by":[0.1,-0.05]})" << '\n'
      << R"({"do":"move_stroke","stroke":2,"layer":"Layer 1","place":0})" << '\n'
      << R"({"do":"delete_stroke","stroke":4})" << '\n'
      << R"({"do":"layer","name":"Rim","rename":"Edge","visible":true,"place":0})" << '\n'
      << R"({"do":"layer","name":"More"})" << '\n'
      << R"({"do":"merge_layer","name":"Layer 1"})" << '\n'
      << R"({"do":"merge_layer","name":"More"})" << '\n'
      << R"({"do":"layer","name":"Spare"})" << '\n'
      << R"({"do":"remove_layer","name":"Spare"})" << '\n'
      << R"({"do":"save","project":"scripted.lum"})" << '\n';
  LUM_EXPECT_OK(run_script(*device_, roots_, folder_.path() / "script.jsonl", folder_.path(), {}, diagnostics_));
  session_ = open_project("scripted.lum");
  const LayerStack layers = stack();
  ASSERT_EQ(layers.layers.size(), 1U);
  EXPECT_EQ(layers.layers[0].name, "Edge");
  EXPECT_EQ(layers.layers[0].strokes, (std::vector<std::uint32_t>{3, 2, 1}));
  const Stroke& moved = layers.strokes.at(3)->stroke;
  EXPECT_FLOAT_EQ(moved.points[0].x, 0.7F);
  EXPECT_FLOAT_EQ(moved.brush.diameter, 0.3F);
  EXPECT_FLOAT_EQ(moved.brush.opacity, 0.5F) << "of the layer it was on";
  std::ofstream(folder_.file("wrong.jsonl")) << R"({"do":"open","scene":"ball.obj","size":[48,36]})" << '\n'
                                             << R"({"do":"edit_stroke","stroke":3,"colour":[1,0,0]})" << '\n';
  const Error error =
      error_of(run_script(*device_, roots_, folder_.path() / "wrong.jsonl", folder_.path(), {}, diagnostics_));
  EXPECT_NE(error.hint.find("color"), std::string::npos);
}

}  // namespace
}  // namespace luminist
