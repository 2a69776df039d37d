// Layers and strokes under the hand, and the lights that were found for them.
#include <fmt/format.h>

#include "studio/paint_layers.h"
#include "studio/workbench_fixture.h"

namespace luminist {
namespace {

using std::chrono::milliseconds;

ParamBlock light_of(const StudioSnapshot& snapshot) {
  return snapshot.shown->rig.lights.front().params;
}

class WorkbenchLayersTest : public WorkbenchTest {};

TEST_F(WorkbenchLayersTest, AStrokeWhileNoLightFollowsLeavesTheProposal) {
  add_dark_light();
  draw_stroke();
  rest();
  const auto found = look();
  bench_->set_live(false);
  draw_stroke();
  const auto now = look();
  EXPECT_TRUE(now->proposal);
  EXPECT_TRUE(light_of(*now).same_values(light_of(*found)));
  EXPECT_EQ(now->unanswered, 2U);
}

TEST_F(WorkbenchLayersTest, RedoBringsBackTheLightsThatWereFound) {
  add_dark_light();
  draw_stroke();
  rest();
  const auto first = look();
  draw_stroke();
  rest();
  const auto second = look();
  const auto go = [&](Result<void> (Session::*step)()) {
    LUM_EXPECT_OK(bench_->act([=](Session& session) { return (session.*step)(); }, Workbench::After::kFollow));
    for (int i = 0; i < 5; ++i) LUM_EXPECT_OK(bench_->step(milliseconds(5)));
  };
  go(&Session::undo);
  EXPECT_TRUE(look()->proposal);
  EXPECT_TRUE(light_of(*look()).same_values(light_of(*first)));
  go(&Session::redo);
  EXPECT_TRUE(light_of(*look()).same_values(light_of(*second)));
  go(&Session::undo);
  go(&Session::undo);
  EXPECT_FALSE(look()->proposal);
  draw_stroke();
  rest();
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.accept(); }));
  const auto accepted = look();
  go(&Session::undo);
  EXPECT_TRUE(look()->proposal) << "what was accepted is proposed again";
  EXPECT_TRUE(light_of(*look()).same_values(light_of(*accepted)));
  go(&Session::redo);
  EXPECT_FALSE(look()->proposal);
  EXPECT_TRUE(light_of(*look()).same_values(light_of(*accepted)));
}

TEST_F(WorkbenchLayersTest, ARevertedProposalDoesNotComeBack) {
  add_dark_light();
  draw_stroke();
  rest();
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.revert(); }));
  bench_->set_live(false);
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.undo(); }));
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.redo(); }));
  EXPECT_FALSE(look()->proposal);
}

TEST_F(WorkbenchLayersTest, AChangeThatFailsLeavesTheProposalAProposal) {
  add_dark_light();
  draw_stroke();
  rest();
  const auto before = look();
  const std::string hash = document_hash();
  EXPECT_EQ(error_of(bench_->change([](Session& session) { return session.restyle("cinemtic"); })).kind,
            ErrorKind::kMissing);
  const auto after = look();
  EXPECT_EQ(document_hash(), hash);
  EXPECT_TRUE(after->proposal);
  EXPECT_EQ(after->history.undo_steps, before->history.undo_steps);
  EXPECT_EQ(after->history.redo_steps, 0U);
  EXPECT_TRUE(light_of(*after).same_values(light_of(*before)));
}

TEST_F(WorkbenchLayersTest, AChangeByHandOfAProposalIsOneCommand) {
  add_dark_light();
  draw_stroke();
  rest();
  const auto before = look();
  LUM_EXPECT_OK(bench_->change([](Session& session) { return session.set({"lights/light/shadow_density=0.5"}); }));
  EXPECT_EQ(look()->history.undo_steps, before->history.undo_steps + 1);
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.undo(); }));
  EXPECT_TRUE(look()->proposal);
  EXPECT_TRUE(light_of(*look()).same_values(light_of(*before)));
}

TEST_F(WorkbenchLayersTest, AStrokeThatIsChangedKeepsTheLightsAndTheyGoOn) {
  add_dark_light();
  draw_stroke();
  rest();
  const auto before = look();
  ASSERT_EQ(before->layers->strokes.size(), 1U);
  Brush brush = before->layers->strokes.at(1)->stroke.brush;
  brush.color = Vec3(0.1F, 0.1F, 1.0F);
  LUM_EXPECT_OK(bench_->repaint([=](Session& session) { return session.layers().set_brush(1, brush, ""); }));
  EXPECT_TRUE(look()->proposal);
  EXPECT_TRUE(light_of(*look()).same_values(light_of(*before)));
  EXPECT_EQ(look()->layers->strokes.at(1)->stroke.brush.color, brush.color);
  EXPECT_NE(look()->painted->color.data, before->painted->color.data);
  rest();
  const ParamBlock light = light_of(*look());
  const Vec3 color = light.vec3(*light.schema().by_role("color"));
  EXPECT_GT(color.z, 2.0F * color.x) << "the light has become blue";
}

