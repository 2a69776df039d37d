#include <nlohmann/json.hpp>

#include "studio/results.h"
#include "studio/session_fixture.h"

namespace luminist {
namespace {

/// A key from the front whose colour is locked, and paint that wants the ball brighter.
class SessionVerdictTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    prepare();
  }
  void prepare() {
    NewLight key;
    key.name = "key";
    key.from_paint = false;
    LUM_EXPECT_OK(session_->add_light(key));
    LUM_EXPECT_OK(session_->set_locked("*", true));
    LUM_EXPECT_OK(session_->set_locked("lights/key/shadow_density", false));
    StrokeFile strokes = light_strokes();
    strokes.nu = 0.02F;
    strokes.strokes[0].brush.clip = "ball";
    strokes.strokes[0].brush.color = Vec3(0.9F);
    LUM_EXPECT_OK(session_->paint(strokes, "strokes.json"));
  }
  StrokeVerdict judged() {
    LUM_EXPECT_OK(session_->solve(few_evals(), {}));
    const auto verdict = session_->judge();
    EXPECT_TRUE(verdict) << verdict.error().message();
    return verdict && !(*verdict)->strokes.empty() ? (*verdict)->strokes.front() : StrokeVerdict();
  }
};

TEST_F(SessionVerdictTest, TheRemedyIsOneGestureThatUndoTakesBack) {
  const StrokeVerdict stroke = judged();
  EXPECT_EQ(stroke.outcome, StrokeOutcome::kImpossible) << verdict_line(stroke);
  ASSERT_NE(stroke.remedy.kind, Remedy::Kind::kNone);
  const std::string before = hash();
  LUM_EXPECT_OK(session_->apply_remedy(1));
  EXPECT_NE(hash(), before);
  EXPECT_FALSE(session_->has_proposal());
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(hash(), before);
}

TEST_F(SessionVerdictTest, WithTheRemedyTheNextSolveComesNearer) {
  const double missed = judged().missed;
  LUM_EXPECT_OK(session_->apply_remedy(1));
  EXPECT_LT(judged().missed, 0.7 * missed);
}

TEST_F(SessionVerdictTest, TheVerdictIsWrittenWithTheResultsAndStaysWhenTheSolveIsAccepted) {
  judged();
  LUM_EXPECT_OK(session_->accept());
  LUM_ASSERT_OK(const Results results, collect_results(*session_));
  ASSERT_TRUE(results.verdict);
  LUM_EXPECT_OK(write_results(results, folder_.path() / "out"));
  std::ifstream file(folder_.path() / "out" / "verdict.json");
  const auto json = nlohmann::json::parse(file, nullptr, false);
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json["strokes"][0]["label"], "stroke 1 on ball");
  EXPECT_EQ(json["strokes"][0]["outcome"], "impossible");
}

TEST_F(SessionVerdictTest, ThereIsNothingToJudgeOrToDoWithoutASolve) {
  EXPECT_EQ(error_of(session_->judge()).kind, ErrorKind::kNothingToDo);
  EXPECT_EQ(error_of(session_->apply_remedy(1)).kind, ErrorKind::kNothingToDo);
  judged();
  EXPECT_EQ(error_of(session_->apply_remedy(7)).kind, ErrorKind::kNothingToDo);
}

/// The same where light is traced along paths.
class PathVerdictTest : public SessionVerdictTest {
 protected:
  void SetUp() override {
    SessionVerdictTest::SetUp();
    Shot traced = shot();
    traced.style = "path";
    traced.set = {"style/samples=16"};
    auto session = Session::open(*device_, roots_, traced, folder_.path(), diagnostics_);
    ASSERT_TRUE(session) << session.error().message();
    session_ = std::move(*session);
    prepare();
  }
};

TEST_F(PathVerdictTest, SaysWhatKeepsAStrokeFromBeingMetAndHowMuchIsChance) {
  const StrokeVerdict stroke = judged();
  EXPECT_EQ(stroke.outcome, StrokeOutcome::kImpossible) << verdict_line(stroke);
  EXPECT_EQ(stroke.cause, Cause::kLockedParameter) << verdict_line(stroke);
  EXPECT_NE(stroke.text.find("chance"), std::string::npos) << stroke.text;
  const double before = session_->solved()->report.epsilon;
  LUM_EXPECT_OK(session_->apply_remedy(1));
  judged();
  EXPECT_LT(session_->solved()->report.epsilon, 0.97 * before) << "the next solve comes nearer";
}

TEST_F(PathVerdictTest, CanBeTakenAwayAtAnyBatchAndLeavesTheSolve) {
  LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  int asked = 0;
  EXPECT_EQ(error_of(session_->judge([&] { return ++asked < 4; })).kind, ErrorKind::kCancelled);
  EXPECT_EQ(asked, 4);
  EXPECT_TRUE(session_->has_proposal());
  EXPECT_FALSE(session_->solved()->verdict);
}

}  // namespace
}  // namespace luminist
