// A monkey at the session: gestures at random, most of them senseless.
#include <fmt/format.h>

#include <random>

#include "monkey/gestures.h"
#include "studio/paint_layers.h"
#include "studio/session_fixture.h"
#include "studio/shot_view.h"
#include "studio/shots.h"
#include "studio/two_cameras.h"

namespace luminist {
namespace {

class SessionMonkeyTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    LUM_ASSERT_OK(const Scene scene, two_cameras(folder_.file("ball.obj"), diagnostics_));
    LUM_EXPECT_OK(save_scene(scene, folder_.file("two.glb")));
    Shot two = shot();
    two.scene = "two.glb";
    session_ = open(two);
    ASSERT_NE(session_, nullptr);
  }

  /// Errors are fine, crashes and half-done gestures are not.
  void act() {
    const auto ignore = [](const auto& result) { (void)result; };
    const std::string name = fmt::format("light{}", draw(3) == 0 ? "" : "-2");
    switch (draw(29)) {
      case 0:
        return ignore(session_->add_light({.from_paint = draw(2) == 0}));
      case 1:
        return ignore(session_->remove_light(name));
      case 2:
        return ignore(session_->set_muted(name, draw(2) == 0));
      case 3:
        return ignore(session_->share_shadows(draw(2) == 0 ? name : ""));
      case 4:
        return ignore(session_->set({fmt::format("lights/{}/color={},0.5,0.5", name, draw(7))}));
      case 5:
        return ignore(session_->set_locked("lights/*/position", draw(2) == 0));
      case 6:
        return ignore(session_->set_importance(0.01F * static_cast<float>(draw(130)), 0.5F));
      case 7:
        return ignore(session_->clear_paint());
      case 8:
        return ignore(session_->undo());
      case 9:
        return ignore(session_->redo());
      case 10:
        return ignore(session_->accept());
      case 11:
        return ignore(session_->revert());
      case 12:
        return ignore(session_->solve(two_evals(), {}));
      case 13:
        return ignore(session_->go_to(static_cast<double>(draw(4))));
      case 14:
        return ignore(session_->set_keys(fmt::format("lights/{}/color", name), KeyInterpolation::kLinear));
      case 15:
        return ignore(session_->remove_keys("lights/*"));
      case 16:
        return ignore(session_->link_light(name, {draw(2) == 0 ? "ball" : "no such thing"}));
      case 17:
        return ignore(session_->set_target(Image(9, 7, 3, 0.5F), std::nullopt));
      case 18:
        return ignore(session_->constrain({fmt::format("lights/{} on ceiling", name)}));
      case 19:
        return ignore(session_->layers().add());
      case 20:
        return ignore(session_->layers().set_opacity(fmt::format("Layer {}", 1 + draw(3)), 0.25F * draw(6)));
      case 21:
        return ignore(session_->layers().move(draw(9), {0.1F, 0.0F}));
      case 22:
        return ignore(session_->layers().remove_stroke(draw(9)));
      case 23:
      case 24:
        return ignore(session_->view().look_through(vantage()));
      case 25:
        return ignore(session_->view().reframe(draw(2) == 0 ? kFrontCamera : kSideCamera, draw(4) == 0 ? 40 : 48, 36));
      case 26:
        return ignore(Shots(*session_).clear_paint(vantage()));
      case 27:
        return ignore(solve_together());
      default:
        return ignore(session_->paint(light_strokes(), "strokes.json"));
    }
  }
  Vantage vantage() { return {draw(2) == 0 ? kFrontCamera : kSideCamera, static_cast<double>(draw(2))}; }
  /// All that is painted but for some.
  Result<void> solve_together() {
    std::vector<FrameChoice> choices;
    for (const PaintedFrame& painted : Shots(*session_).painted()) {
      if (draw(4) > 0) choices.push_back({painted.at, 1.0});
    }
    return Shots(*session_).solve(choices, two_evals(), false, {});
  }
  [[nodiscard]] unsigned draw(unsigned below) { return static_cast<unsigned>(random_() % below); }
  static SolveOptions two_evals() {
    SolveOptions options;
    options.max_evals = 2;
    return options;
  }

  std::mt19937 random_{seed_asked_for()};
};

TEST_F(SessionMonkeyTest, AllItsGesturesAreUndoneAndDoneAgain) {
  const std::string start = hash();
  const int count = gestures_asked_for(400);  // the workbench's monkey does more
  for (int i = 0; i < count; ++i) {
    act();
    if (i == count / 2) LUM_EXPECT_OK(session_->save_as(folder_.path() / "monkey.lum"));
  }
  const std::string end = hash();
  const std::size_t steps = session_->project().undo_steps();
  EXPECT_GT(steps, static_cast<std::size_t>(count / 40));
  while (session_->project().undo_steps() > 0) LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(hash(), start);
  while (session_->project().undo_steps() < steps) LUM_EXPECT_OK(session_->redo());
  EXPECT_EQ(hash(), end);
}

}  // namespace
}  // namespace luminist
