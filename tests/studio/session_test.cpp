#include "studio/session.h"

#include <fmt/format.h>

#include "studio/session_fixture.h"

namespace luminist {
namespace {

TEST_F(SessionTest, PaintBecomesLight) {
  const Image dim = picture();
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_ASSERT_OK(const std::string name, session_->add_light({}));
  EXPECT_EQ(name, "light");
  LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  ASSERT_TRUE(session_->has_proposal());
  EXPECT_LT(session_->solved()->report.epsilon, session_->solved()->report.epsilon_start);
  const Image proposed = picture();
  EXPECT_NE(proposed.data, dim.data);
  LUM_EXPECT_OK(session_->accept());
  EXPECT_FALSE(session_->has_proposal());
  EXPECT_FALSE(session_->painted());
  EXPECT_EQ(picture().data, proposed.data);
  // The accepted picture is what is painted on next.
  LUM_ASSERT_OK(const Target* target, session_->target());
  EXPECT_EQ(target->color.data, proposed.data);
}

TEST_F(SessionTest, OneGestureIsOneCommandAndASolveIsOneToo) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_EXPECT_OK(session_->add_light({}));
  EXPECT_EQ(session_->project().undo_steps(), 2U);
  LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  EXPECT_EQ(session_->project().undo_steps(), 2U);
  LUM_EXPECT_OK(session_->accept());
  EXPECT_EQ(session_->project().undo_steps(), 3U);
  LUM_ASSERT_OK(const Command accepted, session_->project().command(2));
  EXPECT_NE(accepted.action.find("\"epsilon\""), std::string::npos);
}

TEST_F(SessionTest, UndoBringsBackPictureAndPaint) {
  const std::string start = hash();
  const Image dim = picture();
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_ASSERT_OK(const Target* target, session_->target());
  const Image painted = target->color;
  LUM_EXPECT_OK(session_->add_light({}));
  LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  LUM_EXPECT_OK(session_->accept());
  const std::string end = hash();
  const Image solved = picture();

  LUM_EXPECT_OK(session_->undo());
  LUM_ASSERT_OK(target, session_->target());
  EXPECT_EQ(target->color.data, painted.data);
  EXPECT_EQ(target->before.data, dim.data);
  LUM_EXPECT_OK(session_->undo());
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(hash(), start);
  EXPECT_EQ(picture().data, dim.data);
  EXPECT_EQ(error_of(session_->undo()).kind, ErrorKind::kNothingToDo);
  for (int i = 0; i < 3; ++i) LUM_EXPECT_OK(session_->redo());
  EXPECT_EQ(hash(), end);
  EXPECT_EQ(picture().data, solved.data);
}

TEST_F(SessionTest, ADarkLightBeginsWhereThePaintSays) {
  NewLight wanted;
  wanted.dark = true;
  LUM_EXPECT_OK(session_->add_light(wanted));
  EXPECT_EQ(waiting_lights(session_->state().rig), std::vector<std::string>{"light"});
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  EXPECT_LT(session_->solved()->report.epsilon, session_->solved()->report.epsilon_start);
  EXPECT_TRUE(waiting_lights(session_->shown().rig).empty());
}

TEST_F(SessionTest, AdoptedLightsLeaveThePaintForAnotherSolve) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_EXPECT_OK(session_->add_light({}));
  LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  const Image shown = picture();
  LUM_ASSERT_OK(const Target* target, session_->target());
  const Image painted = target->color;
  LUM_EXPECT_OK(session_->adopt());
  EXPECT_FALSE(session_->has_proposal());
  EXPECT_TRUE(session_->painted());
  EXPECT_EQ(picture().data, shown.data);
  LUM_ASSERT_OK(target, session_->target());
  EXPECT_EQ(target->color.data, painted.data);
  EXPECT_EQ(error_of(session_->adopt()).kind, ErrorKind::kNothingToDo);
}