TEST_F(WorkbenchLayersTest, AStrokeGoesToTheLayerThatWasChosen) {
  LUM_EXPECT_OK(bench_->repaint([](Session& session) -> Result<void> {
    LUM_TRY_VOID(session.layers().add("Rim"));
    return session.layers().choose("Layer 1");
  }));
  draw_stroke();
  EXPECT_EQ(look()->layers->layers[0].strokes, std::vector<std::uint32_t>{1});
  EXPECT_EQ(look()->layers->active, 0U);
}

/// The same paint is shown whether it came event by event or is read from the document.
TEST_F(WorkbenchLayersTest, WhatIsShownUnderTheHandIsWhatIsRecorded) {
  LUM_EXPECT_OK(bench_->repaint([](Session& session) -> Result<void> {
    LUM_TRY_VOID(session.layers().add("Rim"));
    return session.layers().set_opacity("Rim", 0.5F);
  }));
  Stroke stroke = light_strokes().strokes.front();
  for (int i = 0; i < 6; ++i) {
    stroke.points[1].x = 0.5F + 0.1F * static_cast<float>(i);
    LUM_EXPECT_OK(bench_->begin_stroke({stroke.brush, {stroke.points[0]}}, folder_.path()));
    const auto held = look();  // as a window holds what it draws
    LUM_EXPECT_OK(bench_->extend_stroke(std::span(stroke.points).subspan(1)));
    const auto shown = look();
    LUM_EXPECT_OK(bench_->end_stroke());
    LUM_EXPECT_OK(bench_->act([](Session& session) -> Result<void> {
      LUM_TRY_VOID(session.undo());
      return session.redo();
    }));
    const std::string name = i % 2 == 0 ? "Layer 1" : "Rim";
    LUM_EXPECT_OK(bench_->repaint([=](Session& session) { return session.layers().choose(name); }));
    EXPECT_EQ(look()->painted->color.data, shown->painted->color.data) << i;
    EXPECT_EQ(look()->painted->stroke, shown->painted->stroke) << i;
  }
}

TEST_F(WorkbenchLayersTest, WithoutASessionThereIsNothingToDo) {
  Workbench empty(*device_, roots_, {});
  const auto refused = [](const auto& result) { return error_of(result).kind == ErrorKind::kNothingToDo; };
  EXPECT_TRUE(refused(empty.save_as(folder_.path() / "a.lum")));
  EXPECT_TRUE(refused(empty.start_solve({})));
  EXPECT_TRUE(refused(empty.judge()));
  EXPECT_TRUE(refused(empty.offer_alternatives({})));
  EXPECT_TRUE(refused(empty.offer_diet({})));
  EXPECT_TRUE(refused(empty.take_offer(0)));
  EXPECT_TRUE(refused(empty.preview({"ambient/color=1,1,1"})));
  EXPECT_TRUE(refused(empty.begin_stroke(light_strokes().strokes[0], folder_.path())));
  EXPECT_TRUE(refused(empty.repaint([](Session&) { return Result<void>(); })));
  empty.stop();
  empty.cancel_stroke();
  LUM_EXPECT_OK(empty.end_stroke());
  LUM_EXPECT_OK(empty.sync_if_due());
}

constexpr double kRound = QuickSize::kSeconds;

TEST(QuickSize, IsAsLargeAsTheMachineMakesInTime) {
  QuickSize size;
  EXPECT_EQ(size.pixels(), QuickSize::kFirst);
  for (int i = 0; i < 9; ++i) size.note(0.0, 2.0 * kRound, 60'000.0);
  EXPECT_NEAR(size.pixels(), 30'000.0, 1.0);
  for (int i = 0; i < 100; ++i) size.note(0.0, 0.5 * kRound, 30'000.0);
  EXPECT_NEAR(size.pixels(), 60'000.0, 1.0) << "what was slow long ago is forgotten";
  for (int i = 0; i < 9; ++i) size.note(0.0, 20.0 * kRound, 30'000.0);
  EXPECT_EQ(size.pixels(), QuickSize::kLeast);
}

TEST(QuickSize, IsForTheRoundsThatMostOfTheHandsTimeGoesInto) {
  QuickSize size;
  // A light moves in every third round; the others are done in no time.
  for (int i = 0; i < 30; ++i) size.note(0.0, i % 3 == 0 ? 2.0 * kRound : 0.2 * kRound, 60'000.0);
  EXPECT_NEAR(size.pixels(), 30'000.0, 1.0);
}

TEST(QuickSize, ForgivesAHiccup) {
  QuickSize size;
  size.note(0.0, 5.0, 30'000.0);  // the first round compiles
  for (int i = 0; i < 5; ++i) size.note(0.0, 0.5 * kRound, 30'000.0);
  EXPECT_NEAR(size.pixels(), 60'000.0, 1.0);
}

TEST(QuickSize, DoesNotShrinkForWhatItCannotChange) {
  QuickSize size;
  for (int i = 0; i < 9; ++i) size.note(0.5 * kRound, 0.25 * kRound, 30'000.0);
  EXPECT_NEAR(size.pixels(), 60'000.0, 1.0) << "half a round is for the pixels, which may take twice as long";
}

}  // namespace
}  // namespace luminist
