// Small pictures of frames, beside a session.
#include "studio/frame_strip.h"

#include <map>

#include "studio/moving_session.h"

namespace luminist {
namespace {

class FrameStripTest : public MovingSessionTest {
 protected:
  void SetUp() override {
    MovingSessionTest::SetUp();
    NewLight plain;
    plain.from_paint = false;
    LUM_ASSERT_OK([[maybe_unused]] const std::string name, session_->add_light(plain));
    strip_ = std::make_unique<FrameStrip>(*device_, roots_);
  }
  void TearDown() override { strip_.reset(); }
  int make_all() {
    int made = 0;
    for (bool more = true; more && made < 100;) {
      auto step = strip_->step(*session_, session_->state());
      EXPECT_TRUE(step) << step.error().message();
      more = step && *step;
      made += more ? 1 : 0;
    }
    return made;
  }
  FrameFacts facts() {
    StudioSnapshot snapshot;
    strip_->tell(*session_, snapshot);
    return *snapshot.frames;
  }

  std::unique_ptr<FrameStrip> strip_;
};

TEST_F(FrameStripTest, MakesWhatIsWantedAroundThePresentFrameAndNothingElse) {
  EXPECT_EQ(make_all(), 0);
  strip_->want(3, 6);
  EXPECT_EQ(make_all(), 3);
  std::vector<double> frames;
  for (const FramePicture& each : facts().strip) frames.push_back(each.frame);
  EXPECT_EQ(frames, (std::vector<double>{0, 6, 12}));  // there is nothing before the first
  EXPECT_NE(facts().strip[0].picture->data, facts().strip[2].picture->data);
  const std::string before = hash();
  LUM_EXPECT_OK(session_->go_to(12));
  EXPECT_EQ(make_all(), 1);  // 18
  EXPECT_NE(hash(), before);
}

TEST_F(FrameStripTest, OtherLightsMakeItsPicturesOld) {
  strip_->want(2, 6);
  EXPECT_EQ(make_all(), 2);
  LUM_EXPECT_OK(session_->set({"lights/light/color=0.1,0.1,3"}));
  LUM_ASSERT_OK(const bool made, strip_->step(*session_, session_->state()));
  EXPECT_TRUE(made);
  EXPECT_FALSE(facts().strip[0].old);
  EXPECT_TRUE(facts().strip[1].old);
  EXPECT_EQ(make_all(), 1);
  EXPECT_FALSE(facts().strip[1].old);
}

TEST_F(FrameStripTest, APreviewIsTheFrameThatGoingThereShows) {
  LUM_ASSERT_OK([[maybe_unused]] const int keyed, session_->set_keys("lights/light/color", KeyInterpolation::kLinear));
  LUM_EXPECT_OK(session_->go_to(24));
  LUM_EXPECT_OK(session_->set({"lights/light/color=0,0,2"}));
  LUM_EXPECT_OK(session_->go_to(0));
  const std::string before = hash();
  LUM_EXPECT_OK(strip_->preview(*session_, session_->state(), 24));
  EXPECT_EQ(hash(), before);
  StudioSnapshot snapshot;
  snapshot.unanswered = 1;
  strip_->tell(*session_, snapshot);
  EXPECT_EQ(snapshot.frames->previewed, 24.0);
  EXPECT_EQ(snapshot.frames->frame, 0.0);
  EXPECT_EQ(snapshot.unanswered, 0U);
  LUM_EXPECT_OK(session_->go_to(24));
  EXPECT_EQ(snapshot.picture->data, picture().data);  // 48 x 36: as small as the shot
  EXPECT_EQ(rig_to_toml(snapshot.shown->rig), rig_to_toml(session_->state().rig));
  strip_->leave_preview();
  EXPECT_FALSE(facts().previewed);
}

TEST_F(FrameStripTest, APathTracedShotIsPreviewedByPathsOfItsOwn) {
  Shot shot = moving_;
  shot.scene_options.floor = true;
  std::map<std::string, Image> previews;
  for (const char* style : {"cinematic", "path"}) {
    shot.style = style;
    auto session = Session::open(*device_, roots_, shot, folder_.path(), diagnostics_);
    ASSERT_TRUE(session) << session.error().message();
    NewLight plain;
    plain.type = "point";
    plain.from_paint = false;
    LUM_ASSERT_OK(const std::string light, (*session)->add_light(plain));
    LUM_EXPECT_OK((*session)->set({"lights/" + light + "/position=0,6,0", "ambient/color=0,0,0"}));
    LUM_EXPECT_OK(strip_->preview(**session, (*session)->state(), 3));
    StudioSnapshot snapshot;
    strip_->tell(**session, snapshot);
    previews[style] = *snapshot.picture;
    EXPECT_EQ(snapshot.shown->style.schema().names(), (*session)->state().style.schema().names());
  }
  const Image& direct = previews["cinematic"];
  const Image& paths = previews["path"];
  ASSERT_EQ(paths.pixels(), direct.pixels());
  int lit_by_the_floor = 0;  // the ball's lower half
  int only_direct = 0;
  for (std::size_t i = 0; i < direct.pixels(); ++i) {
    const bool dark = glm::length(direct.rgb(i)) < 1e-4F;
    const bool dark_for_paths = glm::length(paths.rgb(i)) < 1e-4F;
    lit_by_the_floor += dark && !dark_for_paths ? 1 : 0;
    only_direct += !dark && dark_for_paths ? 1 : 0;
  }
  EXPECT_GT(lit_by_the_floor, 15);
  EXPECT_LT(only_direct, 15);  // along edges
}

TEST_F(FrameStripTest, TheRangeIsThatOfWhatMovesAndOfTheKeys) {
  EXPECT_EQ(facts().last, 24);
  EXPECT_TRUE(facts().moving);
  LUM_EXPECT_OK(session_->go_to(40));
  LUM_ASSERT_OK([[maybe_unused]] const int keyed, session_->set_keys("lights/light/color", KeyInterpolation::kLinear));
  LUM_EXPECT_OK(session_->go_to(0));
  EXPECT_EQ(facts().last, 40);
  EXPECT_EQ(facts().first, 0);
}

}  // namespace
}  // namespace luminist