TEST_F(SessionTest, SeveralPatternsAreLockedAsOneCommandOrNotAtAll) {
  LUM_EXPECT_OK(session_->add_light({.from_paint = false}));
  const std::size_t steps = session_->project().undo_steps();
  const std::string before = hash();
  const std::vector<std::string> wrong = {"lights/light/color", "lights/nobody/color"};
  EXPECT_EQ(error_of(session_->set_locked(wrong, true)).kind, ErrorKind::kUsage);
  EXPECT_EQ(hash(), before);
  const std::vector<std::string> right = {"lights/light/color", "lights/light/position"};
  LUM_ASSERT_OK(const int named, session_->set_locked(right, true));
  EXPECT_EQ(named, 6);
  EXPECT_EQ(session_->project().undo_steps(), steps + 1);
}

TEST_F(SessionTest, ARevertedSolveLeavesEverythingAsItWas) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_EXPECT_OK(session_->add_light({}));
  const std::string before = hash();
  const Image shown = picture();
  LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  LUM_EXPECT_OK(session_->revert());
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(picture().data, shown.data);
  EXPECT_EQ(error_of(session_->revert()).kind, ErrorKind::kNothingToDo);
  EXPECT_EQ(error_of(session_->accept()).kind, ErrorKind::kNothingToDo);
}

TEST_F(SessionTest, AGestureDropsAProposal) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_EXPECT_OK(session_->add_light({}));
  LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  LUM_EXPECT_OK(session_->set({"ambient/color=0.2,0.2,0.2"}));
  EXPECT_FALSE(session_->has_proposal());
  EXPECT_EQ(session_->solved(), nullptr);
}

TEST_F(SessionTest, ASolveIsSteppedAndCanBeStopped) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_EXPECT_OK(session_->add_light({}));
  SolveOptions endless;
  endless.solver = SolverKind::kSimplex;
  int calls = 0;
  LUM_EXPECT_OK(session_->solve(endless, [&](const SolveReport&) { return ++calls < 3; }));
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(session_->solved()->report.termination, Termination::kStopped);
  LUM_EXPECT_OK(session_->accept());
}

TEST_F(SessionTest, AddingALightLocksTheOthers) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_EXPECT_OK(session_->add_light({.name = "key"}));
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_EXPECT_OK(session_->add_light({.type = "point", .name = "fill", .group = "soft"}));
  EXPECT_FALSE(session_->add_light({.name = "third", .group = "a:b"})) << "no rig file could hold it";
  const LightRig& rig = session_->state().rig;
  ASSERT_EQ(rig.lights.size(), 2U);
  int free_of_key = 0;
  int free_of_fill = 0;
  for (int dof = 0; dof < rig.lights[0].params.schema().dofs(); ++dof)
    free_of_key += rig.lights[0].params.locked(dof) ? 0 : 1;
  for (int dof = 0; dof < rig.lights[1].params.schema().dofs(); ++dof)
    free_of_fill += rig.lights[1].params.locked(dof) ? 0 : 1;
  EXPECT_EQ(free_of_key, 0);
  EXPECT_GT(free_of_fill, 0);
  LUM_ASSERT_OK(const int count, session_->set_locked("lights/key/color", false));
  EXPECT_EQ(count, 3);
}

TEST_F(SessionTest, LinkingALightIsAGestureThatCanBeUndone) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_EXPECT_OK(session_->add_light({.name = "key", .group = "hero"}));
  const Image lit = picture();
  LUM_EXPECT_OK(session_->link_light("group:hero", {"flo*"}));
  EXPECT_EQ(session_->state().rig.lights[0].objects, (std::vector<std::string>{"flo*"}));
  const Image linked = picture();
  EXPECT_NE(linked.data, lit.data);
  const auto wrong = session_->link_light("key", {"flor"});
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().hint.find("floor"), std::string::npos) << wrong.error().message();
  EXPECT_EQ(picture().data, linked.data);
  LUM_EXPECT_OK(session_->undo());
  EXPECT_TRUE(session_->state().rig.lights[0].objects.empty());
  EXPECT_EQ(picture().data, lit.data);
}

TEST_F(SessionTest, AStartLightBrightensThePaint) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_ASSERT_OK(const Target* painted, session_->target());
  const Target target = *painted;
  LUM_EXPECT_OK(session_->add_light({}));
  const Image lit = picture();
  double gain = 0.0;
  for (std::size_t pixel = 0; pixel < lit.pixels(); ++pixel) {
    if (target.stroke[pixel] != 0) gain += lit.rgb(pixel).y - target.before.rgb(pixel).y;
  }
  EXPECT_GT(gain, 0.0);
}

