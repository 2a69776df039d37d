#include "studio/shot_view.h"

#include "image_io/image_io.h"
#include "studio/script.h"
#include "studio/session_fixture.h"
#include "support/held_memory.h"

namespace luminist {
namespace {

class ShotViewTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    LUM_EXPECT_OK(session_->add_light({.from_paint = false}));
  }
};

TEST_F(ShotViewTest, AnotherSizeIsOneCommandAndItsPaintComesBackByUndo) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  const std::string before = hash();
  const std::size_t steps = session_->project().undo_steps();
  LUM_EXPECT_OK(session_->view().reframe("", 32, 20));
  EXPECT_EQ(session_->project().undo_steps(), steps + 1);
  EXPECT_EQ(picture().width, 32);
  EXPECT_EQ(picture().height, 20);
  EXPECT_FALSE(session_->painted());
  EXPECT_EQ(session_->state().rig.lights.size(), 1U);
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(hash(), before);
  EXPECT_TRUE(session_->painted());
  EXPECT_EQ(picture().width, 48);
}

TEST_F(ShotViewTest, TheSameCameraAndSizeAreNoCommand) {
  const std::size_t steps = session_->project().undo_steps();
  LUM_EXPECT_OK(session_->view().reframe("", 48, 36));
  EXPECT_EQ(session_->project().undo_steps(), steps);
}

TEST_F(ShotViewTest, HowMuchCountsWhatIsNotPaintedOutlivesThePaint) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_EXPECT_OK(session_->set_importance(0.35F, 0.65F));
  LUM_EXPECT_OK(session_->view().reframe("", 32, 20));
  EXPECT_EQ(session_->project().document().get("paint/nu"), "0.35");
  EXPECT_EQ(session_->project().document().get("paint/delta"), "0.65");
}

TEST_F(ShotViewTest, WhatIsNoShotLeavesEverythingAsItWas) {
  const std::string before = hash();
  EXPECT_EQ(error_of(session_->view().reframe("nobody", 48, 36)).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(session_->view().reframe("", 0, 36)).kind, ErrorKind::kUsage);
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(picture().width, 48);
}

TEST_F(ShotViewTest, FromTheShotsOwnCameraTheShotIsSeen) {
  LUM_ASSERT_OK(FreeView * view, session_->view().from_anywhere());
  LUM_ASSERT_OK(const Image seen, view->picture(session_->stage().camera, 48, 36, session_->state()));
  const Image shot = picture();
  ASSERT_EQ(seen.data.size(), shot.data.size());
  double difference = 0.0;
  for (std::size_t i = 0; i < seen.data.size(); ++i) difference += std::abs(seen.data[i] - shot.data[i]);
  // Other clip planes round depths otherwise, which may decide a sample on an edge.
  EXPECT_LT(difference / static_cast<double>(seen.data.size()), 1e-3);
}

TEST_F(ShotViewTest, FromElsewhereSomethingElseIsSeenAndNothingIsRecorded) {
  const std::string before = hash();
  LUM_ASSERT_OK(FreeView * view, session_->view().from_anywhere());
  const Camera left = camera_at(Vec3(-6.0F, 1.0F, 0.0F), Vec3(0.0F, 1.0F, 0.0F), 0.7F);
  const Camera right = camera_at(Vec3(6.0F, 1.0F, 0.0F), Vec3(0.0F, 1.0F, 0.0F), 0.7F);
  LUM_ASSERT_OK(const Image from_left, view->picture(left, 40, 30, session_->state()));
  LUM_ASSERT_OK(const Image from_right, view->picture(right, 40, 30, session_->state()));
  LUM_ASSERT_OK(const Image again, view->picture(left, 40, 30, session_->state()));
  EXPECT_NE(from_left.data, from_right.data);
  EXPECT_EQ(from_left.data, again.data);
  EXPECT_EQ(hash(), before);
}

TEST_F(ShotViewTest, WhatPicturesFromElsewhereNeedIsGivenBack) {
  LUM_ASSERT_OK(FreeView * view, session_->view().from_anywhere());
  const Camera left = camera_at(Vec3(-6.0F, 1.0F, 0.0F), Vec3(0.0F, 1.0F, 0.0F), 0.7F);
  const auto render = [&] { return view->picture(left, 400, 300, session_->state()); };
  LUM_ASSERT_OK(const Image first, render());
  const std::size_t with = held_bytes();
  session_->view().put_away();
  if (device_->info().software && with > 0) {  // a sanitizer's memory is not told
    EXPECT_LT(held_bytes() + 100U * first.pixels(), with) << "most of what a pixel takes";
  }
  LUM_ASSERT_OK(const Image anew, render());
  EXPECT_EQ(first.data, anew.data);
}

TEST_F(ShotViewTest, ItsTrianglesAreMetByRays) {
  LUM_ASSERT_OK(const FreeView* view, session_->view().from_anywhere());
  const auto hit = first_hit(*view->solid(), Vec3(0.0F, 5.0F, 0.0F), Vec3(0.0F, -1.0F, 0.0F));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(*hit, 3.0F, 0.05F) << "a ball of radius 1 around height 1, of flat triangles";
  EXPECT_FALSE(first_hit(*view->solid(), Vec3(0.0F, 5.0F, 0.0F), Vec3(0.0F, 1.0F, 0.0F)));
}

TEST_F(ShotViewTest, AScriptLooksFromAnywhereAndReframes) {
  std::ofstream(folder_.file("look.jsonl")) << R"({"do": "open", "scene": "ball.obj", "size": [16, 12]}
{"do": "reframe", "size": [24, 16]}
{"do": "look", "from": [4, 3, 2], "at": [0, 1, 0], "to": "side.exr"}
{"do": "look", "from": [4, 3, 2], "at": [0, 1, 0], "fov": 60, "size": [10, 8], "to": "small.exr"}
)";
  LUM_EXPECT_OK(run_script(*device_, roots_, folder_.file("look.jsonl"), folder_.path(), {}, diagnostics_));
  LUM_ASSERT_OK(const Image side, read_image(folder_.file("side.exr")));
  EXPECT_EQ(side.width, 24);
  EXPECT_EQ(side.height, 16);
  LUM_ASSERT_OK(const Image small, read_image(folder_.file("small.exr")));
  EXPECT_EQ(small.width, 10);
}

}  // namespace
}  // namespace luminist
