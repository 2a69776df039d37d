// A session beyond its camera: the paint of each, one rig for several.
#include <fstream>

#include "studio/script.h"
#include "studio/session_fixture.h"
#include "studio/shot_view.h"
#include "studio/shots.h"
#include "studio/two_cameras.h"

namespace luminist {
namespace {

/// The ball under one light, seen by two cameras.
class CamerasTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    LUM_ASSERT_OK(const Scene scene, two_cameras(folder_.file("ball.obj"), diagnostics_));
    LUM_EXPECT_OK(save_scene(scene, folder_.file("two.glb")));
    session_ = open_two("");
    NewLight plain;
    plain.from_paint = false;
    LUM_ASSERT_OK([[maybe_unused]] const std::string name, session_->add_light(plain));
  }
  std::unique_ptr<Session> open_two(const std::string& camera) {
    Shot two = shot();
    two.scene = "two.glb";
    two.camera = camera;
    return open(two);
  }
  void look_through(const std::string& camera) { LUM_EXPECT_OK(session_->view().reframe(camera, 48, 36)); }
  /// Blue light on the ball, where both cameras see it.
  static StrokeFile ball_strokes() {
    StrokeFile file = light_strokes();
    file.strokes[0].brush.color = Vec3(0.3F, 0.5F, 1.6F);
    file.strokes[0].brush.diameter = 0.3F;
    file.strokes[0].points = {{0.68F, 0.34F}, {0.7F, 0.39F}};
    return file;
  }
  /// Where only the other camera sees it.
  static StrokeFile side_strokes() {
    StrokeFile file = ball_strokes();
    file.strokes[0].brush.diameter = 0.15F;
    file.strokes[0].points = {{0.52F, 0.5F}, {0.53F, 0.55F}};
    return file;
  }
  void paint() { LUM_EXPECT_OK(session_->paint(ball_strokes(), "strokes.json")); }
  Image target() {
    auto target = session_->target();
    EXPECT_TRUE(target) << target.error().message();
    return target ? (*target)->color : Image();
  }
  Shots shots() { return Shots(*session_); }
  std::string save_rig_to(const std::string& name, const LightRig& rig) {
    LUM_EXPECT_OK(save_rig(rig, folder_.file(name)));
    return folder_.file(name);
  }
};

TEST_F(CamerasTest, PaintStaysWithItsCamera) {
  paint();
  const Image front = target();
  LUM_EXPECT_OK(session_->set_importance(0.35F, 0.65F));
  const std::string before = hash();
  look_through(kSideCamera);
  EXPECT_FALSE(session_->painted());
  EXPECT_EQ(session_->project().document().get("paint/nu"), "0.35") << "as the lighter last wanted";
  EXPECT_EQ(shots().painted(), (std::vector<PaintedFrame>{{{kFrontCamera, 0}, 1}}));
  paint();
  paint();
  const Image side = target();
  EXPECT_EQ(shots().painted(), (std::vector<PaintedFrame>{{{kSideCamera, 0}, 2}, {{kFrontCamera, 0}, 1}}));
  look_through("");
  EXPECT_EQ(target().data, front.data);
  EXPECT_EQ(shots().painted(), (std::vector<PaintedFrame>{{{kSideCamera, 0}, 2}, {{kFrontCamera, 0}, 1}}));
  look_through(kSideCamera);
  EXPECT_EQ(target().data, side.data);
  for (int step = 0; step < 5; ++step) LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(target().data, front.data);
}

TEST_F(CamerasTest, FramesStayWithTheirCamera) {
  paint();
  LUM_EXPECT_OK(session_->go_to(12));
  paint();
  paint();
  look_through(kSideCamera);
  paint();
  LUM_EXPECT_OK(session_->go_to(0));
  const std::vector<PaintedFrame> all = {{{kSideCamera, 12}, 1}, {{kFrontCamera, 0}, 1}, {{kFrontCamera, 12}, 2}};
  EXPECT_EQ(shots().painted(), all);
  EXPECT_FALSE(session_->painted());
  look_through(kFrontCamera);
  EXPECT_TRUE(session_->painted());
  EXPECT_EQ(shots().painted(), all);
  LUM_EXPECT_OK(shots().clear_paint({kSideCamera, 12}));
  EXPECT_EQ(error_of(shots().clear_paint({kSideCamera, 12})).kind, ErrorKind::kNothingToDo);
  EXPECT_EQ(shots().painted().size(), 2U);
}

TEST_F(CamerasTest, AnotherSizeLosesThePaintOfAll) {
  paint();
  look_through(kSideCamera);
  paint();
  LUM_EXPECT_OK(session_->view().reframe(kSideCamera, 32, 24));
  EXPECT_TRUE(shots().painted().empty());
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(shots().painted().size(), 2U);
}

