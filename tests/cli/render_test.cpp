#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "image_io/image_io.h"

namespace luminist {
namespace {

TEST_F(CliTest, RendersAShotToExrAndPng) {
  for (const char* name : {"a.exr", "a.png"}) {
    const Outcome outcome = luminist(std::string("render ball.obj --size 64x48 --rig rig.toml -o ") + name);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, std::string(name) + "\n");
    LUM_ASSERT_OK(const Image picture, read_image(folder_.file(name)));
    EXPECT_EQ(picture.width, 64);
    EXPECT_EQ(picture.height, 48);
  }
}

TEST_F(CliTest, SetsParametersAndStylesOfAShot) {
  ASSERT_EQ(luminist("render ball.obj --size 32x32 --rig rig.toml -o a.exr").status, 0);
  ASSERT_EQ(luminist("render ball.obj --size 32x32 --rig rig.toml --set lights/key/color=0,0,0 "
                     "--set ambient/color=0,0,0 -o black.exr")
                .status,
            0);
  ASSERT_EQ(luminist("render ball.obj --size 32x32 --rig rig.toml --style toon --floor --wall -o toon.exr").status, 0);
  LUM_ASSERT_OK(const Image lit, read_image(folder_.file("a.exr")));
  LUM_ASSERT_OK(const Image black, read_image(folder_.file("black.exr")));
  LUM_ASSERT_OK(const Image toon, read_image(folder_.file("toon.exr")));
  EXPECT_GT(*std::max_element(lit.data.begin(), lit.data.end()), 0.1F);
  EXPECT_EQ(*std::max_element(black.data.begin(), black.data.end()), 0.0F);
  EXPECT_NE(lit.data, toon.data);
  const Outcome outside = luminist("render ball.obj --size 32x32 --style toon --set style/feather=9 -o wide.exr");
  EXPECT_EQ(outside.status, 0);
  EXPECT_NE(outside.err.find("style/feather: 9 is outside the range 0 to 0.5"), std::string::npos) << outside.err;
}

TEST_F(CliTest, LinksLightsToObjectsAndRefusesOthers) {
  const std::string render = "render ball.obj --size 32x32 --rig rig.toml ";
  ASSERT_EQ(luminist(render + "-o all.exr").status, 0);
  ASSERT_EQ(luminist(render + "--link 'key=fl*' -o floor.exr").status, 0);
  EXPECT_NE(read("all.exr"), read("floor.exr"));
  write("linked.toml", "[[light]]\nname = \"key\"\ntype = \"cinematic\"\nobjects = [\"fl*\"]\n");
  ASSERT_EQ(luminist("render ball.obj --size 32x32 --rig linked.toml -o file.exr").status, 0);
  EXPECT_EQ(read("file.exr"), read("floor.exr"));
  const Outcome missing = luminist(render + "--link key=bal -o bad.exr");
  expect_error(missing, 2);
  EXPECT_NE(missing.err.find("did you mean \"ball\"?"), std::string::npos) << missing.err;
  write("typo.toml", "[[light]]\nname = \"key\"\ntype = \"cinematic\"\nobjects = [\"flor\"]\n");
  const Outcome typo = luminist("render ball.obj --size 32x32 --rig typo.toml -o bad.exr");
  expect_error(typo, 2);
  EXPECT_NE(typo.err.find("typo.toml"), std::string::npos) << typo.err;
}

TEST_F(CliTest, PaintsATargetWithItsImportanceBeside) {
  const Outcome outcome = luminist("paint ball.obj light.json --size 64x48 -o target.exr");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  LUM_ASSERT_OK(const Image target, read_image(folder_.file("target.exr")));
  LUM_ASSERT_OK(const Image importance, read_image(folder_.file("target.importance.exr")));
  EXPECT_TRUE(target.same_size(importance));
  const auto [least, most] = std::minmax_element(importance.data.begin(), importance.data.end());
  EXPECT_EQ(*most, 1.0F);
  EXPECT_NEAR(*least, 0.1F, 1e-4F);  // nu, through half floats
}

TEST_F(CliTest, PrintsTheReferenceOfAllParameters) {
  const Outcome outcome = luminist("doc");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* word : {"shadow_density", "falloff_exponent", "threshold", "## toon", "## ambient"}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }
}

