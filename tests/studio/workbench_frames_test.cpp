// A workbench whose paint is of several frames.
#include "studio/shots.h"
#include "studio/workbench_fixture.h"

namespace luminist {
namespace {

class WorkbenchFramesTest : public WorkbenchTest {
 protected:
  /// A light that nothing turns but what a test asks for.
  void SetUp() override {
    WorkbenchTest::SetUp();
    bench_->set_live(false);
    LUM_EXPECT_OK(bench_->act([](Session& session) -> Result<void> {
      LUM_TRY_VOID(session.add_light({.from_paint = false}));
      return {};
    }));
  }
  void paint_at(double frame) {
    LUM_EXPECT_OK(bench_->act([&](Session& session) -> Result<void> {
      LUM_TRY_VOID(session.go_to(frame));
      return session.paint(light_strokes(), "strokes.json");
    }));
  }
  std::size_t painted_frames() {
    std::size_t count = 0;
    LUM_EXPECT_OK(bench_->act([&](Session& session) -> Result<void> {
      count = Shots(session).painted().size();
      return {};
    }));
    return count;
  }
};

TEST_F(WorkbenchFramesTest, AProposalComesBackWithItsPlaceInTheHistoryAndNotWithOneThatTookIt) {
  paint_at(24);
  paint_at(0);
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.solve(few_evals(), {}); }));
  ASSERT_TRUE(look()->proposal);
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.undo(); }));
  EXPECT_FALSE(look()->proposal);
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.redo(); }));
  EXPECT_TRUE(look()->proposal);
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.undo(); }));
  LUM_EXPECT_OK(bench_->change([](Session& session) { return session.go_to(24); }));
  EXPECT_FALSE(look()->proposal);
}

TEST_F(WorkbenchFramesTest, ASolveOfSeveralFramesTakesThePlaceOfLightsThatFollow) {
  paint_at(24);
  paint_at(0);
  add_dark_light();
  bench_->set_live(true);
  rest();
  const std::string followed = rig_to_toml(look()->shown->rig);
  ASSERT_TRUE(look()->proposal);
  LUM_EXPECT_OK(bench_->act([](Session& session) -> Result<void> {  // in place of a proposal, and no command tells
    const std::string camera = Shots(session).present().camera;
    const std::vector<FrameChoice> both = {{{camera, 0}}, {{camera, 24}, 3.0}};
    return Shots(session).solve(both, few_evals(), false, {});
  }));
  rest();
  LUM_EXPECT_OK(bench_->act([&](Session& session) -> Result<void> {
    EXPECT_EQ(session.solved()->frames.size(), 2U);
    EXPECT_NE(rig_to_toml(session.shown().rig), followed);
    EXPECT_EQ(rig_to_toml(look()->shown->rig), rig_to_toml(session.shown().rig));
    EXPECT_EQ(look()->report->epsilon, session.solved()->report.epsilon);
    return {};
  }));
}

TEST_F(WorkbenchFramesTest, ASolveOfOthersComesBackWhereNothingIsPainted) {
  paint_at(24);
  paint_at(12);
  LUM_EXPECT_OK(bench_->act([](Session& session) -> Result<void> {
    LUM_TRY_VOID(session.go_to(0));
    const std::string camera = Shots(session).present().camera;
    const std::vector<FrameChoice> others = {{{camera, 12}}, {{camera, 24}}};
    return Shots(session).solve(others, few_evals(), false, {});
  }));
  ASSERT_TRUE(look()->proposal);
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.set({"lights/light/color=1,0,0"}); }));
  EXPECT_FALSE(look()->proposal);
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.undo(); }));
  EXPECT_TRUE(look()->proposal);
}

TEST_F(WorkbenchFramesTest, ASolveOfSeveralFramesThatUndoBringsBackStillAnswersAllOfThem) {
  paint_at(24);
  paint_at(0);
  LUM_EXPECT_OK(bench_->act([](Session& session) {
    const std::string camera = Shots(session).present().camera;
    const std::vector<FrameChoice> both = {{{camera, 0}}, {{camera, 24}}};
    return Shots(session).solve(both, few_evals(), false, {});
  }));
  ASSERT_TRUE(look()->proposal);
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.paint(light_strokes(), "strokes.json"); }));
  EXPECT_FALSE(look()->proposal);
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.undo(); }));
  ASSERT_TRUE(look()->proposal);
  LUM_EXPECT_OK(bench_->act([](Session& session) -> Result<void> {
    EXPECT_EQ(session.solved()->frames.size(), 2U);
    return {};
  }));
  EXPECT_EQ(painted_frames(), 2U);
  LUM_EXPECT_OK(bench_->act([](Session& session) { return session.accept(); }));
  EXPECT_EQ(painted_frames(), 0U);
}

}  // namespace
}  // namespace luminist
