#include "rig/light_rig.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <locale>
#include <random>

#include "base/files.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

class LightRigTest : public ::testing::Test {
 protected:
  LightRigTest() {
    auto types = LightTypes::load(AssetRoots::standard());
    EXPECT_TRUE(types) << (types ? "" : types.error().message());
    types_ = *types;
  }
  Light light(const std::string& type, const std::string& name) const {
    return *make_light(types_, type, name, frame_);
  }
  Result<LightRig> parse(const std::string& toml) const { return parse_rig(toml, "a.toml", types_, frame_); }

  LightTypes types_;
  SceneFrame frame_{Vec3(1.0F, 2.0F, 3.0F), 2.0F};
};

TEST_F(LightRigTest, StartsWithAmbientLightAlone) {
  const LightRig rig = empty_rig(types_, frame_);
  EXPECT_TRUE(rig.lights.empty());
  EXPECT_GT(rig.ambient.vec3(0).x, 0.0F);
  EXPECT_EQ(rig.find("key"), nullptr);
}

TEST_F(LightRigTest, MakesLightsInTheFrameOfTheScene) {
  const Light key = light("cinematic", "key");
  EXPECT_EQ(key.type, "cinematic");
  EXPECT_FALSE(key.muted);
  const int position = *key.params.schema().by_role("position");
  EXPECT_EQ(key.params.vec3(position), Vec3(1.0F + 2.0F * 0.8F, 2.0F + 2.0F * 1.2F, 3.0F + 2.0F * 1.2F));
}

TEST_F(LightRigTest, RefusesUnknownTypesAndBadNames) {
  EXPECT_EQ(error_of(make_light(types_, "cinematc", "key", frame_)).hint, "did you mean \"cinematic\"?");
  for (const char* name : {"", "a/b", "a*", "a=b", "a:b", "a\nb"}) {
    EXPECT_EQ(error_of(make_light(types_, "point", name, frame_)).field, "name") << name;
  }
  EXPECT_EQ(error_of(make_light(types_, "point", std::string(256, 'a'), frame_)).field, "name");
  LUM_EXPECT_OK(make_light(types_, "point", "Schlüssel \"1\" #x", frame_));
}

TEST_F(LightRigTest, CountsUpToAnUnusedName) {
  LightRig rig = empty_rig(types_, frame_);
  EXPECT_EQ(rig.unused_name("key"), "key");
  rig.lights.push_back(light("point", "key"));
  EXPECT_EQ(rig.unused_name("key"), "key-2");
  rig.lights.push_back(light("point", "key-2"));
  EXPECT_EQ(rig.unused_name("key"), "key-3");
  EXPECT_EQ(rig.find("key-2"), &rig.lights[1]);
}

