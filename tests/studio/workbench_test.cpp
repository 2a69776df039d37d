#include "studio/workbench.h"

#include <cstdlib>
#include <random>

#include <fmt/format.h>

#include "studio/paint_layers.h"
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

void ignore(const Result<void>& result) {
  static_cast<void>(result);
}

/// One gesture on the canvas, sensible or not.
void canvas_gesture(Workbench& bench, std::mt19937& random, const Stroke& stroke, const std::filesystem::path& folder) {
  const float along = 0.01F * static_cast<float>(random() % 120);
  switch (random() % 8) {
    case 0:
    case 1: {
      Stroke begun{stroke.brush, {{along, 0.5F}}};
      begun.brush.tool = static_cast<PaintTool>(random() % 8);
      if (begun.brush.tool == PaintTool::kCopy) begun.brush.tool = PaintTool::kColor;
      return ignore(bench.begin_stroke(begun, folder));
    }
    case 2:
    case 3: {
      const std::vector<StrokePoint> points = {{along, 0.4F}, {along, 0.6F}};
      return ignore(bench.extend_stroke(points));
    }
    case 4:
    case 5:
      return ignore(bench.end_stroke());
    case 6:
      return bench.cancel_stroke();
    default: {
      Stroke bucket = stroke;
      bucket.brush.bucket = true;
      bucket.brush.clip = "ball";
      return ignore(bench.lay(bucket, folder));
    }
  }
}

/// What a button, a key or a widget does to the session.
Workbench::Task session_gesture(std::mt19937& random, const std::string& name, bool yes) {
  switch (random() % 7) {
    case 0:
      return [=](Session& s) { return s.set({fmt::format("lights/{}/color={},1,1", name, yes ? 0.0 : 0.7)}); };
    case 1:
      return [=](Session& s) { return s.set_muted(name, yes); };
    case 2:
      return [=](Session& s) -> Result<void> {
        LUM_TRY_VOID(s.set_locked("lights/*/position", yes));
        return {};
      };
    case 3:
      return [=](Session& s) -> Result<void> {
        if (s.state().rig.lights.size() > 1) return s.remove_light(s.state().rig.lights.front().name);
        LUM_TRY_VOID(s.add_light({.from_paint = false, .dark = yes}));
        return {};
      };
    case 4:
      return [=](Session& s) { return yes ? s.undo() : s.redo(); };
    case 5:
      return [](Session& s) { return s.accept(); };
    default:
      return [](Session& s) { return s.revert(); };
  }
}

/// Layers and strokes, there or not.
Workbench::Task paint_gesture(std::mt19937& random, bool yes) {
  const std::string layer = fmt::format("Layer {}", 1 + random() % 3);
  const auto stroke = static_cast<std::uint32_t>(random() % 6);
  const auto place = static_cast<std::size_t>(random() % 3);
  switch (random() % 9) {
    case 0:
      return [=](Session& s) -> Result<void> {
        LUM_TRY_VOID(s.layers().add(""));
        return {};
      };
    case 1:
      return [=](Session& s) { return s.layers().remove(layer); };
    case 2:
      return [=](Session& s) { return s.layers().set_visible(layer, yes); };
    case 3:
      return [=](Session& s) { return s.layers().set_opacity(layer, yes ? 1.0F : 0.5F); };
    case 4:
      return [=](Session& s) { return yes ? s.layers().merge_down(layer) : s.layers().place(layer, place); };
    case 5:
      return [=](Session& s) { return s.layers().choose(layer); };
    case 6: {
      Brush brush;
      brush.tool = static_cast<PaintTool>(random() % 8);
      brush.gradient = yes ? 1.0F : 0.0F;
      brush.repeat_peak = random() % 2 == 0;
      return [=](Session& s) { return s.layers().set_brush(stroke, brush, "strokes.json"); };
    }
    case 7:
      return [=](Session& s) {
        return yes ? s.layers().move(stroke, {0.1F, 0.05F}) : s.layers().remove_stroke(stroke);
      };
    default:
      return [=](Session& s) { return s.layers().place_stroke(stroke, layer, place); };
  }
}

/// One gesture that a window offers.
void monkey(Workbench& bench, std::mt19937& random, const Stroke& stroke, const std::filesystem::path& folder) {
  const std::string name = random() % 2 == 0 ? "light" : "light-2";
  const bool yes = random() % 2 == 0;
  switch (random() % 24) {
    case 0:
      return ignore(bench.preview({fmt::format("lights/{}/color=0.5,1,1", name)}));
    case 1:
      bench.set_live(random() % 3 != 0);
      return bench.set_solo(yes ? std::vector{name} : std::vector<std::string>());
    case 2: {
      SolveOptions options;
      options.max_evals = 3;
      return ignore(bench.start_solve(options));
    }
    case 3:
    case 4:
      return static_cast<void>(bench.step(milliseconds(1)));
    case 5:
    case 6:
    case 7:
    case 8:
    case 9:
    case 10:
    case 11:
      return canvas_gesture(bench, random, stroke, folder);
    case 12:
    case 13:
    case 14:
    case 15:
      return ignore(bench.repaint(paint_gesture(random, yes)));
    default: {
      const Workbench::Task task = session_gesture(random, name, yes);
      const auto after = random() % 2 == 0 ? Workbench::After::kFollow : Workbench::After::kStay;
      return ignore(random() % 2 == 0 ? bench.act(task, after) : bench.change(task, after));
    }
  }
}

int asked_for(const char* variable, int otherwise) {
  const char* wanted = std::getenv(variable);
  return wanted != nullptr ? std::atoi(wanted) : otherwise;
}

/// 2,000 gestures; LUMINIST_MONKEY=100000 for as many, LUMINIST_MONKEY_SEED=2 for others.
TEST_F(WorkbenchTest, WhateverAHandDoesCanBeUndone) {
  const int gestures = asked_for("LUMINIST_MONKEY", 2000);
  const std::string start = document_hash();
  std::mt19937 random(static_cast<unsigned>(asked_for("LUMINIST_MONKEY_SEED", 1)));
  Stroke stroke = light_strokes().strokes.front();
  for (int i = 0; i < gestures; ++i) {
    monkey(*bench_, random, stroke, folder_.path());
    if (i % 20 != 0) continue;
    ASSERT_TRUE(bench_->snapshot()) << "after gesture " << i;
  }
  LUM_EXPECT_OK(bench_->end_stroke());
  const std::string end = document_hash();
  const std::size_t steps = look()->history.undo_steps;
  EXPECT_GT(steps, static_cast<std::size_t>(gestures) / 100) << "the monkey did something";
  const auto all = [&](Result<void> (Session::*step)()) {
    return [step](Session& session) -> Result<void> {
      for (;;) {
        if (auto done = (session.*step)(); !done) {
          return done.error().kind == ErrorKind::kNothingToDo ? Result<void>() : std::move(done);
        }
      }
    };
  };
  LUM_EXPECT_OK(bench_->act(all(&Session::undo)));
  EXPECT_EQ(document_hash(), start);
  LUM_EXPECT_OK(bench_->act(all(&Session::redo)));
  EXPECT_EQ(document_hash(), end) << "and done again";
}

}  // namespace
}  // namespace luminist
