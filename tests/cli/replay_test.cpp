#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "image_io/image_io.h"

namespace luminist {
namespace {

constexpr const char* kScript = R"(# a key light, step by step
{"do": "open", "scene": "ball.obj", "size": [64, 48]}

{"do": "paint", "strokes": "light.json"}
{"do": "add_light", "name": "key"}
{"do": "solve", "seed": 1, "max_evals": 40}
{"do": "accept"}
{"do": "export", "to": "step1", "label": "key light"}
{"do": "paint", "strokes": {"strokes": [{"color": [0, 0, 1], "add_light": true, "points": [[0.3, 0.5]]}]}}
{"do": "undo"}
{"do": "redo"}
{"do": "undo"}
{"do": "set", "path": "ambient/color", "value": [0.1, 0.1, 0.1]}
{"do": "contact_sheet", "to": "sheet.png"}
{"do": "save", "project": "ball.lum"}
)";

TEST_F(CliTest, ReplaysAScriptAndTheProjectThatItSaved) {
  write("script.jsonl", kScript);
  const Outcome outcome = luminist("replay script.jsonl -o out");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* name :
       {"out/step1/picture.exr", "out/step1/convergence.png", "out/sheet.png", "out/ball.lum/log.jsonl"}) {
    EXPECT_TRUE(exists(name)) << name;
  }
  for (const char* log : {"out/ball.lum", "out/ball.lum/log.jsonl"}) {
    const Outcome again = luminist(std::string("replay ") + log + " -o again");
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_NE(read("again/rig.toml").find("0.1, 0.1, 0.1"), std::string::npos);
  }
}

TEST_F(CliTest, GoesOnWithASavedProject) {
  write("script.jsonl", kScript);
  ASSERT_EQ(luminist("replay script.jsonl -o out").status, 0);
  write("more.jsonl", R"({"do": "open", "project": "out/ball.lum"}
{"do": "undo", "steps": 4}
{"do": "export", "to": "start"}
{"do": "save"}
)");
  const Outcome outcome = luminist("replay more.jsonl -o out");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  ASSERT_EQ(luminist("render ball.obj --size 64x48 -o start.exr").status, 0);
  LUM_ASSERT_OK(const Image undone, read_image(folder_.file("out/start/picture.exr")));
  LUM_ASSERT_OK(const Image start, read_image(folder_.file("start.exr")));
  EXPECT_EQ(undone.data, start.data);
}

TEST_F(CliTest, NamesTheLineAndTheFieldOfAScript) {
  const std::string open = "{\"do\": \"open\", \"scene\": \"ball.obj\", \"size\": [32, 32]}\n";
  struct Case {
    std::string script;
    std::string place;
    std::string words;
    int status;
  };
  for (const Case& each :
       {Case{"{\"do\": \"undo\"}\n", "s.jsonl:1", "open", 3},
        Case{open + "{\"do\": \"pant\"}\n", "s.jsonl:2", "\"paint\"", 3},
        Case{open + "\n{\"do\": \"paint\", \"stroke\": \"x\"}\n", "s.jsonl:3", "strokes", 3},
        Case{open + "{\"do\": \"solve\", \"seed\": \"one\"}\n", "s.jsonl:2", "seed", 3},
        Case{open + "{\"do\": \"solve\"}\n", "s.jsonl:2", "nothing is painted", 8},
        Case{open + "{\"do\": \"accept\"}\n", "s.jsonl:2", "solve first", 8},
        Case{open + "{\"do\": \"paint\", \"strokes\": \"none.json\"}\n", "s.jsonl:2", "none.json", 4},
        Case{open + "{\"do\": \"mute\", \"light\": \"kye\"}\n", "s.jsonl:2", "kye", 2},
        Case{open + "not json\n", "s.jsonl:2", "JSON", 3}, Case{open + "[1]\n", "s.jsonl:2", "do", 3}}) {
    write("s.jsonl", each.script);
    const Outcome outcome = luminist("replay s.jsonl -o out");
    expect_error(outcome, each.status);
    EXPECT_NE(outcome.err.find(each.place), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(each.words), std::string::npos) << outcome.err;
  }
}