TEST_F(CamerasTest, OneRigIsFoundForThePaintOfSeveralCamerasAndAcceptingItAnswersAll) {
  paint();
  look_through(kSideCamera);
  paint();
  LUM_EXPECT_OK(session_->paint(side_strokes(), "strokes.json"));
  const std::vector<FrameChoice> both = {{{"", 0}, 3.0}, {{kSideCamera, 0}, 1.0}};
  LUM_EXPECT_OK(shots().solve(both, few_evals(), true, {}));
  const Solved solved = *session_->solved();
  ASSERT_EQ(solved.frames.size(), 2U);
  EXPECT_LT(solved.report.epsilon, solved.report.epsilon_start);
  const double mean = (3.0 * solved.frames[0].start + solved.frames[1].start) / 4.0;
  EXPECT_NEAR(solved.report.epsilon_start, mean, 1e-4 * mean);
  // What it says of the camera that is looked through is what that camera's picture says, and so for the other one.
  const ParamState found = session_->shown();
  for (const SolvedFrame& frame : solved.frames) {
    ASSERT_TRUE(frame.verdict);
    EXPECT_EQ(frame.verdict->strokes.size(), frame.at.camera == kSideCamera ? 2U : 1U);
    const auto alone = open_two(frame.at.camera);
    LUM_EXPECT_OK(alone->load_rig(save_rig_to("before.toml", session_->state().rig), folder_.path()));
    LUM_EXPECT_OK(alone->set_importance(0.1F, 0.5F));
    LUM_EXPECT_OK(alone->paint(ball_strokes(), "strokes.json"));
    if (frame.at.camera == kSideCamera) LUM_EXPECT_OK(alone->paint(side_strokes(), "strokes.json"));
    LUM_ASSERT_OK(const Target* target, alone->target());
    LUM_ASSERT_OK(const double start, alone->stage().renderer->error(alone->state(), *target));
    LUM_ASSERT_OK(const double end, alone->stage().renderer->error(found, *target));
    EXPECT_NEAR(frame.start, start, 1e-4 * start) << frame.at.camera;
    EXPECT_NEAR(frame.found, end, 1e-4 * start) << frame.at.camera;
  }
  EXPECT_EQ(session_->solved()->verdict->strokes.size(), 2U) << "the side is looked through";
  LUM_EXPECT_OK(session_->accept());
  EXPECT_TRUE(shots().painted().empty());
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(shots().painted().size(), 2U);
}

TEST_F(CamerasTest, AcceptingLeavesThePaintThatTookNoPart) {
  paint();
  LUM_EXPECT_OK(session_->go_to(12));
  paint();
  look_through(kSideCamera);
  paint();
  const std::vector<FrameChoice> others = {{{kFrontCamera, 0}}, {{kFrontCamera, 12}}};
  LUM_EXPECT_OK(shots().solve(others, few_evals(), false, {}));
  LUM_EXPECT_OK(session_->accept());
  EXPECT_EQ(shots().painted(), (std::vector<PaintedFrame>{{{kSideCamera, 12}, 1}}));
  EXPECT_TRUE(session_->painted());
  const Image picture = this->picture();
  LUM_ASSERT_OK(const Image rendered, session_->stage().renderer->render(session_->state()));
  EXPECT_EQ(picture.data, rendered.data) << "under the lights that were accepted";
  const Image after = target();
  LUM_EXPECT_OK(session_->undo());
  LUM_EXPECT_OK(session_->redo());
  EXPECT_EQ(target().data, after.data);
  EXPECT_EQ(this->picture().data, picture.data);
}

TEST_F(CamerasTest, AnotherCameraAndFrameAreOneCommand) {
  LUM_EXPECT_OK(session_->set({"lights/light/color=1,0,0"}));
  LUM_ASSERT_OK([[maybe_unused]] const int keyed, session_->set_keys("lights/light/color", KeyInterpolation::kLinear));
  LUM_EXPECT_OK(session_->go_to(12));
  LUM_EXPECT_OK(session_->set({"lights/light/color=0,0,1"}));
  LUM_EXPECT_OK(session_->go_to(0));
  const auto color = [&] {
    const ParamBlock& params = session_->state().rig.lights.at(0).params;
    return params.vec3(*params.schema().find("color"));
  };
  paint();
  const std::size_t steps = session_->project().undo_steps();
  LUM_EXPECT_OK(session_->view().look_through({kSideCamera, 12}));
  EXPECT_EQ(session_->project().undo_steps(), steps + 1);
  EXPECT_EQ(session_->shot().camera, kSideCamera);
  EXPECT_EQ(session_->shot().frame, 12.0);
  EXPECT_EQ(color(), Vec3(0.0F, 0.0F, 1.0F)) << "as the keys say";
  EXPECT_FALSE(session_->painted());
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(color(), Vec3(1.0F, 0.0F, 0.0F));
  LUM_EXPECT_OK(session_->redo());
  EXPECT_EQ(color(), Vec3(0.0F, 0.0F, 1.0F));
  LUM_EXPECT_OK(session_->undo());
  EXPECT_TRUE(session_->painted());
  EXPECT_EQ(error_of(session_->view().look_through({"sied", 0})).kind, ErrorKind::kUsage);
  EXPECT_EQ(session_->project().undo_steps(), steps);
}

