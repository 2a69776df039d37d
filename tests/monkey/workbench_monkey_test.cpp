// A monkey at the workbench: gestures at random as a window offers them, strokes event by event.
#include <random>

#include <fmt/format.h>

#include "monkey/gestures.h"
#include "studio/paint_layers.h"
#include "studio/workbench.h"
#include "studio/workbench_fixture.h"

namespace luminist {
namespace {

using std::chrono::milliseconds;

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

using WorkbenchMonkeyTest = WorkbenchTest;

TEST_F(WorkbenchMonkeyTest, AllItsGesturesAreUndoneAndDoneAgain) {
  const int gestures = gestures_asked_for(2000);
  const std::string start = document_hash();
  std::mt19937 random(seed_asked_for());
  Stroke stroke = light_strokes().strokes.front();
  for (int i = 0; i < gestures; ++i) {
    monkey(*bench_, random, stroke, folder_.path());
    if (i % 20 != 0) continue;
    const auto now = bench_->snapshot();
    ASSERT_TRUE(now) << "after gesture " << i;
    if (bench_->stroke_open()) continue;
    LUM_ASSERT_OK(const Target* target, bench_->session().target());
    ASSERT_EQ((*now)->painted->color.data, target->color.data) << "after gesture " << i;
    ASSERT_EQ((*now)->painted->stroke, target->stroke) << "after gesture " << i;
    if (!(*now)->solo.empty()) continue;
    LUM_ASSERT_OK(const Image made, bench_->session().stage().renderer->render(*(*now)->shown));
    ASSERT_EQ((*now)->picture->data, made.data) << "after gesture " << i;
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