TEST_F(LightRigTest, IsReadFromAFileWrittenByHand) {
  LUM_ASSERT_OK(const LightRig rig, parse(R"(
shadow_light = "key"

[ambient]
color = [0.1, 0.2, 0.3]

[[light]]
name = "key"
type = "cinematic"
group = "main"
position = [1, 2.5, -3]
direction = [0, -3, 4]
barn = [0.5, 0.4, 0.05]
unlocked = ["color", "position.y"]

[[light]]
name = "fill"
type = "point"
muted = true
)"));
  EXPECT_EQ(rig.shadow_light, "key");
  EXPECT_EQ(rig.ambient.vec3(0), Vec3(0.1F, 0.2F, 0.3F));
  ASSERT_EQ(rig.lights.size(), 2U);
  const Light& key = rig.lights[0];
  EXPECT_EQ(key.group, "main");
  EXPECT_EQ(key.params.vec3(*key.params.schema().find("position")), Vec3(1.0F, 2.5F, -3.0F));  // world, not scene radii
  EXPECT_EQ(key.params.vec3(*key.params.schema().find("direction")), Vec3(0.0F, -0.6F, 0.8F));
  int unlocked = 0;
  for (int dof = 0; dof < key.params.schema().dofs(); ++dof) unlocked += key.params.locked(dof) ? 0 : 1;
  EXPECT_EQ(unlocked, 4);
  EXPECT_TRUE(rig.lights[1].muted);
  EXPECT_TRUE(rig.lights[1].params.same_values(light("point", "fill").params));
}

TEST_F(LightRigTest, ReportsMistakesAtTheirPlace) {
  const std::string key = "[[light]]\nname = \"key\"\ntype = \"cinematic\"\n";  // 3 lines
  const std::array<std::array<std::string, 3>, 17> mistakes = {{
      {"shdow_light = \"key\"\n", "a.toml:1:1", "did you mean \"shadow_light\""},
      {"shadow_light = \"kay\"\n" + key, "a.toml:1:16", "did you mean \"key\""},
      {"[ambient]\ncolour = [1, 1, 1]\n", "a.toml:2:1", "did you mean \"color\""},
      {"[ambient]\ncolor = [1, 1]\n", "a.toml:2:9", "give 3 linear numbers"},
      {"[[light]]\nname = \"key\"\n", "a.toml:1:1", "\"type\" is missing"},
      {"[[light]]\ntype = \"point\"\n", "a.toml:1:1", "\"name\" is missing"},
      {"[[light]]\nname = \"a/b\"\ntype = \"point\"\n", "a.toml:2:8", "no name for a light"},
      {"[[light]]\nname = \"a\"\ntype = \"pont\"\n", "a.toml:3:8", "did you mean \"point\""},
      {key + key, "a.toml:5:8", "two lights are named \"key\""},
      {key + "posision = [0, 0, 0]\n", "a.toml:4:1", "did you mean \"position\""},
      {key + "position = [0, nan, 0]\n", "a.toml:4:12", "give 3 numbers"},
      {key + "direction = [0, 0, 0]\n", "a.toml:4:13", "not all 0"},
      {key + "muted = 1\n", "a.toml:4:9", "true or false is wanted"},
      {key + "group = \"a*\"\n", "a.toml:4:9", "no name for a group"},
      {key + "unlocked = [\"colr\"]\n", "a.toml:4:13", "did you mean \"color\""},
      {key + "unlocked = [\"shadow_softness\"]\n", "a.toml:4:13", "no degree of freedom"},
      {"light = 1\n", "a.toml:1:9", "an array is wanted"},
  }};
  for (const auto& [toml, where, says] : mistakes) {
    const Error error = error_of(parse(toml));
    EXPECT_EQ(error.kind, ErrorKind::kBadContent) << toml;
    EXPECT_EQ(error.where, where) << error.message();
    EXPECT_NE(error.message().find(says), std::string::npos) << error.message();
  }
}

TEST_F(LightRigTest, IsMissedWhereThereIsNoFile) {
  EXPECT_EQ(error_of(load_rig("/nowhere/rig.toml", types_, frame_)).kind, ErrorKind::kMissing);
}

/// A float of any exponent, finite.
double any_float(std::mt19937& random) {
  while (true) {
    const std::uint32_t bits = random();
    float value = 0.0F;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) return static_cast<double>(value);
  }
}

/// A rig whose every number, lock and switch is random.
LightRig random_rig(const LightTypes& types, const SceneFrame& frame, std::mt19937& random) {
  LightRig rig = empty_rig(types, frame);
  for (int i = 0; i < 5; ++i) {
    const LightType& type = types.all()[random() % types.all().size()];
    Light light = *make_light(types, type.name, "light \"" + std::to_string(i) + "\" \\ é", frame);
    light.group = i % 2 == 0 ? "even" : "";
    light.muted = random() % 2 == 0;
    if (i == 1) light.objects = {"creature*", "a \"quoted\" \\ name"};
    for (int p = 0; p < type.schema->size(); ++p) {
      const ParamSpec& spec = (*type.schema)[p];
      if (spec.type == ParamType::kDirection) {
        std::normal_distribution<float> gauss;
        light.params.set_vec3(p, glm::normalize(Vec3(gauss(random), gauss(random), gauss(random))));
        continue;
      }
      for (int c = 0; c < spec.components(); ++c) light.params.set(p, c, any_float(random));
    }
    for (int dof = 0; dof < type.schema->dofs(); ++dof) light.params.set_locked(dof, random() % 2 == 0);
    rig.lights.push_back(std::move(light));
  }
  rig.shadow_light = rig.lights[random() % rig.lights.size()].name;
  rig.ambient.set(0, 0, any_float(random));
  return rig;
}

