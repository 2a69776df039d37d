#include <limits>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "image_io/image_io.h"

namespace luminist {
namespace {

constexpr const char* kSolve = "solve ball.obj --size 64x48 --paint light.json --add-light 1 --evals 60 ";

TEST_F(CliTest, SolvesAndWritesEveryFile) {
  const Outcome outcome = luminist(std::string(kSolve) + "--json -o out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* name : {"picture.exr", "picture.png", "target.exr", "target.png", "importance.exr", "importance.png",
                           "residual.exr", "residual.png", "rig.toml", "convergence.jsonl", "convergence.png"}) {
    EXPECT_TRUE(exists(std::string("out/") + name)) << name;
  }
  const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.out;
  for (const char* field :
       {"epsilon_start", "epsilon", "evals", "render_equivalents", "seconds", "solver", "lights", "termination"}) {
    EXPECT_TRUE(json.contains(field)) << field;
  }
  EXPECT_LT(json["epsilon"].get<double>(), json["epsilon_start"].get<double>());
  ASSERT_EQ(json["lights"].size(), 1U);
  EXPECT_EQ(json["lights"][0]["params"]["color"].size(), 3U);
  // The rig that was found makes the picture that was written.
  ASSERT_EQ(luminist("render ball.obj --size 64x48 --rig out/rig.toml -o again.exr").status, 0);
  LUM_ASSERT_OK(const Image picture, read_image(folder_.file("out/picture.exr")));
  LUM_ASSERT_OK(const Image again, read_image(folder_.file("again.exr")));
  EXPECT_EQ(picture.data, again.data);
}

TEST_F(CliTest, SeveralNewLightsAreSolvedTogetherAndOldOnesStay) {
  const Outcome outcome =
      luminist("solve ball.obj --size 64x48 --rig rig.toml --paint light.json --add-light 2 --evals 20 --json -o out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.out;
  ASSERT_EQ(json["lights"].size(), 3U);
  EXPECT_EQ(json["lights"][0]["unlocked"].size(), 0U);
  EXPECT_GT(json["lights"][1]["unlocked"].size(), 0U);
  EXPECT_GT(json["lights"][2]["unlocked"].size(), 0U);
}

TEST_F(CliTest, SolvesTheSamePaintInSeveralStylesEachForItself) {
  const std::string styles = std::string(kSolve) + "--style toon,gooch --unlock style/warm --unlock style/bright ";
  const Outcome outcome = luminist(styles + "--json -o out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.out;
  for (const char* style : {"toon", "gooch"}) {
    EXPECT_TRUE(exists(std::string("out/") + style + "/rig.toml")) << style;
    EXPECT_TRUE(exists(std::string("out/") + style + "/picture.exr")) << style;
    const auto& one = json["styles"][style];
    EXPECT_LT(one["epsilon"].get<double>(), one["epsilon_start"].get<double>()) << style;
  }
  EXPECT_NE(read("out/toon/rig.toml"), read("out/gooch/rig.toml"));
  // Each is what the style alone comes to.
  ASSERT_EQ(luminist(std::string(kSolve) + "--style gooch --unlock style/warm -o alone").status, 0);
  EXPECT_EQ(read("out/gooch/rig.toml"), read("alone/rig.toml"));
}

TEST_F(CliTest, EveryViewIsPaintedUnderTheLightsAsTheyAreLinked) {
  const std::string words = "solve ball.obj --size 64x48 --rig rig.toml --unlock lights/key/color --evals 20 ";
  const Outcome outcome = luminist(words + "--link 'key=fl*' --view paint=light.json --view paint=light.json -o out");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  ASSERT_EQ(luminist(words + "--paint light.json -o all").status, 0);
  LUM_ASSERT_OK(const Image first, read_image(folder_.file("out/view_1/target.exr")));
  LUM_ASSERT_OK(const Image second, read_image(folder_.file("out/view_2/target.exr")));
  LUM_ASSERT_OK(const Image all, read_image(folder_.file("all/target.exr")));
  EXPECT_EQ(first.data, second.data);
  EXPECT_NE(first.data, all.data);  // the ball is dark where it is not painted
}

TEST_F(CliTest, SolvesForOneRigInSeveralStylesTogether) {
  const std::string styles = std::string(kSolve) + "--style toon,halftone --unlock style/bright --unlock style/paper ";
  const Outcome outcome = luminist(styles + "--together --json -o out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.out;
  EXPECT_LT(json["epsilon"].get<double>(), json["epsilon_start"].get<double>());
  double mean = 0.0;
  for (const char* style : {"toon", "halftone"}) mean += json["styles"][style]["epsilon"].get<double>() / 2.0;
  EXPECT_NEAR(json["epsilon"].get<double>(), mean, 1e-4 * mean);  // sums in floats; no penalty
  EXPECT_TRUE(json["styles"]["toon"]["style"].contains("bright"));
  EXPECT_TRUE(json["styles"]["halftone"]["style"].contains("paper"));
  EXPECT_EQ(read("out/rig.toml"), read("out/toon/rig.toml"));
  EXPECT_EQ(read("out/rig.toml"), read("out/halftone/rig.toml"));
}

TEST_F(CliTest, SaysWhichStylesItCannotSolveIn) {
  expect_error(luminist(std::string(kSolve) + "--together -o out"), 2);
  expect_error(luminist(std::string(kSolve) + "--style toon,toon -o out"), 2);
  EXPECT_NE(luminist(std::string(kSolve) + "--style toon,nosuch -o out").status, 0);
  EXPECT_NE(luminist(std::string(kSolve) + "--style toon,gooch --unlock style/nosuch -o out").status, 0);
}

TEST_F(CliTest, TheSameSeedGivesTheSameBits) {
  ASSERT_EQ(luminist(std::string(kSolve) + "--seed 7 -o one").status, 0);
  ASSERT_EQ(luminist(std::string(kSolve) + "--seed 7 -o two").status, 0);
  EXPECT_EQ(read("one/rig.toml"), read("two/rig.toml"));
}

TEST_F(CliTest, GivesTheSameBitsOnAnyNumberOfThreads) {
  // Software GL takes its number of threads from LP_NUM_THREADS, the rest of the program from the cores it may use.
  const std::string words = "\"$LUMINIST\" " + std::string(kSolve) + "--seed 7 -o ";
  ASSERT_EQ(shell("LP_NUM_THREADS=1 taskset -c 0 " + words + "one", folder_.path()).status, 0);
  ASSERT_EQ(shell("LP_NUM_THREADS=5 " + words + "many", folder_.path()).status, 0);
  EXPECT_EQ(read("one/rig.toml"), read("many/rig.toml"));
}

TEST_F(CliTest, MatchesAPictureAsTarget) {
  ASSERT_EQ(luminist("render ball.obj --size 64x48 --rig rig.toml --set lights/key/color=0.2,0.5,0.9 -o t.exr").status,
            0);
  const Outcome outcome = luminist(
      "solve ball.obj --size 64x48 --rig rig.toml --target t.exr --lock '*' --unlock lights/key/color --evals 60 "
      "--json "
      "-o out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.out;
  EXPECT_EQ(json["lights"][0]["unlocked"].size(), 3U);
  EXPECT_LT(json["epsilon"].get<double>(), 0.05 * json["epsilon_start"].get<double>());
  EXPECT_NEAR(json["lights"][0]["params"]["color"][2].get<double>(), 0.9, 0.05);
}

/// What the lights of a solve have unlocked, by the report.
std::vector<std::vector<std::string>> unlocked_in(const Outcome& outcome) {
  std::vector<std::vector<std::string>> lists;
  const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
  if (!json.is_object()) return lists;
  for (const auto& light : json["lights"]) lists.push_back(light["unlocked"].get<std::vector<std::string>>());
  return lists;
}

TEST_F(CliTest, LocksHoldForSingleDegreesOfFreedomLightsAndGroupsInOptionsAndRigFiles) {
  const std::string color = "color = [0.5, 0.5, 0.5]\n";
  write("rig.toml", "[[light]]\nname = \"key\"\ntype = \"cinematic\"\nunlocked = [\"color.g\"]\n" + color +
                        "[[light]]\nname = \"fill\"\ntype = \"cinematic\"\ngroup = \"soft\"\n" + color +
                        "[[light]]\nname = \"rim\"\ntype = \"cinematic\"\n" + color);
  ASSERT_EQ(luminist("render ball.obj --size 64x48 --rig rig.toml --set lights/key/color=0.2,0.8,0.5 -o t.exr").status,
            0);
  const std::string words = "solve ball.obj --size 64x48 --rig rig.toml --target t.exr --evals 20 --json -o out ";
  using Lists = std::vector<std::vector<std::string>>;
  const Outcome locked = luminist(words + "--lock group:soft --lock lights/rim");
  EXPECT_EQ(unlocked_in(locked), (Lists{{"color.g"}, {}, {}}));
  const auto lights = nlohmann::json::parse(locked.out, nullptr, false)["lights"];
  EXPECT_EQ(lights[0]["params"]["color"][0].get<double>(), 0.5);
  EXPECT_NEAR(lights[0]["params"]["color"][1].get<double>(), 0.8, 0.05);  // the target's, up to 1 % of the error
  EXPECT_EQ(lights[1]["params"]["color"][1].get<double>(), 0.5);
  EXPECT_EQ(unlocked_in(luminist(words + "--lock '*' --unlock group:soft/color --unlock lights/rim/position.y")),
            (Lists{{}, {"color.r", "color.g", "color.b"}, {"position.y"}}));
  EXPECT_NE(read("out/rig.toml").find("unlocked = [\"position.y\"]"), std::string::npos) << "locks are written too";
}

TEST_F(CliTest, AStyleParameterIsLockedAndUnlocked) {
  const std::string shot = " ball.obj --size 64x48 --style toon --rig rig.toml ";
  ASSERT_EQ(luminist("render" + shot + "--set style/bright=0.6,0.6,0.6 -o t.exr").status, 0);
  const std::string words = "solve" + shot + "--target t.exr --evals 20 -o out --lock '*' ";
  const auto bright = [&] { return nlohmann::json::parse(read("out/style.json"), nullptr, false)["bright"][0]; };
  ASSERT_EQ(luminist(words + "--unlock lights/key/barn").status, 0);
  EXPECT_EQ(bright().get<double>(), 1.0);
  ASSERT_EQ(luminist(words + "--unlock 'style/*'").status, 0);
  EXPECT_LT(bright().get<double>(), 0.9);
}

TEST_F(CliTest, ConstraintsHoldInWhatASolveFindsAndInItsRigFile) {
  const Outcome outcome =
      luminist(std::string(kSolve) + "--constrain 'lights/light on ceiling' --solver simplex --json -o out");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.out;
  EXPECT_EQ(json["lights"][0]["params"]["position"][1].get<double>(), 2.0);  // the top of the ball
  EXPECT_LT(json["epsilon"].get<double>(), json["epsilon_start"].get<double>());
  EXPECT_NE(read("out/rig.toml").find("on_plane = { point = [0, 2, 0], normal = [0, -1, 0] }"), std::string::npos)
      << read("out/rig.toml");
  ASSERT_EQ(luminist("render ball.obj --size 64x48 --rig out/rig.toml -o again.exr").status, 0);
  LUM_ASSERT_OK(const Image picture, read_image(folder_.file("out/picture.exr")));
  LUM_ASSERT_OK(const Image again, read_image(folder_.file("again.exr")));
  EXPECT_EQ(picture.data, again.data);
}

TEST_F(CliTest, AConstraintThatIsNotUnderstoodSaysWhichWords) {
  const Outcome outcome = luminist("render ball.obj --rig rig.toml --constrain 'lights/kay on ceiling' -o a.exr");
  expect_error(outcome, 2);
  EXPECT_NE(outcome.err.find("did you mean \"key\""), std::string::npos) << outcome.err;
}

TEST_F(CliTest, UntilAnErrorThatIsNotReachedEndsWithOne) {
  EXPECT_EQ(luminist(std::string(kSolve) + "--until 0.0000001 -o out").status, 1);
  EXPECT_TRUE(exists("out/picture.exr"));
  EXPECT_EQ(luminist(std::string(kSolve) + "--until 10 -o out").status, 0);
}

TEST_F(CliTest, SaysAtOnceThatThereIsNothingToDo) {
  write("nothing.json", R"({"strokes": []})");
  expect_error(luminist("solve ball.obj --size 64x48 --rig rig.toml --paint nothing.json -o out"), 8);
  expect_error(luminist("solve ball.obj --size 64x48 --rig rig.toml --paint light.json --lock '*' -o out"), 8);
  expect_error(luminist("solve ball.obj --size 64x48 --paint light.json -o out"), 8);  // no light, none added
  write("dark.json", R"({"strokes": [{"color": [0, 0, 0], "points": [[0.6, 0.4]]}]})");
  expect_error(luminist("solve ball.obj --size 64x48 --paint dark.json --add-light 1 -o out"), 8);
  EXPECT_FALSE(exists("out/picture.exr"));
}

TEST_F(CliTest, RefusesWordsThatContradictEachOther) {
  expect_error(luminist("solve ball.obj -o out"), 2);
  expect_error(luminist("solve ball.obj --paint light.json --target t.exr -o out"), 2);
  expect_error(luminist("solve ball.obj --paint light.json --importance i.exr -o out"), 2);
  expect_error(luminist("solve ball.obj --paint light.json --solver newton -o out"), 2);
  expect_error(luminist("solve ball.obj --paint light.json --evals 5 --seconds 5 -o out"), 2);
  expect_error(
      luminist("solve ball.obj --size 64x48 --rig rig.toml --paint light.json --unlock lights/kye/color -o out"), 2);
}

TEST_F(CliTest, RefusesTimesAndGoalsThatAreNoNumbers) {
  for (const char* words : {"--seconds nan", "--seconds inf", "--until nan", "--until -nan", "--seconds -1"}) {
    const Outcome outcome = luminist(std::string("solve ball.obj --paint light.json --add-light 1 -o out ") + words);
    expect_error(outcome, 2);
    EXPECT_NE(outcome.err.find(std::string(words).substr(0, 7)), std::string::npos) << outcome.err;
  }
}

TEST_F(CliTest, WarnsOfValuesOutsideTheirRangeAlsoWhereItFailsThen) {
  const std::string words = "solve ball.obj --size 64x48 --rig rig.toml --set lights/key/shadow_density=20 --evals 2 ";
  const Outcome outcome = luminist(words + "--paint light.json -o out");
  EXPECT_NE(outcome.err.find("warning lights/key/shadow_density: 20 is outside the range 0 to 1"), std::string::npos)
      << outcome.err;
  const Outcome failed = luminist(words + "--paint missing.json -o out");
  EXPECT_EQ(failed.status, 4) << failed.err;
  EXPECT_NE(failed.err.find("20 is outside"), std::string::npos) << failed.err;
}

TEST_F(CliTest, NamesTheFieldOfABrokenStroke) {
  write("broken.json", "{\"strokes\": [\n{\"colour\": [1, 1, 1], \"points\": [[0, 0]]}]}");
  const Outcome outcome = luminist("solve ball.obj --size 64x48 --paint broken.json --add-light 1 -o out");
  expect_error(outcome, 3);
  EXPECT_NE(outcome.err.find("broken.json:2"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("color"), std::string::npos) << outcome.err;
}

TEST_F(CliTest, MasksWhatIsNotANumberInATargetAndSaysSo) {
  ASSERT_EQ(luminist("render ball.obj --size 64x48 --rig rig.toml --set lights/key/color=0.2,0.5,0.9 -o t.exr").status,
            0);
  LUM_ASSERT_OK(Image target, read_image(folder_.file("t.exr")));
  for (const int x : {3, 4, 5}) target.at(x, 2, 0) = std::numeric_limits<float>::quiet_NaN();
  LUM_EXPECT_OK(write_image(folder_.file("nan.exr"), target));
  const Outcome outcome = luminist(
      "solve ball.obj --size 64x48 --rig rig.toml --target nan.exr --lock '*' --unlock lights/key/color --evals 40 -o "
      "out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("3 pixels"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("(3, 2)"), std::string::npos) << outcome.err;
  LUM_ASSERT_OK(const Image importance, read_image(folder_.file("out/importance.exr")));
  EXPECT_EQ(importance.at(4, 2, 0), 0.0F);
  EXPECT_EQ(importance.at(10, 10, 0), 1.0F);
}

TEST_F(CliTest, AnImportanceMapOfZerosCountsNothing) {
  LUM_EXPECT_OK(write_image(folder_.file("zero.exr"), Image(64, 48, 1, 0.0F)));
  LUM_EXPECT_OK(write_image(folder_.file("t.exr"), Image(64, 48, 3, 0.5F)));
  expect_error(luminist("solve ball.obj --size 64x48 --rig rig.toml --target t.exr --importance zero.exr -o out"), 8);
}

TEST_F(CliTest, StoppedItWritesTheBestSoFar) {
  for (const auto& [signal, status] : {std::pair("INT", 130), std::pair("TERM", 143)}) {
    // How long loading takes is the machine's business: wait longer until the signal arrives during the solve.
    for (int wait = 2; wait <= 64; wait *= 2) {
      const Outcome outcome =
          shell("timeout --foreground --preserve-status -s " + std::string(signal) + " " + std::to_string(wait) +
                    " \"$LUMINIST\" solve ball.obj --size 64x48 --paint light.json --add-light 1 --solver simplex -o " +
                    signal,
                folder_.path());
      ASSERT_EQ(outcome.status, status) << outcome.err;
      if (exists(std::string(signal) + "/picture.exr")) break;
    }
    LUM_EXPECT_OK(read_image((folder_.path() / signal / "picture.exr").string()));
    EXPECT_TRUE(exists(std::string(signal) + "/rig.toml"));
  }
}

TEST_F(CliTest, SecondsLimitASolveFromOutside) {
  const Outcome outcome = luminist(
      "solve ball.obj --size 64x48 --paint light.json --add-light 1 --solver simplex --seconds 0.2 --json -o out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["termination"], "stopped");
}

}  // namespace
}  // namespace luminist
