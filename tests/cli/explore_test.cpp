#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace luminist {
namespace {

class ExploreCliTest : public CliTest {
 protected:
  ExploreCliTest() {
    write("rig.toml",
          "[[light]]\nname = \"key\"\ntype = \"cinematic\"\nunlocked = [\"color\"]\n"
          "[[light]]\nname = \"fill\"\ntype = \"cinematic\"\ncolor = [0.1, 0.2, 0.3]\nunlocked = [\"color\"]\n"
          "[[light]]\nname = \"rim\"\ntype = \"cinematic\"\nposition = [-3, 3, -1]\ndirection = [0.8, -0.5, 0.3]\n"
          "unlocked = [\"color\"]\n");
  }
};

TEST_F(ExploreCliTest, RemovesALightAndSaysWhatItCost) {
  const Outcome outcome = luminist("remove ball.obj fill --size 64x48 --rig rig.toml --json -o out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.out;
  EXPECT_EQ(json["light"], "fill");
  EXPECT_EQ(json["lights"].size(), 2U);
  EXPECT_LT(json["epsilon"].get<double>(), 0.05 * json["epsilon_removed"].get<double>());
  EXPECT_TRUE(json["shadows_matter"].is_boolean());
  for (const char* name : {"rig.toml", "picture.exr", "residual.png", "contact_sheet.png", "report.json"}) {
    EXPECT_TRUE(exists(std::string("out/") + name)) << name;
  }
  EXPECT_EQ(read("out/rig.toml").find("fill"), std::string::npos);
  expect_error(luminist("remove ball.obj fil --size 64x48 --rig rig.toml -o out"), 2);
  write("one.toml", "[[light]]\nname = \"key\"\ntype = \"cinematic\"\n");
  expect_error(luminist("remove ball.obj key --size 64x48 --rig one.toml -o out"), 8);
}

TEST_F(ExploreCliTest, ListsTheFewestLightsWithinABudget) {
  const Outcome outcome = luminist("diet ball.obj --size 64x48 --rig rig.toml --budget 2% --json -o out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.out;
  ASSERT_EQ(json["sizes"].size(), 3U);
  EXPECT_EQ(json["chosen"], 1);  // key and fill stand at one place
  EXPECT_NEAR(json["budget"].get<double>(), 0.02 * json["black"].get<double>(), 1e-12);
  for (const auto& size : json["sizes"]) EXPECT_TRUE(exists("out/" + size["rig"].get<std::string>()));
  EXPECT_TRUE(exists("out/contact_sheet.png"));
  const Outcome lines = luminist("diet ball.obj --size 64x48 --rig rig.toml --budget 0 -o out");
  EXPECT_NE(lines.out.find("3 lights, the fewest within the budget"), std::string::npos) << lines.out;
  expect_error(luminist("diet ball.obj --size 64x48 --rig rig.toml --budget much -o out"), 2);
  expect_error(luminist("diet ball.obj --size 64x48 -o out"), 8);
}

TEST_F(ExploreCliTest, OffersDifferentLightsForOnePainting) {
  const std::string words = "alternatives ball.obj --size 64x48 --paint light.json --add-light 1 --tries 4 ";
  const Outcome outcome = luminist(words + "--count 2 --within 3 --json -o out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.out;
  ASSERT_GE(json["alternatives"].size(), 1U);
  for (const auto& each : json["alternatives"]) {
    EXPECT_LE(each["epsilon"].get<double>(), json["limit"].get<double>());
    EXPECT_TRUE(exists("out/" + each["rig"].get<std::string>()));
  }
  EXPECT_TRUE(exists("out/contact_sheet.png"));
  EXPECT_TRUE(exists("out/report.json"));
  expect_error(luminist("alternatives ball.obj --size 64x48 -o out"), 2);
}

}  // namespace
}  // namespace luminist