void expect_same(const LightRig& a, const LightRig& b) {
  EXPECT_EQ(a.shadow_light, b.shadow_light);
  EXPECT_TRUE(a.ambient.same_values(b.ambient));
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    EXPECT_EQ(a.lights[i].name, b.lights[i].name);
    EXPECT_EQ(a.lights[i].type, b.lights[i].type);
    EXPECT_EQ(a.lights[i].group, b.lights[i].group);
    EXPECT_EQ(a.lights[i].muted, b.lights[i].muted);
    EXPECT_EQ(a.lights[i].objects, b.lights[i].objects);
    EXPECT_TRUE(a.lights[i].params.same_values(b.lights[i].params)) << rig_to_toml(a);
    for (int dof = 0; dof < a.lights[i].params.schema().dofs(); ++dof) {
      EXPECT_EQ(a.lights[i].params.locked(dof), b.lights[i].params.locked(dof));
    }
  }
}

TEST_F(LightRigTest, IsReadBackFromItsFileToTheSameBits) {
  const TemporaryFolder folder;
  std::mt19937 random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const LightRig rig = random_rig(types_, frame_, random);
    LUM_EXPECT_OK(save_rig(rig, folder.file("rig.toml")));
    LUM_ASSERT_OK(const LightRig back, load_rig(folder.file("rig.toml"), types_, frame_));
    expect_same(rig, back);
  }
}

/// Numbers as in Germany: a comma before the decimals, a point between thousands.
class CommaNumbers : public std::numpunct<char> {
 protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_F(LightRigTest, IsTheSameFileInALocaleWithCommas) {
  std::mt19937 random(2);
  const LightRig rig = random_rig(types_, frame_, random);
  const std::string plain = rig_to_toml(rig);
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaNumbers));
  const std::string c_before = std::setlocale(LC_ALL, nullptr);
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // fails where the locale is not installed; the C++ locale stands
  EXPECT_EQ(rig_to_toml(rig), plain);
  LUM_ASSERT_OK(const LightRig back, parse(plain));
  expect_same(rig, back);
  std::setlocale(LC_ALL, c_before.c_str());
  std::locale::global(before);
}

TEST_F(LightRigTest, WritesAFileThatAHandCanEdit) {
  LightRig rig = empty_rig(types_, frame_);
  rig.lights.push_back(light("point", "fill"));
  rig.lights[0].group = "soft";
  const std::string toml = rig_to_toml(rig);
  EXPECT_EQ(toml.find("shadow_light"), std::string::npos);
  EXPECT_NE(toml.find("[ambient]\ncolor = [0.06, 0.06, 0.07]\n"), std::string::npos) << toml;
  EXPECT_NE(toml.find("[[light]]\nname = \"fill\"\ntype = \"point\"\ngroup = \"soft\"\nposition = [2.6, 4.4, 5.4]\n"),
            std::string::npos)
      << toml;
  EXPECT_EQ(toml.find("unlocked"), std::string::npos);  // as the schema has it
  EXPECT_EQ(toml.find("muted"), std::string::npos);
}

TEST_F(LightRigTest, IsNotSavedWithANumberThatCannotBeRead) {
  const TemporaryFolder folder;
  LightRig rig = empty_rig(types_, frame_);
  rig.lights.push_back(light("point", "fill"));
  rig.lights[0].params.set(1, 2, std::numeric_limits<double>::quiet_NaN());
  const Error error = error_of(save_rig(rig, folder.file("rig.toml")));
  EXPECT_EQ(error.kind, ErrorKind::kNumerical);
  EXPECT_EQ(error.field, "color");
  EXPECT_FALSE(std::filesystem::exists(folder.file("rig.toml")));
  rig.lights.clear();
  EXPECT_EQ(error_of(save_rig(rig, folder.file("nowhere/rig.toml"))).kind, ErrorKind::kUnwritable);
}

TEST_F(LightRigTest, SurvivesEveryPrefixOfARigFile) {
  LightRig rig = empty_rig(types_, frame_);
  rig.lights.push_back(light("cinematic", "key"));
  const std::string toml = rig_to_toml(rig);
  for (std::size_t length = 0; length < toml.size(); ++length) {
    const auto prefix = parse(toml.substr(0, length));
    if (!prefix) {
      EXPECT_EQ(prefix.error().kind, ErrorKind::kBadContent);
    }
  }
}

}  // namespace
}  // namespace luminist
