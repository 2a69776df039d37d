#include "style/style.h"

#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace luminist {
namespace {

TEST(ShippedStyles, AreValid) {
  const AssetRoots roots = AssetRoots::standard();
  const std::vector<std::string> names = style_names(roots);
  for (const char* expected : {"cinematic", "toon"}) {
    EXPECT_NE(std::find(names.begin(), names.end(), expected), names.end()) << expected;
  }
  for (const std::string& name : names) {
    const auto style = load_style(roots, name);
    ASSERT_TRUE(style) << style.error().message();
    EXPECT_EQ(style->name, name);
    EXPECT_FALSE(style->doc.empty());
    if (style->engine == StyleEngine::kPath) continue;
    EXPECT_TRUE(std::filesystem::is_regular_file(style->shades() ? style->glsl_path : style->ink_path));
  }
}

TEST(ShippedStyles, GiveToonAThresholdAndTwoColours) {
  LUM_ASSERT_OK(const Style toon, load_style(AssetRoots::standard(), "toon"));
  for (const char* name : {"threshold", "feather", "bright", "dark"}) {
    EXPECT_TRUE(toon.schema->find(name).has_value()) << name;
  }
  ParamBlock params(toon.schema, SceneFrame{});
  EXPECT_EQ(toon.combination(params), LightCombination::kSum);
  params.set(*toon.schema->find("combine"), 0, 1.0);  // the strongest wins
  EXPECT_EQ(toon.combination(params), LightCombination::kJoint);
  params.set(*toon.schema->find("combine"), 0, 2.0);  // one key an object
  EXPECT_EQ(toon.combination(params), LightCombination::kSum);
  // Picture and colours are linear in each other, which the solver may use.
  EXPECT_EQ((*toon.schema)[*toon.schema->find("bright")].role, "color");
  EXPECT_EQ((*toon.schema)[*toon.schema->find("dark")].role, "color");
}

/// A folder of styles of the test's own.
class StyleFiles : public ::testing::Test {
 protected:
  StyleFiles() { add("plain", kGood, "plain.glsl"); }
  void add(const std::string& name, const std::string& manifest, const std::string& glsl) {
    LUM_EXPECT_OK(make_folder(folder_.path() / "styles" / name));
    LUM_EXPECT_OK(write_file_atomic(folder_.path() / "styles" / name / "style.toml", manifest));
    LUM_EXPECT_OK(write_file_atomic(folder_.path() / "styles" / name / glsl, "vec3 shade(Surface s) {}"));
  }
  Result<Style> load(const std::string& name) const { return load_style(AssetRoots({folder_.path()}), name); }

