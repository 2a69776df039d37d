// A session beyond its frame: keys anywhere in time, paint of other frames, one rig for several.
#include "studio/shots.h"

#include <fstream>

#include "studio/moving_ball.h"
#include "studio/script.h"
#include "studio/session_fixture.h"

namespace luminist {
namespace {

/// The ball goes to the right by its diameter in one second, under one light.
class ShotsTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    LUM_ASSERT_OK(const Scene scene, moving_ball(folder_.file("ball.obj"), {0.6F, 0.0F, 0.0F}, diagnostics_));
    LUM_EXPECT_OK(save_scene(scene, folder_.file("sliding.glb")));
    Shot moving = shot();
    moving.scene = folder_.file("sliding.glb");
    session_ = open(moving);
    ASSERT_NE(session_, nullptr);
    NewLight plain;
    plain.from_paint = false;
    LUM_ASSERT_OK([[maybe_unused]] const std::string name, session_->add_light(plain));
  }
  Shots shots() { return Shots(*session_); }
  [[nodiscard]] Vantage at(double frame) { return {shots().present().camera, frame}; }
  /// Frames of the present camera, as they are painted and as they take part.
  std::vector<PaintedFrame> painted(const std::vector<std::pair<double, std::uint32_t>>& frames) {
    std::vector<PaintedFrame> list;
    for (const auto& [frame, strokes] : frames) list.push_back({at(frame), strokes});
    return list;
  }
  std::vector<FrameChoice> choices(const std::vector<std::pair<double, double>>& frames) {
    std::vector<FrameChoice> list;
    for (const auto& [frame, weight] : frames) list.push_back({at(frame), weight});
    return list;
  }
  void paint_at(double frame) {
    LUM_EXPECT_OK(session_->go_to(frame));
    LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  }
  [[nodiscard]] float position(int component) {
    const Light& light = *session_->state().rig.find("light");
    return light.params.vec3(*light.params.schema().find("position"))[component];
  }
  [[nodiscard]] std::vector<double> keys() { return key_frames(session_->state().rig, "light"); }
  std::vector<std::string> labels() {
    std::vector<std::string> list;
    for (std::size_t i = 0; i < session_->project().undo_steps(); ++i) {
      const auto command = session_->project().command(i);
      list.push_back(command ? command->label : "?");
    }
    return list;
  }
};

TEST_F(ShotsTest, OneNumberOfAParameterIsKeyedAlone) {
  LUM_EXPECT_OK(session_->set({"lights/light/position=1,2,3"}));
  LUM_ASSERT_OK(const int keyed, session_->set_keys("lights/light/position.y", KeyInterpolation::kLinear));
  EXPECT_EQ(keyed, 1);
  LUM_EXPECT_OK(session_->go_to(10));
  LUM_EXPECT_OK(session_->set({"lights/light/position=5,6,7"}));
  LUM_EXPECT_OK(session_->go_to(5));
  EXPECT_EQ(position(1), 4.0F);
  EXPECT_EQ(position(0), 5.0F);  // without keys it stays as it was put last
  EXPECT_EQ(error_of(session_->set_keys("lights/light/direction.x", KeyInterpolation::kLinear)).kind,
            ErrorKind::kUsage);
}

TEST_F(ShotsTest, KeysOfNumbersAreInTheProject) {
  LUM_ASSERT_OK([[maybe_unused]] int keyed, session_->set_keys("lights/light/position.y", KeyInterpolation::kStep));
  LUM_ASSERT_OK(keyed, session_->set_keys("lights/light/color.b", KeyInterpolation::kSmooth));
  LUM_EXPECT_OK(session_->save_as(folder_.path() / "kept.lum"));
  const std::string rig = rig_to_toml(session_->state().rig);
  EXPECT_NE(rig.find("color.b = "), std::string::npos);
  session_.reset();
  session_ = open_project("kept.lum");
  ASSERT_NE(session_, nullptr);
  EXPECT_EQ(rig_to_toml(session_->state().rig), rig);
}