TEST_F(SessionTest, ASecondLightStartsFromWhatTheFirstLeaves) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_EXPECT_OK(session_->add_light({}));
  LUM_EXPECT_OK(session_->add_light({}));
  const LightRig& rig = session_->state().rig;
  ASSERT_EQ(rig.lights.size(), 2U);
  EXPECT_EQ(rig.lights[1].name, "light-2");
  EXPECT_FALSE(rig.lights[0].params.same_values(rig.lights[1].params));
}

TEST_F(SessionTest, NothingIsDoneWithoutPaint) {
  const std::string before = hash();
  EXPECT_EQ(error_of(session_->add_light({})).kind, ErrorKind::kNothingToDo);
  EXPECT_EQ(error_of(session_->start_solve({})).kind, ErrorKind::kNothingToDo);
  EXPECT_EQ(error_of(session_->clear_paint()).kind, ErrorKind::kNothingToDo);
  EXPECT_EQ(error_of(session_->paint({}, "")).kind, ErrorKind::kNothingToDo);
  EXPECT_EQ(hash(), before);
  LUM_EXPECT_OK(session_->add_light({.from_paint = false}));
}

TEST_F(SessionTest, AFailedGestureChangesNothing) {
  LUM_EXPECT_OK(session_->add_light({.from_paint = false}));
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  const std::string before = hash();
  const Image shown = picture();
  StrokeFile bad = light_strokes();
  bad.strokes.push_back(bad.strokes.front());
  bad.strokes.back().brush.clip = "ghost";
  EXPECT_EQ(error_of(session_->paint(bad, "bad.json")).kind, ErrorKind::kBadContent);
  EXPECT_EQ(error_of(session_->set({"ambient/color=1,1,1", "ambient/colour=1,1,1"})).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(session_->set_locked("lights/ghost/*", true)).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(session_->remove_light("ghost")).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(session_->set_importance(2.0F, 0.5F)).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(session_->restyle("ghost")).kind, ErrorKind::kMissing);
  EXPECT_EQ(error_of(session_->load_rig("ghost.toml", folder_.path())).kind, ErrorKind::kMissing);
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(picture().data, shown.data);
  LUM_ASSERT_OK(const Target* target, session_->target());
  EXPECT_EQ(*std::max_element(target->stroke.begin(), target->stroke.end()), 1U);
}

TEST_F(SessionTest, AGestureWithoutEffectIsNotRecorded) {
  LUM_EXPECT_OK(session_->add_light({.from_paint = false}));
  const std::size_t steps = session_->project().undo_steps();
  LUM_EXPECT_OK(session_->set_muted("light", false));
  EXPECT_EQ(session_->project().undo_steps(), steps);
}

TEST_F(SessionTest, ThePaintStaysWhenTheLightsChangeUnderIt) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_ASSERT_OK(const Target* target, session_->target());
  const Image painted = target->color;
  LUM_EXPECT_OK(session_->set({"ambient/color=0.5,0.5,0.5"}));
  LUM_ASSERT_OK(target, session_->target());
  EXPECT_EQ(target->color.data, painted.data);
  LUM_EXPECT_OK(session_->clear_paint());
  LUM_ASSERT_OK(target, session_->target());
  EXPECT_EQ(target->color.data, picture().data);
}

TEST_F(SessionTest, TheShadowBrushShowsThePictureWithoutTheFreeLights) {
  LUM_EXPECT_OK(session_->add_light({.name = "key", .from_paint = false}));
  const Image lit = picture();
  StrokeFile shadow;
  Stroke stroke;
  stroke.brush.tool = PaintTool::kShadow;
  stroke.brush.bucket = true;
  shadow.strokes = {stroke};
  LUM_EXPECT_OK(session_->paint(shadow, "shadow.json"));
  LUM_ASSERT_OK(const Target* target, session_->target());
  const Image shadowed = target->color;
  LUM_EXPECT_OK(session_->clear_paint());
  LUM_EXPECT_OK(session_->set_muted("key", true));
  EXPECT_EQ(shadowed.data, picture().data);
  EXPECT_NE(shadowed.data, lit.data);
  LUM_EXPECT_OK(session_->set_muted("key", false));
  LUM_EXPECT_OK(session_->set_locked("lights/key/*", true));  // now it is not free
  LUM_EXPECT_OK(session_->paint(shadow, "shadow.json"));
  LUM_ASSERT_OK(target, session_->target());
  EXPECT_EQ(target->color.data, lit.data);
}