  static constexpr const char* kGood = "doc = \"p\"\nshade = \"plain.glsl\"\n";
  TemporaryFolder folder_;
};

TEST_F(StyleFiles, ChooseTheEngineAndAPathTracedOneNeedsNoGlsl) {
  add("light", "doc = \"d\"\nengine = \"path\"\n", "unused.glsl");
  add("odd", "doc = \"d\"\nengine = \"oven\"\nshade = \"plain.glsl\"\n", "plain.glsl");
  add("both", "doc = \"d\"\nengine = \"path\"\nshade = \"plain.glsl\"\n", "plain.glsl");
  LUM_ASSERT_OK(const Style style, load("light"));
  EXPECT_EQ(style.engine, StyleEngine::kPath);
  EXPECT_TRUE(style.shades());
  LUM_ASSERT_OK(const Style plain, load("plain"));
  EXPECT_EQ(plain.engine, StyleEngine::kRaster);
  EXPECT_NE(error_of(load("odd")).what.find("oven"), std::string::npos);
  EXPECT_NE(error_of(load("both")).message().find("shade"), std::string::npos) << "it would not be read";
}

TEST_F(StyleFiles, PromiseNothingUnlessTheySaySo) {
  LUM_ASSERT_OK(const Style style, load("plain"));
  EXPECT_EQ(style.lights, LightCombination::kJoint);
  EXPECT_EQ(style.metric.blur, 0.0F);
  EXPECT_EQ(style.schema->size(), 0);
  EXPECT_TRUE(style.golden.empty());
  EXPECT_EQ(style.folder, (folder_.path() / "styles/plain").string());
}

TEST_F(StyleFiles, AreReadWhole) {
  add("full", R"(
doc = "f"
shade = "full.glsl"
lights = "sum"
[metric]
blur = 0.02
[[param]]
name = "width"
type = "float"
default = 0.5
range = [0, 1]
doc = "d"
[[golden]]
name = "still"
scene = "meshes/still_life.glb"
rig = "meshes/still_life.toml"
camera = "front"
width = 320
height = 180
set = ["style/width=0.25", "ambient/color=0,0,0"]
max_difference = 0.05
mean_difference = 0.002
reason = "edges of shadows"
[golden_gpu]
max_difference = 0.5
mean_difference = 0.004
reason = "textures"
)",
      "full.glsl");
  LUM_ASSERT_OK(const Style style, load("full"));
  EXPECT_EQ(style.lights, LightCombination::kSum);
  EXPECT_FLOAT_EQ(style.metric.blur, 0.02F);
  EXPECT_EQ(style.schema->names(), (std::vector<std::string>{"width"}));
  ASSERT_EQ(style.golden.size(), 1U);
  const GoldenCase& golden = style.golden[0];
  EXPECT_EQ(golden.name, "still");
  EXPECT_EQ(golden.scene, "meshes/still_life.glb");
  EXPECT_EQ(golden.rig, "meshes/still_life.toml");
  EXPECT_EQ(golden.camera, "front");
  EXPECT_EQ(golden.width, 320);
  EXPECT_EQ(golden.height, 180);
  EXPECT_EQ(golden.set, (std::vector<std::string>{"style/width=0.25", "ambient/color=0,0,0"}));
  EXPECT_EQ(golden.max_difference, 0.05);
  EXPECT_EQ(golden.mean_difference, 0.002);
  EXPECT_EQ(golden.reason, "edges of shadows");
  ASSERT_TRUE(style.golden_gpu);
  EXPECT_EQ(style.golden_gpu->max_difference, 0.5);
  EXPECT_EQ(style.golden_gpu->mean_difference, 0.004);
  EXPECT_EQ(style.golden_gpu->reason, "textures");
}

TEST_F(StyleFiles, ReportMistakesAtTheirPlace) {
  const std::string good = kGood;  // 2 lines
  const std::string golden =
      good + "[[golden]]\nname = \"a\"\nscene = \"s\"\nmax_difference = 0\nmean_difference = 0\nreason = \"r\"\n";
  const std::array<std::array<std::string, 3>, 26> mistakes = {{
      {"shade = \"plain.glsl\"\n", ":1:1", "\"doc\" is missing"},
      {"doc = \"p\"\n", ":1:1", "\"shade\" is missing"},
      {"doc = \"p\"\nshader = \"plain.glsl\"\n", ":2:1", "did you mean \"shade\""},
      {"doc = \"p\"\nshade = \"gone.glsl\"\n", ":2:9", "\"gone.glsl\", which is not there"},
      {"doc = \"p\"\nshade = \"../a.glsl\"\n", ":2:9", "leaves the file's folder"},
      {good + "lights = \"sums\"\n", ":3:10", "one of sum, joint"},
      {good + "[metric]\nblurr = 0\n", ":4:1", "did you mean \"blur\""},
      {good + "[metric]\nblur = -1\n", ":4:8", "outside 0 to 0.5"},
      {good + "[metric]\nblur = nan\n", ":4:8", "finite"},
      {good + "[[param]]\nname = \"a\"\n", ":3:1", "is missing"},
      {good + "[[golden]]\nname = \"a\"\nscene = \"s\"\n", ":3:1", "\"max_difference\" is missing"},
      {golden + "widht = 3\n", ":9:1", "did you mean \"width\""},
      {golden + "width = 0\n", ":9:9", "outside 1 to 4096"},
      {golden + "set = [3]\n", ":9:8", "a string is wanted here"},
      {golden + golden.substr(good.size()), ":10:8", "two golden cases"},
      {good + "[[golden]]\nname = \"a/b\"\nscene = \"s\"\nmax_difference = 0\nmean_difference = 0\nreason = \"r\"\n",
       ":4:8", "cannot name a picture"},
      {good + "[[golden]]\nname = \"a\"\nscene = \"s\"\nmax_difference = -1\nmean_difference = 0\nreason = \"r\"\n",
       ":6:18", "cannot be negative"},
      {good + "[[golden]]\nname = \"a\"\nscene = \"s\"\nmax_difference = 0\nmean_difference = 0\nreason = \"\"\n",
       ":8:10", "need a reason"},
      {"doc = \"p\"\nink = \"gone.glsl\"\n", ":2:7", "\"gone.glsl\", which is not there"},
      {good + "[[texture]]\nname = \"Grain\"\nfile = \"plain.glsl\"\n", ":4:8", "cannot name a texture"},
      {good + "[[texture]]\nname = \"float\"\nfile = \"plain.glsl\"\n", ":4:8", "cannot name a texture"},
      {good + "[[texture]]\nname = \"grain\"\nfile = \"gone.png\"\n", ":5:8", "which is not there"},
      {good + "[[texture]]\nname = \"grain\"\nfile = \"plain.glsl\"\nlevels = 13\n", ":6:10", "outside 0 to 12"},
      {golden + "style = \"toon\"\n", ":9:9", "seen by itself"},
      {good + "[golden_gpu]\nmax_difference = 1\nmean_difference = -1\nreason = \"r\"\n", ":5:19",
       "cannot be negative"},
      {good + "[golden_gpu]\nmax_difference = 1\nmean_difference = 1\nreason = \"\"\n", ":6:10", "need a reason"},
  }};
  const std::string path = (folder_.path() / "styles/plain/style.toml").string();
  for (const auto& [manifest, place, says] : mistakes) {
    LUM_EXPECT_OK(write_file_atomic(path, manifest));
    const Error error = error_of(load("plain"));
    EXPECT_EQ(error.kind, ErrorKind::kStyle) << manifest;
    EXPECT_EQ(error.where, path + place) << error.message();
    EXPECT_NE(error.message().find(says), std::string::npos) << error.message();
  }
}

