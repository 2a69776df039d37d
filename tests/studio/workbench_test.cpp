#include "studio/workbench.h"

#include "studio/workbench_fixture.h"

namespace luminist {
namespace {

using std::chrono::milliseconds;

TEST_F(WorkbenchTest, AStrokeOfTheHandIsOneCommandAndItsLightAProposal) {
  add_dark_light();
  EXPECT_EQ(look()->waiting, std::vector<std::string>{"light"});
  const std::size_t before = look()->history.undo_steps;
  draw_stroke();
  rest();
  const auto now = look();
  EXPECT_EQ(now->history.undo_steps, before + 1);
  EXPECT_EQ(now->history.labels.back(), "Paint 1 stroke");
  EXPECT_EQ(now->strokes_taken, 1U);
  EXPECT_TRUE(now->proposal);
  EXPECT_EQ(now->unanswered, 0U);
  ASSERT_TRUE(now->report);
  EXPECT_LT(now->report->epsilon, now->report->epsilon_start);
  EXPECT_TRUE(now->waiting.empty()) << "the light shines where the paint said";
}

TEST_F(WorkbenchTest, TheErrorOfAProposalIsThatOfItsPictureWhereverLightsStand) {
  LUM_EXPECT_OK(bench_->change([](Session& session) -> Result<void> {
    LUM_TRY_VOID(session.add_light({.name = "far", .from_paint = false}));
    return session.set({"lights/far/position=0,90,0"});  // many times its range away
  }));
  draw_stroke();
  rest();
  const auto now = look();
  ASSERT_TRUE(now->report);
  EXPECT_GT(now->report->penalty_start, 1.0);
  EXPECT_GT(now->report->error_start(), 0.0);
  EXPECT_LT(now->report->error_start(), 1.0);
  EXPECT_LT(now->report->error(), 1.0);
}

TEST_F(WorkbenchTest, ADarkLightIsInNoPictureUntilPaintSaysWhere) {
  const auto dim = look();
  add_dark_light();
  EXPECT_EQ(look()->picture->data, dim->picture->data);
}

TEST_F(WorkbenchTest, PaintWithoutAFreeLightWaitsForAnAnswer) {
  draw_stroke();
  rest();
  const auto now = look();
  EXPECT_FALSE(now->proposal);
  EXPECT_EQ(now->unanswered, 1U);
  EXPECT_TRUE(now->any_paint);
}

TEST_F(WorkbenchTest, ACancelledStrokeLeavesTheDocumentAsItWas) {
  add_dark_light();
  const std::string before = document_hash();
  const Stroke whole = light_strokes().strokes.front();
  LUM_EXPECT_OK(bench_->begin_stroke(whole, folder_.path()));
  EXPECT_NE(look()->painted->color.data, look()->picture->data);
  bench_->cancel_stroke();
  EXPECT_EQ(document_hash(), before);
  EXPECT_EQ(look()->strokes_taken, 1U);
  EXPECT_FALSE(look()->any_paint);
}

TEST_F(WorkbenchTest, AcceptingWhatTheBrushFoundPutsItInForce) {
  add_dark_light();
  draw_stroke();
  rest();
  const auto shown = look();
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.accept(); }));
  const auto now = look();
  EXPECT_FALSE(now->proposal);
  EXPECT_FALSE(now->any_paint);
  EXPECT_TRUE(now->shown->rig.lights.front().params.same_values(shown->shown->rig.lights.front().params));
}

TEST_F(WorkbenchTest, AChangeByHandKeepsWhatIsShownAndThePaint) {
  add_dark_light();
  draw_stroke();
  rest();
  const auto shown = look();
  LUM_EXPECT_OK(bench_->change([](Session& session) { return session.set({"lights/light/shadow_density=0.5"}); }));
  const auto now = look();
  EXPECT_FALSE(now->proposal);
  EXPECT_TRUE(now->any_paint);
  const ParamBlock& before = shown->shown->rig.lights.front().params;
  const ParamBlock& after = now->shown->rig.lights.front().params;
  const int position = *before.schema().by_role("position");
  EXPECT_EQ(after.vec3(position), before.vec3(position));
  EXPECT_EQ(after.scalar(*after.schema().by_role("shadow")), 0.5F);
}