TEST_F(ShotsTest, KeysOfOtherFramesAreMovedAndTakenAwayAndGoOnOtherwise) {
  LUM_EXPECT_OK(session_->set({"lights/light/position=0,0,0"}));
  LUM_ASSERT_OK([[maybe_unused]] int count, session_->set_keys("lights/light/position", KeyInterpolation::kStep));
  LUM_EXPECT_OK(session_->go_to(10));
  LUM_EXPECT_OK(session_->set({"lights/light/position=8,0,0"}));
  LUM_EXPECT_OK(session_->go_to(5));
  EXPECT_EQ(position(0), 0.0F);
  LUM_ASSERT_OK(count, shots().interpolate_keys("lights/light/position", 0, KeyInterpolation::kLinear));
  EXPECT_EQ(position(0), 4.0F);  // what is looked at follows
  LUM_ASSERT_OK(count, shots().move_keys("lights/light", 10, 20));
  EXPECT_EQ(count, 1);
  EXPECT_EQ(position(0), 2.0F);
  EXPECT_EQ(keys(), (std::vector<double>{0, 20}));
  LUM_ASSERT_OK(count, shots().remove_keys("lights/light/position", 0));
  EXPECT_EQ(position(0), 8.0F);
  EXPECT_EQ(error_of(shots().remove_keys("lights/light/position", 0)).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(shots().move_keys("lights/light/position", 20, NAN)).kind, ErrorKind::kUsage);
  LUM_EXPECT_OK(session_->undo());
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(keys(), (std::vector<double>{0, 10}));
}

TEST_F(ShotsTest, ThePaintOfEveryFrameIsKnownAndIsClearedFromAnywhere) {
  EXPECT_TRUE(shots().painted().empty());
  paint_at(0);
  paint_at(12);
  paint_at(24);
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  EXPECT_EQ(shots().painted(), painted({{0, 1}, {12, 1}, {24, 2}}));
  LUM_EXPECT_OK(shots().clear_paint(at(0)));
  EXPECT_EQ(shots().painted(), painted({{12, 1}, {24, 2}}));
  EXPECT_EQ(error_of(shots().clear_paint(at(0))).kind, ErrorKind::kNothingToDo);
  LUM_EXPECT_OK(shots().clear_paint(at(24)));
  EXPECT_FALSE(session_->painted());
  LUM_EXPECT_OK(session_->go_to(0));
  EXPECT_FALSE(session_->painted());
  LUM_EXPECT_OK(session_->undo());
  LUM_EXPECT_OK(session_->undo());
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(shots().painted(), painted({{0, 1}, {12, 1}, {24, 2}}));
}

TEST_F(ShotsTest, OneRigIsFoundForThePaintOfSeveralFrames) {
  paint_at(24);
  paint_at(0);
  const std::vector<FrameChoice> both = choices({{0, 1.0}, {24, 3.0}});
  LUM_EXPECT_OK(shots().solve(both, few_evals(), true, {}));
  ASSERT_TRUE(session_->has_proposal());
  const Solved solved = *session_->solved();
  ASSERT_EQ(solved.frames.size(), 2U);
  for (const SolvedFrame& frame : solved.frames) {
    EXPECT_GT(frame.start, 0.0);
    ASSERT_TRUE(frame.verdict);
    EXPECT_EQ(frame.verdict->strokes.size(), 1U);
  }
  EXPECT_LT(solved.report.epsilon, solved.report.epsilon_start);
  const double mean = (solved.frames[0].start + 3.0 * solved.frames[1].start) / 4.0;
  EXPECT_NEAR(solved.report.epsilon_start, mean, 1e-4 * mean);  // the starting rig has no penalty
}

TEST_F(ShotsTest, AcceptingARigForSeveralFramesAnswersThePaintOfAllAndUndoBringsItBack) {
  paint_at(24);
  paint_at(0);
  const std::vector<FrameChoice> both = choices({{0, 1.0}, {24, 1.0}});
  LUM_EXPECT_OK(shots().solve(both, few_evals(), false, {}));
  EXPECT_FALSE(session_->solved()->frames[1].verdict);
  EXPECT_EQ(shots().painted().size(), 2U);
  LUM_EXPECT_OK(session_->accept());
  EXPECT_TRUE(shots().painted().empty());
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(shots().painted().size(), 2U);
  LUM_EXPECT_OK(session_->redo());
  LUM_EXPECT_OK(session_->go_to(24));
  EXPECT_FALSE(session_->painted());
}

