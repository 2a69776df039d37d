#include "solve/live_solve.h"

#include <gtest/gtest.h>

#include "render/metric.h"
#include "solve/fake_renderer.h"
#include "solve/start_light.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

/// A hidden light is painted from left to right, a few columns an event, while a new light follows.
class LiveSolveTest : public testing::Test {
 protected:
  static constexpr int kSize = 64;

  explicit LiveSolveTest(FakeStyle style = FakeStyle::kMatte)
      : renderer_(kSize, kSize, style), start_(renderer_.empty_state()) {
    ParamState wanted = start_;
    wanted.rig.lights.push_back(hidden_light(renderer_, "hidden", 3));
    painted_ = renderer_.target_of(wanted, start_);
    target_ = renderer_.target_of(start_, start_);
    target_.importance = Image(kSize, kSize, 1, 0.05F);
    paint({20, 0, 30, kSize});
    start_.rig.lights.push_back(renderer_.cinematic("new"));
    const auto light = estimate_start_light(renderer_.surface(), target_, renderer_.frame());
    if (light) apply_start_light(*light, start_.rig.lights[0]);
  }

  PixelBox paint(const PixelBox& box) {
    for (int y = box.y0; y < box.y1; ++y) {
      for (int x = box.x0; x < box.x1; ++x) {
        const std::size_t i = target_.color.index(x, y);
        target_.color.set_rgb(i, painted_.color.rgb(i));
        target_.importance.data[i] = 1.0F;
      }
    }
    return box;
  }
  LiveSolve live() {
    auto live = LiveSolve::create(renderer_, start_, target_, {.seed = 2});
    EXPECT_TRUE(live) << live.error().message();
    return std::move(*live);
  }
  double error(const LiveSolve& solve) { return picture_error(solve.picture(), target_, renderer_.style().metric); }
  static void settle(LiveSolve& solve) {
    for (bool more = true; more;) {
      LUM_ASSERT_OK(more, solve.step());
      LUM_EXPECT_OK(solve.show());
    }
  }

  FakeRenderer renderer_;
  ParamState start_;
  Target painted_;
  Target target_;
};

TEST_F(LiveSolveTest, FollowsAStrokeAndEndsAboutAsNearAsASolveOfTheWholePainting) {
  LiveSolve solve = live();
  for (int x = 30; x < kSize; x += 4) {
    LUM_EXPECT_OK(solve.retarget(target_, paint({x, 0, std::min(kSize, x + 4), kSize})));
    for (int i = 0; i < 3; ++i) LUM_EXPECT_OK(solve.step());
    LUM_EXPECT_OK(solve.show());
  }
  LUM_EXPECT_OK(solve.retarget(target_, paint({0, 0, 20, kSize})));
  settle(solve);
  EXPECT_TRUE(solve.report().settled);
  LUM_ASSERT_OK(SolveSession whole, SolveSession::create(renderer_, start_, target_, {.seed = 2}));
  for (bool more = true; more;) {
    LUM_ASSERT_OK(more, whole.step());
  }
  EXPECT_LT(solve.report().epsilon, 0.3 * whole.report().epsilon_start);
  EXPECT_LT(solve.report().epsilon, 1.5 * whole.report().epsilon);  // either may end in another local minimum
}

TEST_F(LiveSolveTest, NoSearchBeginsWhileTheHandMoves) {
  constexpr std::chrono::minutes kForever{10};
  LiveSolve solve = live();
  LUM_ASSERT_OK(bool more, solve.run_for(kForever, Hand::kMoves));
  EXPECT_TRUE(more);
  EXPECT_FALSE(solve.report().following);
  EXPECT_FALSE(solve.report().settled);
  const double shades = renderer_.work().shades;
  LUM_ASSERT_OK(more, solve.run_for(kForever, Hand::kMoves));
  EXPECT_TRUE(more);
  EXPECT_EQ(renderer_.work().shades, shades) << "it waits for the next target";
  LUM_ASSERT_OK(more, solve.run_for(kForever, Hand::kRests));
  EXPECT_FALSE(more);
  EXPECT_TRUE(solve.report().settled);
}

TEST_F(LiveSolveTest, WhatWasFoundIsDroppedWhenNothingCountsAnyMore) {
  LiveSolve solve = live();
  LUM_EXPECT_OK(solve.step());
  LUM_EXPECT_OK(solve.step());
  target_.importance = Image(kSize, kSize, 1, 0.0F);
  LUM_EXPECT_OK(solve.retarget(target_, {0, 0, kSize, kSize}));
  LUM_ASSERT_OK(const bool changed, solve.show());
  EXPECT_FALSE(changed);
  EXPECT_TRUE(solve.report().settled);
}