TEST_F(WorkbenchTest, APreviewIsSeenAndNotRecorded) {
  const std::string before = document_hash();
  const auto dim = look();
  LUM_EXPECT_OK(bench_->preview({"ambient/color=0.5,0.5,0.5"}));
  EXPECT_NE(look()->picture->data, dim->picture->data);
  EXPECT_EQ(document_hash(), before);
  EXPECT_EQ(look()->picture->data, dim->picture->data) << "the next task ends it";
}

TEST_F(WorkbenchTest, ASoloLightIsAloneInThePictureOnly) {
  LUM_EXPECT_OK(bench_->act([](Session& session) -> Result<void> {
    LUM_TRY_VOID(session.add_light({.name = "key", .from_paint = false}));
    LUM_TRY_VOID(session.add_light({.name = "fill", .from_paint = false}));
    return session.set({"lights/fill/color=0,0,0.5"});
  }));
  const std::string before = document_hash();
  const auto both = look();
  bench_->set_solo({"key"});
  EXPECT_NE(look()->picture->data, both->picture->data);
  EXPECT_EQ(document_hash(), before);
  bench_->set_solo({});
  EXPECT_EQ(look()->picture->data, both->picture->data);
}

TEST_F(WorkbenchTest, AnUnsavedSessionIsThereAfterACrash) {
  add_dark_light();
  draw_stroke();
  const std::string hash = document_hash();
  const auto folder = bench_->folder();
  EXPECT_TRUE(look()->history.unsaved);
  bench_ = std::make_unique<Workbench>(*device_, roots_, folder_.path() / "unsaved");
  LUM_EXPECT_OK(bench_->open_project(folder));
  EXPECT_EQ(document_hash(), hash);
  LUM_EXPECT_OK(bench_->save_as(folder_.path() / "named.lum"));
  EXPECT_FALSE(look()->history.unsaved);
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST_F(WorkbenchTest, AnOfferThatIsTakenIsTheProposal) {
  add_dark_light();
  draw_stroke();
  rest();
  int asked = 0;
  LUM_EXPECT_OK(bench_->offer_alternatives([&](const ExploreProgress&) { return ++asked < 3; }));
  const auto offers = look()->offers;
  ASSERT_TRUE(offers);
  ASSERT_FALSE(offers->empty()) << "the best so far is an offer";
  LUM_EXPECT_OK(bench_->take_offer(0));
  EXPECT_TRUE(look()->proposal);
  const ParamBlock& taken = offers->front().lights.rig.lights.front().params;
  EXPECT_TRUE(look()->shown->rig.lights.front().params.same_values(taken));
  EXPECT_EQ(error_of(bench_->take_offer(99)).kind, ErrorKind::kNothingToDo);
}

TEST_F(WorkbenchTest, WhatComesAfterASolveComesOnceAndOnlyIfTheSolveIsLeftToItsEnd) {
  add_dark_light();
  draw_stroke();
  rest();
  int done = 0;
  const auto count = [&](Session&) -> Result<void> {
    ++done;
    return {};
  };
  bench_->after_solve(count);
  rest();
  EXPECT_EQ(done, 0) << "no solve runs";
  SolveOptions few = few_evals();
  LUM_EXPECT_OK(bench_->start_solve(few));
  bench_->after_solve(count);
  bench_->stop();
  rest();
  EXPECT_EQ(done, 0) << "it was stopped";
  LUM_EXPECT_OK(bench_->start_solve(few));
  bench_->after_solve(count);
  rest();
  EXPECT_EQ(done, 1);
  LUM_EXPECT_OK(bench_->start_solve(few));
  rest();
  EXPECT_EQ(done, 1);
}

TEST_F(WorkbenchTest, AVerdictIsTakenAwayWhenSomethingElseIsWanted) {
  add_dark_light();
  draw_stroke();
  rest();
  EXPECT_EQ(error_of(bench_->judge([] { return false; })).kind, ErrorKind::kCancelled);
  EXPECT_TRUE(look()->proposal);
  EXPECT_FALSE(look()->verdict);
  LUM_EXPECT_OK(bench_->judge());
  EXPECT_TRUE(look()->verdict);
}

}  // namespace
}  // namespace luminist