TEST_F(ShotsTest, ASolveOfSeveralFramesShowsItsLightsAsItGoes) {
  paint_at(24);
  paint_at(0);
  const std::vector<FrameChoice> both = choices({{24, 1.0}, {0, 1.0}});
  std::vector<ParamState> seen;
  const auto look = [&](const ParamState& lights) -> Result<void> {
    seen.push_back(lights);
    LUM_TRY_VOID(session_->stage().renderer->render(lights));
    return {};
  };
  LUM_EXPECT_OK(shots().solve(both, few_evals(), false, {}, look));
  ASSERT_FALSE(seen.empty());
  const auto of = [](const ParamState& lights) { return rig_to_toml(lights.rig); };
  EXPECT_EQ(of(seen.back()), of(session_->shown())) << "the last ones are those that are proposed";
  LUM_EXPECT_OK(session_->revert());
  const auto refuse = [](const ParamState&) -> Result<void> {
    return Error{ErrorKind::kLimit, "no picture", "", "", ""};
  };
  EXPECT_EQ(error_of(shots().solve(both, few_evals(), false, {}, refuse)).kind, ErrorKind::kLimit);
  EXPECT_FALSE(session_->has_proposal());
}

TEST_F(ShotsTest, ASolveOfSeveralFramesThatIsStoppedKeepsTheBestSoFar) {
  paint_at(24);
  paint_at(0);
  const std::vector<FrameChoice> both = choices({{0, 1.0}, {24, 1.0}});
  LUM_EXPECT_OK(shots().solve(both, {}, true, [](const SolveReport&) { return false; }));
  ASSERT_TRUE(session_->has_proposal());
  EXPECT_EQ(session_->solved()->report.termination, Termination::kStopped);
  EXPECT_FALSE(session_->solved()->frames[0].verdict);
}

TEST_F(ShotsTest, WhatCannotBeSolvedTogetherIsSaid) {
  paint_at(24);
  paint_at(0);
  const auto solve = [&](const std::vector<std::pair<double, double>>& frames) {
    return error_of(shots().solve(choices(frames), few_evals(), false, {})).kind;
  };
  EXPECT_EQ(solve({{0, 1}}), ErrorKind::kUsage);
  EXPECT_EQ(solve({{0, 1}, {0, 1}}), ErrorKind::kUsage);
  EXPECT_EQ(solve({{0, 1}, {24, 0}}), ErrorKind::kUsage);
  EXPECT_EQ(solve({{0, 1}, {12, 1}}), ErrorKind::kNothingToDo);
  LUM_ASSERT_OK([[maybe_unused]] const int keyed, session_->set_keys("lights/light", KeyInterpolation::kLinear));
  EXPECT_EQ(solve({{0, 1}, {24, 1}}), ErrorKind::kNothingToDo);  // what may change is in each frame what its keys say
  EXPECT_FALSE(session_->has_proposal());
}

TEST_F(ShotsTest, WhatHasKeysStaysAsTheySayAndTheRestIsFoundForAllFrames) {
  LUM_EXPECT_OK(session_->set({"lights/light/color=1,0.2,0.2", "lights/light/position=0.3,1.2,1.5",
                               "lights/light/direction=-0.15,-0.6,-0.75"}));
  LUM_ASSERT_OK([[maybe_unused]] const int keyed, session_->set_keys("lights/light/color", KeyInterpolation::kLinear));
  LUM_EXPECT_OK(session_->go_to(24));
  LUM_EXPECT_OK(session_->set({"lights/light/color=0.2,0.2,1"}));
  paint_at(24);
  paint_at(0);
  const std::string keys_before = keys_to_toml(session_->state().rig);
  const Vec3 place(position(0), position(1), position(2));
  const std::vector<FrameChoice> both = choices({{24, 1.0}, {0, 1.0}});
  LUM_EXPECT_OK(shots().solve(both, few_evals(), false, {}));
  const Solved solved = *session_->solved();
  EXPECT_LT(solved.report.epsilon, solved.report.epsilon_start);
  const double mean = (solved.frames[0].start + solved.frames[1].start) / 2.0;
  EXPECT_NEAR(solved.report.epsilon_start, mean, 1e-4 * mean);  // each frame is compared under its own colour
  LUM_EXPECT_OK(session_->accept());
  EXPECT_EQ(keys_to_toml(session_->state().rig), keys_before);
  EXPECT_NE(Vec3(position(0), position(1), position(2)), place);
  const ParamBlock& params = session_->state().rig.find("light")->params;
  EXPECT_EQ(params.vec3(*params.schema().find("color")), Vec3(1.0F, 0.2F, 0.2F));
  EXPECT_FALSE(params.locked(params.schema()[*params.schema().find("color")].first_dof));
}