TEST_F(StyleFiles, StackLinesOverAStyleThatShades) {
  LUM_EXPECT_OK(write_file_atomic((folder_.path() / "styles/plain/style.toml").string(), kGood));
  LUM_EXPECT_OK(make_folder(folder_.path() / "styles/lines"));
  LUM_EXPECT_OK(write_file_atomic((folder_.path() / "styles/lines/lines.glsl").string(), ""));
  const std::string manifest = (folder_.path() / "styles/lines/style.toml").string();
  const std::string lines =
      "doc = \"l\"\nink = \"lines.glsl\"\n[[param]]\nname = \"line_width\"\ntype = \"float\"\n"
      "default = 1.0\nrange = [0, 2]\ndoc = \"w\"\n";
  LUM_EXPECT_OK(write_file_atomic(manifest, lines));
  LUM_ASSERT_OK(const Style plain, load("plain"));
  LUM_ASSERT_OK(const Style both, load("plain+lines"));
  EXPECT_EQ(both.name, "plain+lines");
  EXPECT_EQ(both.glsl_path, plain.glsl_path);
  EXPECT_FALSE(both.ink_path.empty());
  EXPECT_EQ(both.schema->size(), plain.schema->size() + 1);
  LUM_ASSERT_OK(const Style alone, load("lines"));
  EXPECT_FALSE(alone.shades());
  EXPECT_EQ(error_of(load("lines+plain")).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(load("plain+plain")).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(load("plain+lin")).kind, ErrorKind::kMissing);
}

TEST_F(StyleFiles, AreNamedWhereOneIsMissed) {
  const Error error = error_of(load("plian"));
  EXPECT_EQ(error.kind, ErrorKind::kMissing);
  EXPECT_NE(error.hint.find("did you mean \"plain\""), std::string::npos);
  EXPECT_EQ(error_of(load("../styles/plain")).kind, ErrorKind::kMissing);
  EXPECT_EQ(error_of(load("")).kind, ErrorKind::kMissing);
}

TEST_F(StyleFiles, AreFoldersWithAManifest) {
  LUM_EXPECT_OK(make_folder(folder_.path() / "styles/draft"));
  add("another", "doc = \"a\"\nshade = \"a.glsl\"\n", "a.glsl");
  EXPECT_EQ(style_names(AssetRoots({folder_.path()})), (std::vector<std::string>{"another", "plain"}));
}

}  // namespace
}  // namespace luminist
