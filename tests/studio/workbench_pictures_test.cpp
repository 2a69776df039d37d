// Pictures that are small while the hand moves, and whole when it rests.
#include "studio/workbench.h"
#include "studio/workbench_fixture.h"

namespace luminist {
namespace {

using std::chrono::milliseconds;

class WorkbenchPicturesTest : public WorkbenchTest {
 protected:
  void open(int width, int height) {
    Shot large = shot();
    large.width = width;
    large.height = height;
    LUM_EXPECT_OK(bench_->open(large, folder_.path()));
    LUM_EXPECT_OK(bench_->prepare());
  }
  void draw_without_lifting() {
    const Stroke whole = light_strokes().strokes.front();
    LUM_EXPECT_OK(bench_->begin_stroke({whole.brush, {whole.points.front()}}, folder_.path()));
    LUM_EXPECT_OK(bench_->extend_stroke(std::span(whole.points).subspan(1)));
  }
};

TEST_F(WorkbenchPicturesTest, TheShadowBrushNeedNotWaitForWhatItCopies) {
  if (!device_->info().software) GTEST_SKIP() << "elsewhere that takes no time";
  open(400, 300);
  bench_->set_live(false);
  LUM_EXPECT_OK(bench_->act([](Session& session) -> Result<void> {
    for (const bool lock : {false, true}) {  // a locked light stays on in what the brush copies
      LUM_TRY(const std::string name, session.add_light({.from_paint = false}));
      LUM_TRY([[maybe_unused]] const int locked, session.set_locked("lights/" + name + "/*", lock));
    }
    return {};
  }));
  static_cast<void>(look());  // the picture that is painted on
  for (std::size_t i = 0; i < QuickStage::kSizes.size(); ++i) LUM_EXPECT_OK(bench_->prepare());
  const auto shades = [this] { return bench_->session().stage().renderer->work().shades; };
  double before = shades();
  Stroke shadow = light_strokes().strokes.front();
  shadow.brush.tool = PaintTool::kShadow;
  for (int stroke = 0; stroke < 2; ++stroke) {
    LUM_EXPECT_OK(bench_->begin_stroke({shadow.brush, {shadow.points.front()}}, folder_.path()));
    LUM_EXPECT_OK(bench_->extend_stroke(std::span(shadow.points).subspan(1)));
    LUM_EXPECT_OK(bench_->end_stroke());
    EXPECT_EQ(shades(), before) << "made while nothing else was to do, for what is recorded, too";
  }
  LUM_EXPECT_OK(bench_->change([](Session& session) { return session.set({"ambient/color=0.2,0.2,0.2"}); }));
  LUM_EXPECT_OK(bench_->prepare());
  EXPECT_GT(shades(), before) << "it was of other lights";
  before = shades();
  LUM_EXPECT_OK(bench_->prepare());
  EXPECT_EQ(shades(), before);
}

TEST_F(WorkbenchPicturesTest, ThePictureIsAnotherOnlyWhereTheLightsAre) {
  add_dark_light();
  const Stroke whole = light_strokes().strokes.front();
  int stayed = 0;
  for (const bool live : {true, false}) {
    bench_->set_live(live);
    LUM_EXPECT_OK(bench_->begin_stroke({whole.brush, {whole.points.front()}}, folder_.path()));
    auto last = look();
    for (int i = 1; i <= 12; ++i) {
      const float t = static_cast<float>(i) / 12.0F;
      const StrokePoint& a = whole.points.front();
      const StrokePoint& b = whole.points.back();
      const StrokePoint between{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 1.0F};
      LUM_EXPECT_OK(bench_->extend_stroke(std::span(&between, 1)));
      const auto now = look();
      LUM_ASSERT_OK(const Image made, bench_->session().stage().renderer->render(*now->shown));
      EXPECT_EQ(now->picture->data, made.data);
      stayed += live && now->picture == last->picture ? 1 : 0;
      EXPECT_TRUE(live || now->picture == last->picture);
      last = now;
    }
    LUM_EXPECT_OK(bench_->end_stroke());
  }
  EXPECT_GT(stayed, 0) << "not every event finds other lights";
}

TEST_F(WorkbenchPicturesTest, ASmallerPictureFollowsTheBrushAndAFullOneComesWhenItRests) {
  if (!device_->info().software) GTEST_SKIP() << "elsewhere no picture is small";
  open(400, 300);  // more than QuickStage::helps() leaves alone
  add_dark_light();
  LUM_EXPECT_OK(bench_->prepare());
  draw_without_lifting();
  const auto moving = look();
  EXPECT_LT(moving->picture->width, 400);
  EXPECT_EQ(moving->painted->color.width, 400) << "the paint itself is never small";
  LUM_EXPECT_OK(bench_->end_stroke());
  EXPECT_TRUE(look()->proposal) << "what was found while the brush moved is not lost";
  for (int i = 0; i < 5; ++i) LUM_EXPECT_OK(bench_->step(milliseconds(5)));
  EXPECT_EQ(look()->picture->width, 400);
}

TEST_F(WorkbenchPicturesTest, APictureAtRestIsGivenUpWhenSomebodyWaits) {
  if (!device_->info().software) GTEST_SKIP() << "elsewhere a picture is quick";
  open(640, 480);  // a picture of several parts
  add_dark_light();
  draw_without_lifting();
  EXPECT_LT(look()->picture->width, 640);
  LUM_EXPECT_OK(bench_->end_stroke());
  int asked = 0;
  bool alone = false;
  bench_->give_way_unless([&] { return ++asked, alone; });
  const std::string before = document_hash();
  for (int i = 0; i < 5 && asked == 0; ++i) {  // what comes before the picture asks nobody
    LUM_ASSERT_OK(const bool more, bench_->step(milliseconds(5)));
    EXPECT_TRUE(more) << "it is to be made anew";
  }
  EXPECT_EQ(asked, 1) << "the first answer was enough";
  const auto small = look();
  EXPECT_TRUE(small->proposal) << "what the small pictures found stays";
  EXPECT_LT(small->picture->width, 640);
  alone = true;
  for (int i = 0; i < 5; ++i) LUM_EXPECT_OK(bench_->step(milliseconds(5)));
  EXPECT_EQ(look()->picture->width, 640);
  EXPECT_EQ(document_hash(), before);
}

TEST_F(WorkbenchPicturesTest, ASearchAtRestIsGivenUpAndBeginsAgainFromWhatItFound) {
  if (!device_->info().software) GTEST_SKIP() << "elsewhere nothing is given up";
  open(400, 300);
  add_dark_light();
  draw_without_lifting();
  LUM_EXPECT_OK(bench_->end_stroke());
  bool alone = true;
  bench_->give_way_unless([&] { return alone; });
  for (int i = 0; i < 8; ++i) LUM_EXPECT_OK(bench_->step(milliseconds(1)));
  ASSERT_TRUE(look()->proposal);
  const double found = look()->report->epsilon;
  alone = false;
  for (int i = 0; i < 8; ++i) {
    LUM_ASSERT_OK(const bool more, bench_->step(milliseconds(1)));
    EXPECT_TRUE(more) << "nobody gets to the end of it";
  }
  EXPECT_TRUE(look()->proposal);
  alone = true;
  for (int i = 0; i < 20; ++i) {
    LUM_ASSERT_OK(const bool more, bench_->step(milliseconds(20)));
    if (!more) break;
  }
  EXPECT_LE(look()->report->epsilon, found);
}

TEST_F(WorkbenchPicturesTest, WhatIsStoppedIsShownWhole) {
  if (!device_->info().software) GTEST_SKIP() << "elsewhere no picture is small";
  open(400, 300);
  add_dark_light();
  for (const bool judged : {false, true}) {
    draw_without_lifting();
    EXPECT_LT(look()->picture->width, 400);
    LUM_EXPECT_OK(bench_->end_stroke());
    if (judged) {
      EXPECT_EQ(error_of(bench_->judge([] { return false; })).kind, ErrorKind::kCancelled);
    } else {
      bench_->stop();
    }
    EXPECT_EQ(look()->picture->width, 400) << judged;
  }
  LUM_ASSERT_OK(const bool more, bench_->step(milliseconds(5)));
  EXPECT_TRUE(more) << "a verdict that was taken away lets the lights follow on";
}

}  // namespace
}  // namespace luminist
