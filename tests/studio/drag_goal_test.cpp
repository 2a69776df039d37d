#include "studio/drag_goal.h"

#include "studio/paint_layers.h"
#include "studio/script.h"
#include "studio/session_fixture.h"

namespace luminist {
namespace {

/// The demo scene, small, with one key from the left.
class DragGoalTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    session_.reset();
    Shot shot;
    shot.scene = "meshes/still_life/still_life.glb";
    shot.width = 320;
    shot.height = 240;
    auto session = Session::open(*device_, roots_, shot, folder_.path(), diagnostics_);
    ASSERT_TRUE(session) << session.error().message();
    session_ = std::move(*session);
    LUM_EXPECT_OK(session_->add_light({.name = "key", .from_paint = false}));
  }
  [[nodiscard]] const SurfaceBuffer& surface() const { return session_->stage().renderer->surface(); }
  /// The brightest pixel of an object, in picture heights.
  Vec2 brightest_of(const std::string& name) {
    const Image shown = picture();
    Vec2 brightest(0.0F);
    float most = 0.0F;
    for (int y = 0; y < surface().height; ++y) {
      for (int x = 0; x < surface().width; ++x) {
        const std::size_t pixel = surface().index(x, y);
        const bool on = surface().object_names[surface().object[pixel]] == name;
        const float value = on ? shown.rgb(pixel).x : 0.0F;
        if (value > most) most = value, brightest = Vec2(x, y) / 240.0F;
      }
    }
    return brightest;
  }
};

TEST_F(DragGoalTest, AHighlightIsFoundFromSomeWayOff) {
  const Vec2 brightest = brightest_of("jug");
  LUM_ASSERT_OK(const Image* shown, session_->picture());
  LUM_ASSERT_OK(const Highlight found, find_highlight(*shown, surface(), brightest + Vec2(0.02F, 0.02F)));
  EXPECT_LT(glm::length(found.peak - brightest), 0.03F) << "means of small squares peak about where pixels do";
  EXPECT_GT(found.diameter, 0.0F);
}

TEST_F(DragGoalTest, WhereNothingStandsOutThereIsNoHighlight) {
  const Image flat(surface().width, surface().height, 3, 0.5F);
  EXPECT_EQ(error_of(find_highlight(flat, surface(), Vec2(0.6F, 0.6F))).kind, ErrorKind::kNothingToDo);
  EXPECT_EQ(error_of(find_highlight(flat, surface(), Vec2(-1.0F, 0.6F))).kind, ErrorKind::kNothingToDo);
}

TEST_F(DragGoalTest, ADraggedHighlightComesToWhereItWasDragged) {
  Drag drag;
  drag.from = Vec2(0.506F, 0.410F);  // on the belly of the jug
  drag.to = drag.from + Vec2(-0.10F, 0.03F);
  LUM_ASSERT_OK(const DragOutcome before, highlight_outcome(*session_, drag, "key"));
  const std::size_t steps = session_->project().undo_steps();
  LUM_ASSERT_OK(const std::string light, start_drag(*session_, drag, few_evals()));
  EXPECT_EQ(light, "key");
  EXPECT_EQ(session_->project().undo_steps(), steps + 1) << "the paint is one command";
  LUM_EXPECT_OK(session_->finish_solve({}));
  LUM_ASSERT_OK(const DragOutcome after, highlight_outcome(*session_, drag, "key"));
  EXPECT_LT(after.distance, 0.03F) << "a highlight here is some 0.02 wide";
  EXPECT_GT(before.distance, 0.09F);
  const ParamBlock& key = session_->shown().rig.find("key")->params;
  EXPECT_TRUE(key.locked(key.schema()[*key.schema().by_role("color")].first_dof)) << "only its place is sought";
  LUM_EXPECT_OK(session_->accept());
  EXPECT_EQ(session_->project().undo_steps(), steps + 2);
}