TEST_F(CamerasTest, PaintOfFramesInAProjectOfBeforeIsThatOfItsCamera) {
  paint();
  Document old = session_->project().document();
  const Vantage present{kFrontCamera, 0};
  turn_paint(old, present, {kFrontCamera, 24});
  Document written;
  for (const auto& [path, value] : old.entries()) {
    const std::string folder = "cameras/front/";
    written.set(path.starts_with(folder) ? path.substr(folder.size()) : path, value);
  }
  ASSERT_TRUE(written.has("frames/0/paint/strokes"));
  const Vantage there{kFrontCamera, 24};
  EXPECT_EQ(painted_frames(written, there), (std::vector<PaintedFrame>{{present, 1}}));
  Document looked = written;
  turn_paint(looked, there, {kSideCamera, 24});
  EXPECT_EQ(painted_frames(looked, {kSideCamera, 24}), (std::vector<PaintedFrame>{{present, 1}}));
  turn_paint(looked, {kSideCamera, 24}, present);
  EXPECT_EQ(looked.get("paint/strokes"), session_->project().document().get("paint/strokes"));
  Document both = written;  // one that an older version wrote beside it
  both.set("cameras/front/frames/0/paint/strokes", "7");
  EXPECT_EQ(painted_frames(both, there), (std::vector<PaintedFrame>{{present, 7}}));
  turn_paint(both, there, present);
  EXPECT_EQ(both.get("paint/strokes"), "7");
  Document put = written;
  Document paint;
  paint.set("paint/strokes", "3");
  put_frame_paint(put, there, present, paint);
  EXPECT_EQ(painted_frames(put, there), (std::vector<PaintedFrame>{{present, 3}}));
  EXPECT_FALSE(put.has("frames/0/paint/nu"));
  Document cleared = written;
  EXPECT_TRUE(clear_frame_paint(cleared, there, present));
  EXPECT_TRUE(painted_frames(cleared, there).empty());
  forget_paint(written);
  EXPECT_TRUE(painted_frames(written, there).empty());
}

TEST_F(CamerasTest, WhatIsNotPaintedOrNotThereIsNotSolved) {
  paint();
  const std::vector<FrameChoice> unpainted = {{{kFrontCamera, 0}}, {{kSideCamera, 0}}};
  EXPECT_EQ(error_of(shots().solve(unpainted, few_evals(), false, {})).kind, ErrorKind::kNothingToDo);
  const std::vector<FrameChoice> nobody = {{{kFrontCamera, 0}}, {{"sied", 0}}};
  EXPECT_EQ(error_of(shots().solve(nobody, few_evals(), false, {})).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(shots().clear_paint({"sied", 0})).kind, ErrorKind::kUsage);
  const std::vector<FrameChoice> twice = {{{kFrontCamera, 0}}, {{"", 0}}};
  EXPECT_EQ(error_of(shots().solve(twice, few_evals(), false, {})).kind, ErrorKind::kUsage);
}

TEST_F(CamerasTest, AScriptPaintsThroughCamerasAndAProjectKeepsIt) {
  std::ofstream(folder_.file("strokes.json")) << strokes_to_json(ball_strokes());
  std::ofstream(folder_.file("cameras.jsonl")) << R"({"do": "open", "scene": "two.glb", "size": [48, 36]}
{"do": "add_light", "name": "light", "from_paint": false}
{"do": "paint", "strokes": "strokes.json"}
{"do": "reframe", "camera": "100%/side"}
{"do": "paint", "strokes": "strokes.json"}
{"do": "solve_frames", "cameras": ["", "100%/side"], "max_evals": 10, "judge": false}
{"do": "revert"}
{"do": "reframe", "camera": "front", "frame": 6}
{"do": "reframe", "camera": "100%/side", "frame": 0}
{"do": "paint", "strokes": "strokes.json"}
{"do": "save", "project": "painted.lum"}
)";
  std::vector<std::string> solved;
  ScriptEvents events;
  events.solved = [&](const Solved& each, const ParamState&) {
    for (const SolvedFrame& frame : each.frames) solved.push_back(frame.at.camera);
  };
  LUM_EXPECT_OK(run_script(*device_, roots_, folder_.file("cameras.jsonl"), folder_.path(), events, diagnostics_));
  EXPECT_EQ(solved, (std::vector<std::string>{kFrontCamera, kSideCamera}));
  session_ = open_project("painted.lum");
  ASSERT_NE(session_, nullptr);
  EXPECT_EQ(session_->shot().camera, kSideCamera);
  EXPECT_EQ(shots().painted(), (std::vector<PaintedFrame>{{{kSideCamera, 0}, 2}, {{kFrontCamera, 0}, 1}}));
}

}  // namespace
}  // namespace luminist
