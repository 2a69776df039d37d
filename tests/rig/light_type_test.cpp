#include "rig/light_type.h"

#include <gtest/gtest.h>

#include <map>

#include "support/fixtures.h"

namespace luminist {
namespace {

LightTypes shipped() {
  auto types = LightTypes::load(AssetRoots::standard());
  EXPECT_TRUE(types) << (types ? "" : types.error().message());
  return *types;
}

TEST(CinematicLight, HasExactlyTheEighteenDegreesOfFreedomOfThePaper) {
  const LightTypes types = shipped();
  const LightType* cinematic = types.find("cinematic");
  ASSERT_NE(cinematic, nullptr);
  EXPECT_EQ(cinematic->schema->dofs(), 18);
  std::map<std::string, int> by_role;
  for (const ParamSpec& spec : cinematic->schema->specs()) by_role[spec.role] += spec.dofs();
  EXPECT_EQ(by_role["position"], 3);
  EXPECT_EQ(by_role["direction"], 2);
  EXPECT_EQ(by_role["color"], 3);
  EXPECT_EQ(by_role["cutoff"], 4);
  EXPECT_EQ(by_role["falloff"] + by_role["falloff_distance"], 2);
  EXPECT_EQ(by_role["shape"], 3);
  EXPECT_EQ(by_role["shadow"], 1);
  EXPECT_EQ(by_role["size"], 0);  // the shadow's softness is a quality
}

TEST(LightTypes, AreTheManifestsInShadersLight) {
  const LightTypes types = shipped();
  EXPECT_NE(types.find("point"), nullptr);
  EXPECT_EQ(types.find("ambient"), nullptr);
  EXPECT_EQ(types.find("point")->shadow, ShadowKind::kCube);
  EXPECT_EQ(types.find("cinematic")->shadow, ShadowKind::kSpot);
  EXPECT_EQ(types.index("nothing"), -1);
  const std::vector<std::string> names = types.names();
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(types.index(names[i]), static_cast<int>(i));
  ASSERT_NE(types.ambient(), nullptr);
  EXPECT_TRUE(types.ambient()->by_role("color").has_value());
}

TEST(LightTypes, NameTheirStructInCamelCase) {
  LightType type;
  type.name = "cinematic";
  EXPECT_EQ(type.struct_name(), "Cinematic");
  type.name = "area_disk2";
  EXPECT_EQ(type.struct_name(), "AreaDisk2");
}

/// A folder of light types of the test's own.
class LightTypeFiles : public ::testing::Test {
 protected:
  LightTypeFiles() {
    LUM_EXPECT_OK(make_folder(folder_.path() / "shaders/light"));
    write("ambient.toml", "doc = \"a\"\n" + param("color", "color", "[0, 0, 0]"));
    write("lamp.toml", "doc = \"l\"\nshadow = \"none\"\n" + param("power", "float", "1"));
    write("lamp.glsl", "");
  }
  static std::string param(const std::string& name, const std::string& type, const std::string& value) {
    return "[[param]]\nname = \"" + name + "\"\ntype = \"" + type + "\"\ndefault = " + value +
           "\nrange = [0, 4]\ndoc = \"d\"\n";
  }
  void write(const std::string& name, const std::string& text) {
    LUM_EXPECT_OK(write_file_atomic(folder_.path() / "shaders/light" / name, text));
  }
  Result<LightTypes> load() const { return LightTypes::load(AssetRoots({folder_.path()})); }
  Error error() const { return error_of(load()); }

  TemporaryFolder folder_;
};

TEST_F(LightTypeFiles, AddATypeWithoutAnyCpp) {
  LUM_ASSERT_OK(const LightTypes types, load());
  ASSERT_EQ(types.names(), (std::vector<std::string>{"lamp"}));
  EXPECT_EQ(types.all()[0].doc, "l");
  EXPECT_EQ(types.all()[0].schema->names(), (std::vector<std::string>{"power"}));
  EXPECT_NE(types.all()[0].glsl_path.find("shaders/light/lamp.glsl"), std::string::npos);
}

TEST_F(LightTypeFiles, ReportMistakesAtTheirPlace) {
  const std::string path = (folder_.path() / "shaders/light/lamp.toml").string();
  const auto expect = [&](const std::string& manifest, const std::string& place, const std::string& says) {
    write("lamp.toml", manifest);
    const Error found = error();
    EXPECT_EQ(found.kind, ErrorKind::kStyle) << manifest;
    EXPECT_EQ(found.where, path + place) << found.message();
    EXPECT_NE(found.message().find(says), std::string::npos) << found.message();
  };
  expect("doc = \"l\"\n", ":1:1", "\"shadow\" is missing");
  expect("doc = \"l\"\nshadow = \"sphere\"\n", ":2:10", "one of none, spot, cube");
  expect("doc = \"l\"\nshadw = \"spot\"\n", ":2:1", "did you mean \"shadow\"");
  expect("doc = 1\nshadow = \"spot\"\n", ":1:7", "a string is wanted here");
  expect("doc = \"l\"\nshadow = \"spot\"\n" + param("power", "float", "9"), ":6:11", "outside the range");
  expect("doc = \"l\"\nshadow = \"spot\"\n" + param("group", "float", "1"), ":3:1", "rig files use this name");
}

TEST_F(LightTypeFiles, NeedTheirGlslAndAUsableName) {
  write("spare.toml", "doc = \"l\"\nshadow = \"none\"\n");
  EXPECT_EQ(error().kind, ErrorKind::kMissing);
  write("spare.glsl", "");
  LUM_EXPECT_OK(load());
  write("My-Lamp.toml", "doc = \"l\"\nshadow = \"none\"\n");
  EXPECT_EQ(error().kind, ErrorKind::kStyle);
}

TEST_F(LightTypeFiles, AreMissedWhereThereAreNone) {
  EXPECT_EQ(error_of(LightTypes::load(AssetRoots({folder_.path() / "shaders"}))).kind, ErrorKind::kMissing);
  std::filesystem::remove(folder_.path() / "shaders/light/ambient.toml");
  EXPECT_NE(error().what.find("ambient.toml"), std::string::npos);
}

}  // namespace
}  // namespace luminist
