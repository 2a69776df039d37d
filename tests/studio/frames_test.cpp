// Frames: a session that moves through time, and sequences of pictures.
#include <fmt/format.h>

#include "base/process.h"
#include "image_io/image_io.h"
#include "studio/moving_session.h"
#include "studio/sequence.h"

namespace luminist {
namespace {

class FramesTest : public MovingSessionTest {
 protected:
  [[nodiscard]] float key_height() {
    const Light& light = *session_->state().rig.find("light");
    return light.params.vec3(*light.params.schema().find("position")).y;
  }
  void set_height(double y) { LUM_EXPECT_OK(session_->set({fmt::format("lights/light/position=0,{},3", y)})); }
  Sequence sequence(const std::string& pattern) { return {moving_, {0, 12, 24}, folder_.file(pattern), {}, {}, false}; }
  /// A light is found for paint at frame 0; its colour has a key at 24.
  void solve_with_a_key_later() {
    LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
    LUM_ASSERT_OK([[maybe_unused]] const std::string name, session_->add_light({}));
    LUM_EXPECT_OK(session_->go_to(24));
    LUM_ASSERT_OK([[maybe_unused]] const int keyed,
                  session_->set_keys("lights/light/color", KeyInterpolation::kLinear));
    LUM_EXPECT_OK(session_->go_to(0));
    LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  }
  /// Frames that were rendered, not those that were there.
  std::vector<int> rendered(const Sequence& sequence) {
    std::vector<int> frames;
    LUM_EXPECT_OK(render_sequence(
        *device_, roots_, sequence,
        [&](const FrameDone& done) {
          if (!done.skipped) frames.push_back(done.frame);
          return true;
        },
        diagnostics_));
    return frames;
  }
};

TEST_F(FramesTest, WhatMovesIsSeenElsewhereAtAnotherFrame) {
  const Image before = picture();
  const SceneFrame frame = session_->stage().frame;
  LUM_EXPECT_OK(session_->go_to(24));
  EXPECT_NE(picture().data, before.data);
  EXPECT_EQ(session_->stage().frame.radius, frame.radius);  // parameters mean the same at every frame
  LUM_EXPECT_OK(session_->go_to(0));
  EXPECT_EQ(picture().data, before.data);
}

TEST_F(FramesTest, GoingToAFrameIsUndone) {
  const std::string start = hash();
  const Image before = picture();
  LUM_EXPECT_OK(session_->go_to(24));
  const Image after = picture();
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(hash(), start);
  EXPECT_EQ(picture().data, before.data);
  LUM_EXPECT_OK(session_->redo());
  EXPECT_EQ(picture().data, after.data);
}

TEST_F(FramesTest, EachFrameKeepsItsPaint) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_ASSERT_OK(const Target* target, session_->target());
  const Image painted = target->color;
  LUM_EXPECT_OK(session_->go_to(12));
  EXPECT_FALSE(session_->painted());
  LUM_EXPECT_OK(session_->go_to(0));
  EXPECT_TRUE(session_->painted());
  LUM_ASSERT_OK(target, session_->target());
  EXPECT_EQ(target->color.data, painted.data);
}

TEST_F(FramesTest, AFrameThatWasNeverPaintedHasTheImportanceOfTheOneBefore) {
  LUM_EXPECT_OK(session_->set_importance(0.3F, 0.75F));
  LUM_EXPECT_OK(session_->go_to(12));
  LUM_ASSERT_OK(const Target* target, session_->target());
  EXPECT_FLOAT_EQ(target->importance.data[0], 0.3F);
  LUM_EXPECT_OK(session_->set_importance(0.5F, 0.0F));
  LUM_EXPECT_OK(session_->go_to(0));
  LUM_ASSERT_OK(target, session_->target());
  EXPECT_FLOAT_EQ(target->importance.data[0], 0.3F);
}

TEST_F(FramesTest, KeyedLightsFollowTheirKeysAndWhatIsChangedAtAFrameIsAKey) {
  NewLight plain;
  plain.from_paint = false;
  LUM_ASSERT_OK([[maybe_unused]] const std::string name, session_->add_light(plain));
  set_height(1);
  LUM_ASSERT_OK(const int keyed, session_->set_keys("lights/light/position", KeyInterpolation::kLinear));
  EXPECT_EQ(keyed, 1);
  LUM_EXPECT_OK(session_->go_to(10));
  EXPECT_EQ(key_height(), 1.0F);
  set_height(5);
  EXPECT_EQ(key_frames(session_->state().rig, "light"), (std::vector<double>{0, 10}));
  LUM_EXPECT_OK(session_->go_to(5));
  EXPECT_EQ(key_height(), 3.0F);
  LUM_EXPECT_OK(session_->go_to(10));
  LUM_ASSERT_OK(const int removed, session_->remove_keys("lights/light/*"));
  EXPECT_EQ(removed, 1);
  EXPECT_EQ(key_height(), 1.0F);
  EXPECT_EQ(error_of(session_->remove_keys("lights/light/*")).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(session_->set_keys("style/*", KeyInterpolation::kStep)).kind, ErrorKind::kUsage);
}

TEST_F(FramesTest, KeysAndFramesAreInTheProject) {
  NewLight plain;
  plain.from_paint = false;
  LUM_ASSERT_OK([[maybe_unused]] const std::string name, session_->add_light(plain));
  LUM_ASSERT_OK([[maybe_unused]] const int keyed, session_->set_keys("lights/light", KeyInterpolation::kSmooth));
  LUM_EXPECT_OK(session_->go_to(7));
  set_height(4);
  LUM_EXPECT_OK(session_->save_as(folder_.path() / "kept.lum"));
  const std::string rig = rig_to_toml(session_->state().rig);
  const Image kept = picture();
  session_.reset();
  session_ = open_project("kept.lum");
  ASSERT_NE(session_, nullptr);
  EXPECT_EQ(session_->shot().frame, 7.0);
  EXPECT_EQ(rig_to_toml(session_->state().rig), rig);
  EXPECT_EQ(picture().data, kept.data);
}

TEST_F(FramesTest, AnAcceptedSolveIsAKeyAtItsFrame) {
  solve_with_a_key_later();
  LUM_EXPECT_OK(session_->accept());
  EXPECT_EQ(key_frames(session_->state().rig, "light"), (std::vector<double>{0, 24}));
}

TEST_F(FramesTest, WhatIsProposedIsAKeyOfTheFrameThatIsLeft) {
  solve_with_a_key_later();
  const auto color = [&] {
    const ParamBlock& light = session_->shown().rig.find("light")->params;
    return light.vec3(*light.schema().by_role("color"));
  };
  const Vec3 found = color();
  LUM_EXPECT_OK(session_->change_shown([](Session& session) { return session.go_to(24); }));
  EXPECT_NE(color(), found) << "the solve changes the colour, or this shows nothing";
  LUM_EXPECT_OK(session_->change_shown([](Session& session) { return session.go_to(0); }));
  EXPECT_EQ(color(), found);
}

TEST_F(FramesTest, ASequenceIsRenderedOnceAndAgainWhereSomethingIsWrong) {
  const Sequence all = sequence("f.##.exr");
  EXPECT_EQ(rendered(all), (std::vector<int>{0, 12, 24}));
  LUM_ASSERT_OK(const Image first, read_image(folder_.file("f.00.exr")));
  LUM_ASSERT_OK(const Image last, read_image(folder_.file("f.24.exr")));
  EXPECT_NE(first.data, last.data);
  EXPECT_EQ(rendered(all), std::vector<int>());
  std::filesystem::resize_file(folder_.file("f.12.exr"), 300);
  EXPECT_EQ(rendered(all), std::vector<int>{12});
  Sequence other = all;
  other.shot.set = {"ambient/color=1,1,1"};
  EXPECT_EQ(rendered(other), (std::vector<int>{0, 12, 24}));
  EXPECT_EQ(rendered(all), (std::vector<int>{0, 12, 24}));
}

TEST_F(FramesTest, AnotherShaderMakesFramesOld) {
  const Sequence all = sequence("s.##.exr");
  EXPECT_EQ(rendered(all), (std::vector<int>{0, 12, 24}));
  EXPECT_EQ(rendered(all), std::vector<int>{});
  LUM_ASSERT_OK(const std::filesystem::path diffuse, roots_.find("shaders/lib/diffuse.glsl"));
  const std::filesystem::path own = folder_.path() / "own/shaders/lib";
  std::filesystem::create_directories(own);
  std::filesystem::copy(diffuse, own / "diffuse.glsl");
  std::ofstream(own / "diffuse.glsl", std::ios::app) << "// another version\n";
  std::vector<std::filesystem::path> folders = roots_.folders();
  folders.insert(folders.begin(), folder_.path() / "own");
  roots_ = AssetRoots(folders);
  EXPECT_EQ(rendered(all), (std::vector<int>{0, 12, 24}));
}

TEST_F(FramesTest, APngTellsWhatItWasMadeFromToo) {
  const Sequence all = sequence("f.png");
  EXPECT_EQ(rendered(all).size(), 3U);
  EXPECT_TRUE(std::filesystem::exists(folder_.file("f.0012.png")));
  EXPECT_EQ(rendered(all), std::vector<int>());
}

TEST(Film, ShowsEveryFrameOnceInItsColours) {
  const char* ffmpeg = "/usr/bin/ffmpeg";
  if (!std::filesystem::exists(ffmpeg)) GTEST_SKIP() << "ffmpeg is not installed (tools/packages test)";
  const TemporaryFolder folder;
  std::vector<std::string> frames;
  for (int i = 0; i < 3; ++i) {
    Image picture(33, 25, 3);  // odd: a film has even sides
    for (std::size_t pixel = 0; pixel < picture.pixels(); ++pixel)
      picture.data[3 * pixel + static_cast<std::size_t>(i)] = 1.0F;
    frames.push_back(folder.file(fmt::format("f.{}.exr", i)));
    LUM_EXPECT_OK(write_image(frames.back(), picture));
  }
  LUM_EXPECT_OK(make_film(frames, 24.0, folder.file("film.mp4")));
  std::string bytes;
  ProcessRequest request;
  request.arguments = {ffmpeg, "-loglevel", "error",    "-i",    folder.file("film.mp4"),
                       "-f",   "rawvideo",  "-pix_fmt", "rgb24", "-"};
  request.on_output = [&](std::string_view piece) { bytes += piece; };
  LUM_ASSERT_OK(const ProcessEnd end, run_process(request));
  EXPECT_TRUE(end.ok()) << end.description();
  constexpr std::size_t kFrame = 32 * 24 * 3;
  ASSERT_EQ(bytes.size(), 3 * kFrame);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto* middle = reinterpret_cast<const unsigned char*>(bytes.data()) + i * kFrame + kFrame / 2 + 48;
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(middle[c] > 128, c == i) << "frame " << i;  // full colours survive 4:2:0 where there are no edges
    }
  }
  std::filesystem::remove(frames[1]);
  EXPECT_FALSE(make_film(frames, 24.0, folder.file("other.mp4")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("other.mp4")));
}

TEST(FrameRange, IsWrittenAsFirstLastAndStep) {
  LUM_ASSERT_OK(const FrameRange range, FrameRange::parse("3-9x3"));
  EXPECT_EQ(range.frames(), (std::vector<int>{3, 6, 9}));
  LUM_ASSERT_OK(const FrameRange one, FrameRange::parse("-2"));
  EXPECT_EQ(one.frames(), std::vector<int>{-2});
  for (const char* wrong : {"", "a", "3-", "9-3", "1-2x0", "1-2x-1", "1-2y", "0-99999999"}) {
    EXPECT_FALSE(FrameRange::parse(wrong)) << wrong;
  }
}

TEST(FramePath, HasTheNumberForTheSignsOrBeforeTheEnding) {
  EXPECT_EQ(frame_path("a/b.####.exr", 12), "a/b.0012.exr");
  EXPECT_EQ(frame_path("a#/b#.png", 123), "a#/b123.png");
  EXPECT_EQ(frame_path("a/b.png", 7), "a/b.0007.png");
}

}  // namespace
}  // namespace luminist