TEST_F(CliTest, PrintsWhatTheMachineOffers) {
  const Outcome outcome = luminist("info --json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object());
  EXPECT_GE(json["max_texture_size"].get<int>(), 4096);
  EXPECT_EQ(json["version"], "0.1.0");
  EXPECT_EQ(luminist("info").status, 0);
  EXPECT_EQ(luminist("--version").out, "luminist 0.1.0\n");
}

TEST_F(CliTest, EveryVerbHasHelpWithAnExample) {
  for (const char* verb : {"render", "paint", "solve", "replay", "golden", "doc", "info"}) {
    const Outcome outcome = luminist(std::string(verb) + " --help");
    EXPECT_EQ(outcome.status, 0) << verb;
    EXPECT_NE(outcome.out.find("Example"), std::string::npos) << verb;
    EXPECT_NE(outcome.out.find(std::string("luminist ") + verb), std::string::npos) << verb;
    EXPECT_EQ(outcome.err, "") << verb;
  }
}

TEST_F(CliTest, SaysWhatToDoWhereThereIsNoDisplayForTheWindow) {
  const Outcome outcome = shell("env -u DISPLAY -u WAYLAND_DISPLAY \"$LUMINIST\"", folder_.path());
  expect_error(outcome, 6);
  EXPECT_NE(outcome.err.find("--help"), std::string::npos) << outcome.err;
}

TEST_F(CliTest, RefusesWordsThatItDoesNotKnowWithStatusTwo) {
  expect_error(luminist("rendre ball.obj"), 2);
  expect_error(luminist("render ball.obj"), 2);
  expect_error(luminist("render ball.obj --size 64by48 -o a.png"), 2);
  expect_error(luminist("render ball.obj --size 0x48 -o a.png"), 2);
  expect_error(luminist("render ball.obj --size 64x48 -o a.tga"), 2);
  expect_error(luminist("render ball.obj --size 64x48 --camera left -o a.png"), 2);
  expect_error(luminist("render ball.obj --size 64x48 --set lights/key=1 -o a.png"), 2);
  const Outcome stacked = luminist("render ball.obj --style cinematic,toon -o a.png");
  expect_error(stacked, 2);
  EXPECT_NE(stacked.err.find("cannot be stacked"), std::string::npos) << stacked.err;
}

TEST_F(CliTest, TellsWhatIsWrongWithAnInput) {
  expect_error(luminist("render nothing.obj -o a.png"), 4);
  expect_error(luminist("render ball.obj --rig nothing.toml -o a.png"), 4);
  expect_error(luminist("render ball.obj --style nothing -o a.png"), 4);
  write("broken.toml", "[[light]]\nname = \"key\"\ntype = \"cinematic\"\nbran = [1, 1, 1]\n");
  const Outcome rig = luminist("render ball.obj --size 32x32 --rig broken.toml -o a.png");
  expect_error(rig, 3);
  EXPECT_NE(rig.err.find("broken.toml:4"), std::string::npos) << rig.err;
  write("cut.glb", std::string("glTF\x02\0\0\0\x00\x10\0\0", 12));
  expect_error(luminist("render cut.glb -o a.png"), 3);
  write("empty.obj", "");
  expect_error(luminist("render empty.obj -o a.png"), 3);
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(CliTest, SaysInJsonWhatIsWrong) {
  const Outcome outcome = luminist("solve nothing.obj --paint light.json --json -o out");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_EQ(outcome.out, "");
  const auto json = nlohmann::json::parse(outcome.err, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.err;
  EXPECT_EQ(json["error"]["code"], "E400");
  EXPECT_EQ(json["error"]["exit"], 4);
}

TEST_F(CliTest, NamesTheLineOfABrokenStyle) {
  std::filesystem::create_directories(folder_.path() / "styles/broken");
  write("styles/broken/style.toml", "doc = \"x\"\nshade = \"broken.glsl\"\nlights = \"sum\"\n");
  write("styles/broken/broken.glsl", "vec3 shade(Surface s) {\n  return s.albdeo;\n}\n");
  const Outcome shader = shell(
      "LUMINIST_ROOT=$PWD exec \"$LUMINIST\" render ball.obj --size 32x32 --style broken -o a.png", folder_.path());
  expect_error(shader, 10);
  EXPECT_NE(shader.err.find("broken.glsl:2"), std::string::npos) << shader.err;
  write("styles/broken/style.toml", "doc = \"x\"\nshade = \"broken.glsl\"\nlihgts = \"sum\"\n");
  const Outcome manifest = shell(
      "LUMINIST_ROOT=$PWD exec \"$LUMINIST\" render ball.obj --size 32x32 --style broken -o a.png", folder_.path());
  expect_error(manifest, 10);
  EXPECT_NE(manifest.err.find("style.toml:3"), std::string::npos) << manifest.err;
}

TEST_F(CliTest, FindsOutBeforeTheWorkThatItCannotWrite) {
  write("file", "");
  expect_error(luminist("render ball.obj -o file/a.png"), 5);
  EXPECT_EQ(luminist("render ball.obj --size 8x8 -o made/deep/a.png").status, 0);  // folders are made
  expect_error(luminist("render nothing.obj -o file/a.png"), 5);                   // the output is looked at first
  expect_error(luminist("solve nothing.obj --paint light.json -o file/out"), 5);
  expect_error(luminist("solve nothing.obj --paint light.json -o /dev/full"), 5);
  expect_error(luminist("replay nothing.jsonl -o out"), 4);
}

TEST_F(CliTest, AFullDiskLeavesNoHalfPicture) {
  // Files may have one kilobyte: the write fails half way, as on a full disk.
  const Outcome outcome =
      shell("ulimit -f 1; exec \"$LUMINIST\" render ball.obj --size 64x48 --rig rig.toml -o a.exr", folder_.path());
  expect_error(outcome, 5);
  EXPECT_FALSE(exists("a.exr"));
}

TEST_F(CliTest, WorksWithoutALocaleAHomeOrStandardStreams) {
  const std::string render = "\"$LUMINIST\" render ball.obj --size 16x16 -o ";
  EXPECT_EQ(shell("LC_ALL=de_DE.UTF-8 " + render + "a.png", folder_.path()).status, 0);
  EXPECT_EQ(shell("env -i " + render + "b.png", folder_.path()).status, 0);
  EXPECT_EQ(shell("exec " + render + "c.png >&-", folder_.path()).status, 0);
  EXPECT_EQ(shell("exec " + render + "d.png <&- >&- 2>&-", folder_.path()).status, 0);
  for (const char* name : {"a.png", "b.png", "c.png", "d.png"}) {
    LUM_EXPECT_OK(read_image(folder_.file(name)));
  }
}

TEST_F(CliTest, SurvivesAReaderThatGoesAwayAndReportsAFullOne) {
  const Outcome gone = shell("{ \"$LUMINIST\" doc; echo $? >status; } | head -1", folder_.path());
  EXPECT_EQ(read("status"), "0\n") << gone.err;
  expect_error(shell("exec \"$LUMINIST\" doc >/dev/full", folder_.path()), 5);
}

TEST_F(CliTest, TakesFileNamesAsTheyCome) {
  const std::string long_name = std::string(251, 'n') + ".png";
  for (const std::string& name : {std::string("with space.png"), std::string("qu\"ote.png"), std::string("-dash.png"),
                                  std::string("gr\xc3\xbcn.png"), long_name}) {
    std::ofstream(folder_.file("name")) << name;
    const Outcome outcome =
        shell("exec \"$LUMINIST\" render ball.obj --size 16x16 -o \"./$(cat name)\"", folder_.path());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(exists(name)) << name;
  }
}

TEST_F(CliTest, AFarmJobIsWrittenOnlyIfItsFirstFrameCouldBeRendered) {
  const std::string words = "farm ball.obj --rig rig.toml --size 16x12 --frames 0-3 -o f.#.exr --job job ";
  expect_error(luminist(words + "--set lights/key/colour=1,1,1"), 2);
  expect_error(luminist(words + "--link key=boll"), 2);
  EXPECT_FALSE(exists("job"));
  const Outcome good = luminist(words + "--set lights/key/color=1,1,1 --link key=ball");
  EXPECT_EQ(good.status, 0) << good.err;
  EXPECT_TRUE(exists("job/job.sh") && exists("job/commands.txt"));
}

}  // namespace
}  // namespace luminist