TEST_F(DragGoalTest, AHighlightThatEndsElsewhereSaysHowFarAndWhatWouldHelp) {
  Drag drag;
  drag.from = Vec2(0.506F, 0.410F);
  drag.to = drag.from;
  LUM_ASSERT_OK(const DragOutcome now, highlight_outcome(*session_, drag, "key"));
  drag.to = now.found;
  LUM_ASSERT_OK(const std::string nothing, drag_words(*session_, drag, "key"));
  EXPECT_EQ(nothing, "") << "it is there";
  drag.to = now.found + Vec2(-0.10F, 0.03F);
  LUM_ASSERT_OK(const std::string words, drag_words(*session_, drag, "key"));
  EXPECT_TRUE(words.starts_with("the highlight of key ended 0.1")) << words;
  LUM_EXPECT_OK(session_->constrain({"lights/key on ceiling"}));
  LUM_ASSERT_OK(const std::string held, drag_words(*session_, drag, "key"));
  EXPECT_NE(held.find("it stays on ceiling"), std::string::npos) << held;
  drag.what = Drag::What::kShadow;
  LUM_ASSERT_OK(const std::string shadow, drag_words(*session_, drag, "key"));
  EXPECT_EQ(shadow, "");
}

TEST_F(DragGoalTest, AShadowIsPaintedWhereItShallGrowAndErasedWhereItShallShrink) {
  // A place in the shadow on the table and one in the light there, from pictures with and without shadows.
  LUM_ASSERT_OK(const Image lit, session_->stage().renderer->render(session_->state()));
  LUM_ASSERT_OK(const Image bare,
                session_->stage().renderer->render(session_->state(), RenderOptions{.shadows = false}));
  std::optional<Vec2> dark;
  std::optional<Vec2> bright;
  for (std::size_t i = 0; i < lit.pixels(); ++i) {
    const Vec2 place = (Vec2(i % 320, i / 320) + 0.5F) / 240.0F;
    const std::string& object = surface().object_names[surface().object[i]];
    if (object.empty() || bare.rgb(i).x < 0.2F) continue;
    if (lit.rgb(i).x < 0.3F * bare.rgb(i).x) dark = place;
    if (lit.rgb(i).x > 0.99F * bare.rgb(i).x) bright = place;
  }
  ASSERT_TRUE(dark && bright);
  const auto tool = [&](const Vec2& from, const Vec2& to) {
    Drag drag{Drag::What::kShadow, from, to, ""};
    const auto strokes = drag_strokes(*session_, drag);
    EXPECT_TRUE(strokes) << strokes.error().message();
    return strokes ? strokes->strokes.back().brush.tool : PaintTool::kErase;
  };
  EXPECT_EQ(tool(*bright, *bright + Vec2(0.005F, 0.0F)), PaintTool::kShadow);
  EXPECT_EQ(tool(*bright, *dark), PaintTool::kShadowEraser);
}

TEST_F(DragGoalTest, ADragOverNothingIsAnErrorAndRecordsNothing) {
  const std::string before = hash();
  Drag drag;
  drag.from = Vec2(-1.0F);
  drag.to = Vec2(0.5F);
  EXPECT_EQ(error_of(start_drag(*session_, drag, {})).kind, ErrorKind::kNothingToDo);
  drag.light = "nobody";
  EXPECT_EQ(error_of(start_drag(*session_, drag, {})).kind, ErrorKind::kUsage);
  EXPECT_EQ(hash(), before);
}

TEST_F(DragGoalTest, IsCancelledBetweenTheLightsItLooksAt) {
  const std::string before = hash();
  Drag drag;
  drag.from = Vec2(0.506F, 0.410F);
  drag.to = drag.from + Vec2(-0.10F, 0.03F);
  EXPECT_EQ(error_of(start_drag(*session_, drag, few_evals(), [] { return false; })).kind, ErrorKind::kCancelled);
  EXPECT_EQ(hash(), before);
}

TEST_F(DragGoalTest, OnAHiddenLayerItLeavesWhatWasProposed) {
  Drag drag;
  drag.from = Vec2(0.506F, 0.410F);
  drag.to = drag.from + Vec2(-0.10F, 0.03F);
  LUM_ASSERT_OK([[maybe_unused]] const std::string light, start_drag(*session_, drag, few_evals()));
  LUM_EXPECT_OK(session_->finish_solve({}));
  LUM_EXPECT_OK(session_->layers().set_visible("Layer 1", false));
  if (!session_->has_proposal()) LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  const std::string before = hash();
  EXPECT_EQ(error_of(start_drag(*session_, drag, few_evals())).field, "layer");
  EXPECT_EQ(hash(), before);
  EXPECT_TRUE(session_->has_proposal());
}

}  // namespace
}  // namespace luminist