TEST_F(LiveSolveTest, ItsPictureNeverGetsWorseWhileThePaintStandsStill) {
  LiveSolve solve = live();
  for (int x = 30; x < kSize; x += 12) {
    LUM_EXPECT_OK(solve.retarget(target_, paint({x, 0, std::min(kSize, x + 12), kSize})));
    double last = error(solve);
    EXPECT_NEAR(solve.report().error(), last, 1e-9);
    for (int i = 0; i < 40; ++i) {
      LUM_EXPECT_OK(solve.step());
      LUM_ASSERT_OK(const bool changed, solve.show());
      const double now = error(solve);
      EXPECT_LE(now, last + 1e-9);
      EXPECT_TRUE(changed || now == last);
      last = now;
    }
  }
}

TEST_F(LiveSolveTest, ItsPictureIsThatOfItsBestLights) {
  LiveSolve solve = live();
  settle(solve);
  LUM_ASSERT_OK(const Image picture, renderer_.render(solve.best(), {}));
  EXPECT_EQ(picture.data, solve.picture().data);
  EXPECT_GT(solve.report().pictures, 1);
}

TEST_F(LiveSolveTest, GivesTheSameBitsForTheSameEventsAndSteps) {
  std::vector<std::vector<float>> pictures;
  const Target untouched = target_;
  for (int run = 0; run < 2; ++run) {
    target_ = untouched;
    LiveSolve solve = live();
    for (int x = 30; x < kSize; x += 8) {
      LUM_EXPECT_OK(solve.retarget(target_, paint({x, 0, std::min(kSize, x + 8), kSize})));
      for (int i = 0; i < 5; ++i) LUM_EXPECT_OK(solve.step());
      LUM_EXPECT_OK(solve.show());
    }
    pictures.push_back(solve.picture().data);
  }
  EXPECT_EQ(pictures[0], pictures[1]);
}

TEST_F(LiveSolveTest, TakesAnOfferThatIsNearer) {
  LiveSolve solve = live();
  ParamState offer = start_;
  offer.rig.lights[0].params = hidden_light(renderer_, "new", 3).params;
  LUM_EXPECT_OK(solve.retarget(target_, paint({0, 0, kSize, kSize})));
  solve.offer(offer);
  LUM_EXPECT_OK(solve.step());
  LUM_ASSERT_OK(const bool changed, solve.show());
  EXPECT_TRUE(changed);
  EXPECT_LT(solve.report().epsilon, 0.02);
}

TEST_F(LiveSolveTest, WaitsWhileNothingCounts) {
  Target blank = target_;
  std::fill(blank.importance.data.begin(), blank.importance.data.end(), 0.0F);
  LUM_ASSERT_OK(LiveSolve solve, LiveSolve::create(renderer_, start_, blank, {}));
  LUM_ASSERT_OK(const bool more, solve.step());
  EXPECT_FALSE(more);
  LUM_ASSERT_OK(const bool changed, solve.show());
  EXPECT_FALSE(changed);
  LUM_EXPECT_OK(solve.retarget(target_, {0, 0, kSize, kSize}));
  const double before = solve.report().epsilon;
  settle(solve);
  EXPECT_LT(solve.report().epsilon, before);
}

TEST_F(LiveSolveTest, MasksWhatIsPaintedButNoNumber) {
  LiveSolve solve = live();
  const PixelBox box = paint({30, 10, 50, 30});
  for (int x = 30; x < 40; ++x) target_.color.at(x, 12, 1) = std::numeric_limits<float>::quiet_NaN();
  LUM_EXPECT_OK(solve.retarget(target_, box));
  EXPECT_TRUE(std::isfinite(solve.report().epsilon));
  settle(solve);
  EXPECT_TRUE(std::isfinite(solve.report().epsilon));
}

class LiveDotsTest : public LiveSolveTest {
 protected:
  LiveDotsTest() : LiveSolveTest(FakeStyle::kDotted) {}
};

TEST_F(LiveDotsTest, FollowsWhatABlurredMetricSeesAndNotTheDots) {
  LiveSolve solve = live();
  LUM_EXPECT_OK(solve.retarget(target_, paint({0, 0, kSize, kSize})));
  const double before = solve.report().epsilon;
  while (solve.report().following) LUM_EXPECT_OK(solve.step());
  LUM_EXPECT_OK(solve.show());
  // The picture can be met; samples of the dots themselves, most of them black, would leave thrice as much as blurred
  // ones do (0.046 against 0.014).
  EXPECT_LT(solve.report().epsilon, 0.03 * before);
}

TEST_F(LiveSolveTest, SaysWhenEverythingIsLocked) {
  for (ParamBlock* block : start_.blocks()) block->set_param_locked(-1, true);
  EXPECT_EQ(error_of(LiveSolve::create(renderer_, start_, target_, {})).kind, ErrorKind::kNothingToDo);
}

}  // namespace
}  // namespace luminist
