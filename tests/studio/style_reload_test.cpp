#include "studio/style_reload.h"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <string>

#include "render/param_state.h"
#include "studio/session.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

class StyleReloadTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_.path() / "styles/mine");
    manifest("0.25");
    glsl("s.albedo * style.gain");
    std::vector<std::filesystem::path> roots = AssetRoots::standard().folders();
    roots.insert(roots.begin(), folder_.path());
    roots_.emplace(roots);
    std::ofstream(folder_.file("tri.obj")) << "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
    LUM_ASSERT_OK(device_, Device::create_headless());
    Shot shot;
    shot.scene = folder_.file("tri.obj");
    shot.style = "mine";
    shot.width = shot.height = 16;
    LUM_ASSERT_OK(stage_, open_stage(*device_, *roots_, shot, folder_.path(), diagnostics_));
    state_.emplace(initial_state(stage_->types, stage_->style, stage_->frame));
  }
  void manifest(const std::string& gain, const std::string& more = "") const {
    std::ofstream(folder_.path() / "styles/mine/style.toml")
        << "doc = \"m\"\nshade = \"mine.glsl\"\n"
        << more << "[[param]]\nname = \"gain\"\ntype = \"float\"\ndefault = " << gain
        << "\nrange = [0, 2]\ndoc = \"g\"\n[[param]]\nname = \"tint\"\ntype = \"color\"\ndefault = [1, 1, 1]\n"
        << "range = [0, 1]\ndoc = \"t\"\n";
  }
  void glsl(const std::string& value) const {
    std::ofstream(folder_.path() / "styles/mine/mine.glsl")
        << "vec3 shade(Surface s) {\n  return " << value << ";\n}\n";
  }
  float middle() { return stage_->renderer->render(*state_).value().rgb(8 * 16 + 8).g; }

  TemporaryFolder folder_;
  std::optional<AssetRoots> roots_;
  std::optional<Device> device_;
  Diagnostics diagnostics_;
  std::unique_ptr<Stage> stage_;
  std::optional<ParamState> state_;
};

TEST_F(StyleReloadTest, ANewVersionIsDrawnInPlaceWithTheValuesThatWereSet) {
  LUM_EXPECT_OK(set_path(*state_, "style/tint=0.5,0.25,0.5"));
  const float before = middle();
  manifest("0.5");
  glsl("s.albedo * style.gain * style.tint");
  LUM_ASSERT_OK(state_, reload_style(*stage_, *roots_, *state_));
  EXPECT_NEAR(middle(), before * 2.0F * 0.25F, 1e-5F) << "the new default of gain, the tint that was set";
}

TEST_F(StyleReloadTest, TheLastGoodVersionStaysWhereTheNewOneHasAMistake) {
  const float before = middle();
  glsl("s.albdo");
  const Error error = error_of(reload_style(*stage_, *roots_, *state_));
  EXPECT_EQ(error.kind, ErrorKind::kStyle);
  EXPECT_NE(error.where.find("mine.glsl:2"), std::string::npos) << error.message();
  EXPECT_EQ(middle(), before);
  manifest("0.25", "lihgts = \"sum\"\n");
  EXPECT_NE(error_of(reload_style(*stage_, *roots_, *state_)).where.find("style.toml:3"), std::string::npos);
  EXPECT_EQ(middle(), before);
  manifest("0.25", "strokes = true\n");
  glsl("s.albedo");
  EXPECT_EQ(error_of(reload_style(*stage_, *roots_, *state_)).kind, ErrorKind::kUsage);
  EXPECT_EQ(middle(), before);
}

TEST_F(StyleReloadTest, ASessionOpensAnotherStageForAVersionThatNeedsOne) {
  Shot shot;
  shot.scene = folder_.file("tri.obj");
  shot.style = "mine";
  shot.width = shot.height = 16;
  LUM_ASSERT_OK(const auto session, Session::open(*device_, *roots_, shot, folder_.path(), diagnostics_));
  LUM_EXPECT_OK(session->set({"style/tint=0.5,0.25,0.5"}));
  const std::uint64_t stage = session->stage().id;
  manifest("0.25", "strokes = true\n");
  glsl("vec3(s.stroke.z > 0.0 ? 0.75 : 0.25)");
  LUM_EXPECT_OK(session->reload_style());
  EXPECT_NE(session->stage().id, stage);
  const ParamBlock& style = session->state().style;
  EXPECT_EQ(style.get(*style.schema().find("tint"), 1), 0.25);
  LUM_ASSERT_OK(const Image* picture, session->picture());
  EXPECT_EQ(picture->rgb(8 * 16 + 8).g, 0.75F) << "strokes have a density, so the mesh is unwrapped";
  manifest("0.25", "strokes = true\nlihgts = 1\n");
  EXPECT_EQ(error_of(session->reload_style()).kind, ErrorKind::kStyle);
  LUM_ASSERT_OK(picture, session->picture());
  EXPECT_EQ(picture->rgb(8 * 16 + 8).g, 0.75F);
}

TEST_F(StyleReloadTest, FilesAreSeenToChangeOnce) {
  StyleFiles files(stage_->style);
  EXPECT_FALSE(files.changed());
  std::ofstream(folder_.path() / "styles/mine/more.glsl") << "\n";
  EXPECT_TRUE(files.changed());
  EXPECT_FALSE(files.changed());
}

}  // namespace
}  // namespace luminist