TEST_F(ShotsTest, LightsOfTheSceneGoWithItUntilTheLighterMovesThem) {
  LUM_ASSERT_OK(Scene scene, load_scene(folder_.file("sliding.glb"), {}, diagnostics_));
  PunctualLight torch;
  torch.name = "torch";
  torch.position = Vec3(0.0F, 2.0F, 2.0F);
  torch.intensity = 30.0F;
  torch.mount = scene.objects[0].mount;
  scene.lights.push_back(torch);
  hang(scene);
  LUM_EXPECT_OK(save_scene(scene, folder_.file("torch.glb")));
  Shot moving = shot();
  moving.scene = folder_.file("torch.glb");
  session_ = open(moving);
  ASSERT_NE(session_, nullptr);
  const auto x = [&] {
    const Light& light = session_->state().rig.lights.at(0);
    return light.params.vec3(*light.params.schema().find("position")).x;
  };
  LUM_EXPECT_OK(session_->go_to(24));
  EXPECT_NEAR(x(), 0.6F, 1e-5F);
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(x(), 0.0F);
  LUM_EXPECT_OK(session_->redo());
  LUM_EXPECT_OK(session_->set({"lights/torch/position=1,2,2"}));
  LUM_EXPECT_OK(session_->go_to(0));
  EXPECT_EQ(x(), 1.0F);
}

TEST_F(ShotsTest, AScriptDoesAllOfIt) {
  std::ofstream(folder_.file("strokes.json")) << strokes_to_json(light_strokes());
  std::ofstream(folder_.file("shots.jsonl")) << R"({"do": "open", "scene": "sliding.glb", "size": [48, 36]}
{"do": "add_light", "name": "light", "from_paint": false}
{"do": "key", "pattern": "lights/light/position.x"}
{"do": "go_to", "frame": 24}
{"do": "paint", "strokes": "strokes.json"}
{"do": "key", "pattern": ["lights/light/position.x", "lights/light/color"], "interpolation": "linear"}
{"do": "move_key", "pattern": "lights/light/color", "from": 24, "to": 12}
{"do": "key_interpolation", "pattern": "lights/light/color", "frame": 12, "interpolation": "step"}
{"do": "remove_key", "pattern": "lights/light/color", "frame": 12}
{"do": "remove_key", "pattern": "lights/light/position", "frame": 0}
{"do": "remove_key", "pattern": "lights/light/position.x"}
{"do": "go_to", "frame": 12}
{"do": "paint", "strokes": "strokes.json"}
{"do": "clear_paint", "frame": 24}
{"do": "go_to", "frame": 0}
{"do": "paint", "strokes": "strokes.json"}
{"do": "solve_frames", "frames": [0, 12], "weights": [1, 2], "max_evals": 10, "judge": false}
{"do": "accept"}
{"do": "save", "project": "made.lum"}
)";
  std::size_t frames = 0;
  ScriptEvents events;
  events.solved = [&](const Solved& solved, const ParamState&) { frames = solved.frames.size(); };
  LUM_EXPECT_OK(run_script(*device_, roots_, folder_.file("shots.jsonl"), folder_.path(), events, diagnostics_));
  EXPECT_EQ(frames, 2U);
  session_ = open_project("made.lum");
  ASSERT_NE(session_, nullptr);
  EXPECT_TRUE(shots().painted().empty());
  EXPECT_TRUE(session_->state().rig.keys.empty());
  std::ofstream(folder_.file("wrong.jsonl")) << R"({"do": "open", "scene": "sliding.glb", "size": [48, 36]}
{"do": "solve_frames", "frames": [0, 12], "weights": [1]}
)";
  EXPECT_EQ(error_of(run_script(*device_, roots_, folder_.file("wrong.jsonl"), folder_.path(), {}, diagnostics_)).field,
            "weights");
}

}  // namespace
}  // namespace luminist
