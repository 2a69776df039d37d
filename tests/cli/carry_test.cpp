#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "paint/stroke.h"

namespace luminist {
namespace {

TEST_F(CliTest, CarriesStrokesAndTellsWhatBecameOfThem) {
  write("strokes.json", R"({"nu": 0.2, "strokes": [
    {"diameter": 0.1, "clip": "ball", "points": [[0.6, 0.4], [0.65, 0.45]]},
    {"diameter": 0.1, "points": [[0.01, 0.01]]}]})");
  const Outcome same = luminist("carry ball.obj --paint strokes.json --to-frame 5 -o there.json");
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_NE(same.out.find("stroke 1 on ball: 7 of 7 points\n"), std::string::npos) << same.out;
  EXPECT_NE(same.out.find("stroke 2: left out (1 off the surface)\n"), std::string::npos) << same.out;
  EXPECT_NE(same.out.find("there.json\n"), std::string::npos) << same.out;
  LUM_ASSERT_OK(const StrokeFile carried, load_strokes(folder_.file("there.json")));
  ASSERT_EQ(carried.strokes.size(), 1U);
  EXPECT_EQ(carried.nu, 0.2F);
  EXPECT_NEAR(carried.strokes[0].points.front().x, 0.6F, 1e-5F);  // nothing moves
  EXPECT_EQ(luminist("paint ball.obj there.json --size 64x48 -o target.exr").status, 0);
  const Outcome json = luminist("carry ball.obj --paint strokes.json --to-frame 5 -o there.json --json");
  const auto report = nlohmann::json::parse(json.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << json.out;
  EXPECT_EQ(report["strokes"][1]["off_surface"], 1);
}

TEST_F(CliTest, CarryNamesWhatIsWrong) {
  expect_error(luminist("carry ball.obj --paint light.json -o there.json"), 2);
  expect_error(luminist("carry ball.obj --paint light.json --to-camera side -o there.json"), 2);
  expect_error(luminist("carry ball.obj --paint none.json --to-frame 1 -o there.json"), 4);
  expect_error(luminist("carry ball.obj --paint light.json --to-frame 1 -o none/there.json"), 5);
  write("empty.json", R"({"strokes": []})");
  expect_error(luminist("carry ball.obj --paint empty.json --to-frame 1 -o there.json"), 8);
  write("air.json", R"({"strokes": [{"points": [[0.01, 0.01]]}]})");
  expect_error(luminist("carry ball.obj --paint air.json --to-frame 1 -o there.json"), 8);
  write("typo.json", R"({"strokes": [{"clip": "boll", "points": [[0.6, 0.4]]}]})");
  const Outcome typo = luminist("carry ball.obj --paint typo.json --to-frame 1 -o there.json");
  expect_error(typo, 3);
  EXPECT_NE(typo.err.find("typo.json"), std::string::npos) << typo.err;
  EXPECT_FALSE(exists("there.json"));
  expect_error(luminist("carry ball.obj --paint light.json --to-frame 1 -o there.png"), 2);
  EXPECT_FALSE(exists("there.png"));
}

}  // namespace
}  // namespace luminist