TEST_F(CliTest, StoppedAScriptLeavesTheBestSoFar) {
  write("s.jsonl", R"({"do": "open", "scene": "ball.obj", "size": [64, 48]}
{"do": "paint", "strokes": "light.json"}
{"do": "add_light"}
{"do": "export", "to": "ready"}
{"do": "solve", "solver": "simplex"}
)");
  const Outcome outcome = shell(
      "\"$LUMINIST\" replay s.jsonl -o out >/dev/null & pid=$!\n"
      "while ! [ -e out/ready/residual.png ] && kill -0 $pid; do sleep 0.1; done; sleep 0.5\n"
      "kill -TERM $pid; wait $pid",
      folder_.path());
  EXPECT_EQ(outcome.status, 143) << outcome.err;
  EXPECT_TRUE(exists("out/stopped/picture.exr"));
}

TEST_F(CliTest, RefusesADamagedOrNewerProject) {
  write("script.jsonl", kScript);
  ASSERT_EQ(luminist("replay script.jsonl -o out").status, 0);
  const std::string log = read("out/ball.lum/log.jsonl");
  std::string damaged = log;
  damaged[log.find("\"before\"") + 1] = 'B';
  write("out/ball.lum/log.jsonl", damaged);
  const Outcome outcome = luminist("replay out/ball.lum -o again");
  expect_error(outcome, 3);
  EXPECT_NE(outcome.err.find("log.jsonl:"), std::string::npos) << outcome.err;
}

TEST_F(CliTest, SavesNothingOverAFolderThatIsNoProject) {
  std::filesystem::create_directories(folder_.path() / "out/photos.lum");
  write("out/photos.lum/photo", "x");
  write("s.jsonl",
        "{\"do\": \"open\", \"scene\": \"ball.obj\", \"size\": [32, 32]}\n"
        "{\"do\": \"save\", \"project\": \"photos.lum\"}\n");
  expect_error(luminist("replay s.jsonl -o out"), 5);
  EXPECT_EQ(read("out/photos.lum/photo"), "x");
}

TEST_F(CliTest, ComparesGoldenPictures) {
  std::filesystem::create_directories(folder_.path() / "styles/flat");
  write("styles/flat/style.toml", R"(doc = "Albedo."
shade = "flat.glsl"
lights = "joint"

[[golden]]
name = "ball"
scene = "ball.obj"
width = 32
height = 32
max_difference = 0.001
mean_difference = 0.0001
reason = "the same machine draws the same bits; the numbers allow for half floats"
)");
  write("styles/flat/flat.glsl", "vec3 shade(Surface s) {\n  return s.albedo;\n}\n");
  const Outcome missing = luminist("golden styles/flat -o page");
  EXPECT_EQ(missing.status, 1) << missing.err;
  EXPECT_NE(missing.out.find("no reference"), std::string::npos) << missing.out;
  EXPECT_TRUE(exists("page/ball.exr"));
  EXPECT_EQ(luminist("golden styles/flat --update -o page").status, 0);
  EXPECT_TRUE(exists("styles/flat/golden/ball.exr"));
  EXPECT_EQ(luminist("golden styles/flat -o page").status, 0);
  write("styles/flat/flat.glsl", "vec3 shade(Surface s) {\n  return 1.1 * s.albedo;\n}\n");
  const Outcome differs = luminist("golden styles/flat -o page");
  EXPECT_EQ(differs.status, 1) << differs.err;
  EXPECT_NE(differs.out.find("FAILED ball: max"), std::string::npos) << differs.out;
  const auto outcomes = nlohmann::json::parse(read("page/outcomes.json"));
  const auto& ball = outcomes.at("cases").at(0);
  EXPECT_EQ(ball.at("difference"), "ball.difference.png");
  EXPECT_FALSE(ball.at("passed").get<bool>());
  ASSERT_FALSE(ball.at("worst").empty());
  EXPECT_EQ(ball["worst"][0]["difference"], ball["max_difference"]);
  expect_error(luminist("golden styles/flat --case bal -o page"), 2);
  EXPECT_TRUE(exists("page/ball.reference.png"));
}