TEST_F(SessionTest, TheImportanceMapAdvancesOnlyWhenASolveIsAccepted) {
  StrokeFile strokes = light_strokes();
  strokes.nu = 0.2F;
  strokes.delta = 0.5F;
  LUM_EXPECT_OK(session_->paint(strokes, "strokes.json"));
  LUM_EXPECT_OK(session_->add_light({}));
  LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  LUM_EXPECT_OK(session_->revert());
  LUM_ASSERT_OK(const Target* target, session_->target());
  EXPECT_EQ(target->importance.at(0, 0, 0), 0.2F);
  LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  LUM_EXPECT_OK(session_->accept());
  LUM_ASSERT_OK(target, session_->target());
  // Painted before, not now: (1 - 0.5) 0.2 + 0.5 * 1.
  EXPECT_NEAR(*std::max_element(target->importance.data.begin(), target->importance.data.end()), 0.6F, 1e-6F);
}

TEST_F(SessionTest, RestylesAndComesBack) {
  LUM_EXPECT_OK(session_->add_light({.from_paint = false}));
  const Image cinematic = picture();
  LUM_EXPECT_OK(session_->restyle("toon"));
  EXPECT_NE(picture().data, cinematic.data);
  EXPECT_EQ(session_->state().rig.lights.size(), 1U);
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(session_->shot().style, "cinematic");
  EXPECT_EQ(picture().data, cinematic.data);
}

TEST_F(SessionTest, SurvivesARestartInTheMiddleOfTheWork) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_EXPECT_OK(session_->save_as(folder_.path() / "ball.lum"));
  LUM_EXPECT_OK(session_->add_light({}));
  LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  LUM_EXPECT_OK(session_->accept());
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  const std::string last = hash();
  const Image shown = picture();
  LUM_ASSERT_OK(const Target* target, session_->target());
  const Target painted = *target;
  session_.reset();  // without saving
  session_ = open_project("ball.lum");
  ASSERT_NE(session_, nullptr);
  EXPECT_EQ(hash(), last);
  EXPECT_EQ(picture().data, shown.data);
  LUM_ASSERT_OK(target, session_->target());
  EXPECT_EQ(target->color.data, painted.color.data);
  EXPECT_EQ(target->before.data, painted.before.data);
  EXPECT_EQ(target->importance.data, painted.importance.data);
  EXPECT_EQ(target->stroke, painted.stroke);
  EXPECT_EQ(session_->project().undo_steps(), 4U);
}

TEST_F(SessionTest, ASecondSessionReadsAndDoesNotWrite) {
  LUM_EXPECT_OK(session_->save_as(folder_.path() / "ball.lum"));
  EXPECT_EQ(error_of(Session::open_project(*device_, roots_, folder_.path() / "ball.lum", Project::Access::kWrite,
                                           diagnostics_))
                .kind,
            ErrorKind::kProject);
  const auto reader = open_project("ball.lum", Project::Access::kRead);
  ASSERT_NE(reader, nullptr);
  EXPECT_EQ(error_of(reader->set({"ambient/color=1,1,1"})).kind, ErrorKind::kProject);
  EXPECT_EQ(reader->project().document().hash(), hash());
}

TEST_F(SessionTest, TargetsOfAnotherSizeAreScaledWithAWarning) {
  LUM_EXPECT_OK(session_->set_target(Image(24, 18, 4, 0.5F), Image(24, 18, 1, 0.25F)));
  ASSERT_EQ(diagnostics_.warnings().size(), 2U);
  EXPECT_NE(diagnostics_.warnings()[0].what.find("scaled"), std::string::npos);
  LUM_ASSERT_OK(const Target* target, session_->target());
  EXPECT_EQ(target->color.at(10, 10, 2), 0.5F);
  EXPECT_EQ(target->importance.at(10, 10, 0), 0.25F);
  EXPECT_EQ(error_of(session_->set_target(Image(48, 36, 7), std::nullopt)).kind, ErrorKind::kBadContent);
}

}  // namespace
}  // namespace luminist
