#include "studio/light_list.h"

#include "studio/script.h"
#include "studio/session_fixture.h"

namespace luminist {
namespace {

/// The session with two lights.
class LightListTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    LUM_EXPECT_OK(session_->add_light({.name = "key", .from_paint = false}));
    LUM_EXPECT_OK(session_->add_light({.name = "fill", .from_paint = false}));
  }
  /// What a gesture did is undone and done again as one command.
  void expect_one_command(const std::string& before, std::size_t steps) {
    const std::string after = hash();
    EXPECT_EQ(session_->project().undo_steps(), steps + 1);
    LUM_EXPECT_OK(session_->undo());
    EXPECT_EQ(hash(), before);
    LUM_EXPECT_OK(session_->redo());
    EXPECT_EQ(hash(), after);
  }
};

TEST_F(LightListTest, ARenamedLightLightsAsBefore) {
  const Image lit = picture();
  const std::string before = hash();
  const std::size_t steps = session_->project().undo_steps();
  LUM_EXPECT_OK(session_->light_list().rename("key", "sun"));
  EXPECT_EQ(session_->state().rig.lights[0].name, "sun");
  EXPECT_EQ(picture().data, lit.data);
  expect_one_command(before, steps);
  LUM_EXPECT_OK(session_->save_as(folder_.path() / "list.lum"));
  session_.reset();
  session_ = open_project("list.lum");
  ASSERT_NE(session_, nullptr);
  EXPECT_EQ(session_->state().rig.lights[0].name, "sun");
}

TEST_F(LightListTest, ACopyAddsItsLightOnceMore) {
  LUM_EXPECT_OK(session_->set_muted("fill", true));
  LUM_EXPECT_OK(session_->set({"ambient/color=0,0,0"}));
  const Image one = picture();
  const std::string before = hash();
  const std::size_t steps = session_->project().undo_steps();
  LUM_ASSERT_OK(const std::string copy, session_->light_list().duplicate("key"));
  EXPECT_EQ(copy, "key-2");
  const Image two = picture();
  double sum_one = 0.0;
  double sum_two = 0.0;
  for (const float value : one.data) sum_one += value;
  for (const float value : two.data) sum_two += value;
  EXPECT_NEAR(sum_two, 2.0 * sum_one, 1e-3 * sum_one) << "rounding of floats";
  expect_one_command(before, steps);
}

TEST_F(LightListTest, AGroupIsMutedLinkedAndLockedAsOne) {
  const std::string before = hash();
  const std::size_t steps = session_->project().undo_steps();
  LUM_EXPECT_OK(session_->light_list().group({"key", "fill"}, "warm"));
  expect_one_command(before, steps);
  LUM_EXPECT_OK(session_->light_list().mute({"group:warm"}, true));
  EXPECT_EQ(session_->project().undo_steps(), steps + 2);
  for (const Light& light : session_->state().rig.lights) EXPECT_TRUE(light.muted);
  LUM_ASSERT_OK(const int dofs, session_->set_locked("group:warm/color", true));
  EXPECT_EQ(dofs, 6);
}

TEST_F(LightListTest, AScriptKeepsTheListToo) {
  std::ofstream(folder_.file("list.jsonl")) << R"({"do": "open", "scene": "ball.obj", "size": [16, 12]}
{"do": "add_light", "name": "key", "from_paint": false}
{"do": "rename_light", "light": "key", "name": "sun"}
{"do": "duplicate_light", "light": "sun", "name": "moon"}
{"do": "group_lights", "lights": ["sun", "moon"], "group": "sky"}
{"do": "mute", "light": ["group:sky"]}
{"do": "share_shadows", "light": "moon"}
{"do": "save", "project": "list.lum"}
)";
  LUM_EXPECT_OK(run_script(*device_, roots_, folder_.file("list.jsonl"), folder_.path(), {}, diagnostics_));
  session_.reset();
  session_ = open_project("list.lum", Project::Access::kRead);
  ASSERT_NE(session_, nullptr);
  const LightRig& rig = session_->state().rig;
  ASSERT_EQ(rig.lights.size(), 2U);
  EXPECT_EQ(rig.lights[0].name, "sun");
  EXPECT_EQ(rig.lights[1].name, "moon");
  EXPECT_EQ(rig.lights[1].group, "sky");
  EXPECT_TRUE(rig.lights[0].muted && rig.lights[1].muted);
  EXPECT_EQ(rig.shadow_light, "moon");
}

}  // namespace
}  // namespace luminist