TEST_F(CliTest, ReplaysStrokesLiveAndSaysHowLongThePicturesTook) {
  write("script.jsonl", kScript);
  const Outcome outcome = luminist("replay script.jsonl --live --slice-ms 5 --json -o out");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto live = nlohmann::json::parse(outcome.out.substr(0, outcome.out.find('\n')), nullptr, false);
  ASSERT_TRUE(live.is_object()) << outcome.out;
  EXPECT_EQ(live["strokes_of"], "light.json");
  EXPECT_GT(live["events"].get<int>(), 5);
  EXPECT_LE(live["frames"].get<int>(), live["events"].get<int>());
  for (const char* part : {"event_to_picture", "paint", "retarget", "solve", "picture", "stroke_to_improvement"}) {
    EXPECT_LE(live[part]["median"].get<double>(), live[part]["p95"].get<double>()) << part;
    EXPECT_LE(live[part]["p95"].get<double>(), live[part]["max"].get<double>()) << part;
  }
  EXPECT_LE(live["error"].get<double>(), live["error_event"].get<double>());
  EXPECT_LE(live["improved"].get<int>(), live["strokes"].get<int>());
  EXPECT_GE(live["improved"].get<int>(), 1) << "the light that the strokes ask for is found";
  EXPECT_TRUE(exists("out/step1/picture.exr"));  // the rest of the script goes on with what was found
  EXPECT_TRUE(exists("out/ball.lum/log.jsonl"));
}

TEST_F(CliTest, ALivePaintingIsJudgedByTheImportanceOfTheScript) {
  const std::string start = R"({"do": "open", "scene": "ball.obj", "size": [64, 48]}
{"do": "paint", "strokes": "light.json"}
{"do": "add_light", "name": "key"}
)";
  const std::string solve = R"({"do": "mute", "light": "key", "muted": false}
{"do": "solve", "seed": 1, "max_evals": 40}
)";
  const auto error_before = [&](const std::string& script) {
    write("script.jsonl", script);
    const Outcome outcome = luminist("replay script.jsonl --live --json -o out");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out.substr(0, outcome.out.find('\n')))["error_before"].get<double>();
  };
  const double plain = error_before(start + solve);
  const double all_alike = error_before(start +
                                        R"({"do": "importance", "nu": 1, "delta": 0})"
                                        "\n" +
                                        solve);
  EXPECT_LT(all_alike, 0.5 * plain) << "most of the picture is not painted and right already";
  const Outcome outcome = luminist("replay script.jsonl --live -o out");
  EXPECT_NE(outcome.out.find("event to picture"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("stroke 1"), std::string::npos) << "the verdict is said: " << outcome.out;
}

TEST_F(CliTest, AScriptThatDoesNothingAndAFolderThatIsNoProjectAreErrors) {
  write("empty.jsonl", "# nothing\n\n");
  EXPECT_NE(luminist("replay empty.jsonl -o out").status, 0);
  std::filesystem::create_directory(folder_.file("plain"));
  const Outcome outcome = luminist("replay plain -o out");
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(outcome.err.find("no project"), std::string::npos) << outcome.err;
}

TEST_F(CliTest, RefusesToPaintAProjectLive) {
  write("script.jsonl", kScript);
  ASSERT_EQ(luminist("replay script.jsonl -o out").status, 0);
  const Outcome outcome = luminist("replay out/ball.lum --live -o again");
  expect_error(outcome, 2);
  EXPECT_NE(outcome.err.find("action script"), std::string::npos) << outcome.err;
  expect_error(luminist("replay script.jsonl --slice-ms 12 -o out"), 2);  // without --live it says nothing
}

}  // namespace
}  // namespace luminist
