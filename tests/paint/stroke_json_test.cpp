#include <gtest/gtest.h>

#include <ostream>
#include <random>

#include "base/files.h"
#include "base/image.h"
#include "paint/stroke.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

bool same_brush(const Brush& a, const Brush& b) {
  bool same = true;
  for (const BrushQuality& quality : brush_qualities()) {
    std::visit([&](auto member) { same = same && a.*member == b.*member; }, quality.member);
  }
  return same;
}

TEST(StrokeFile, WrittenByHandIsRead) {
  LUM_ASSERT_OK(const StrokeFile file, parse_strokes(R"({
    "nu": 0.2,
    "brushes": {"warm": {"color": "#ff8000", "diameter": 0.2, "gradient": 1}},
    "strokes": [
      {"brush": "warm", "opacity": 0.8, "clip": "@", "points": [[0.5, 0.4], [0.6, 0.45, 0.7]]},
      {"tool": "brighten", "strength": 1, "bucket": true, "clip": "jug"},
      {"brush": "warm", "peak": "specular", "repeat_peak": true, "add_light": true, "points": [[1, 0]]}
    ]})",
                                                     "paint.json"));
  EXPECT_FLOAT_EQ(file.nu, 0.2F);
  EXPECT_FLOAT_EQ(file.delta, StrokeFile().delta);
  ASSERT_EQ(file.strokes.size(), 3U);
  const Stroke& first = file.strokes[0];
  EXPECT_FLOAT_EQ(first.brush.color.x, 1.0F);
  EXPECT_FLOAT_EQ(first.brush.color.y, linear_from_srgb(128.0F / 255.0F));
  EXPECT_FLOAT_EQ(first.brush.diameter, 0.2F);
  EXPECT_FLOAT_EQ(first.brush.opacity, 0.8F);
  EXPECT_EQ(first.brush.clip, "@");
  ASSERT_EQ(first.points.size(), 2U);
  EXPECT_FLOAT_EQ(first.points[0].pressure, 1.0F);
  EXPECT_FLOAT_EQ(first.points[1].pressure, 0.7F);
  EXPECT_EQ(file.strokes[1].brush.tool, PaintTool::kBrighten);
  EXPECT_TRUE(file.strokes[1].brush.bucket);
  EXPECT_EQ(file.strokes[2].brush.peak, PeakKind::kSpecular);
  EXPECT_FLOAT_EQ(file.strokes[2].brush.gradient, 1.0F);
}

TEST(StrokeFile, InPixelsOfAPictureIsReadAsPictureHeights) {
  LUM_ASSERT_OK(const StrokeFile file, parse_strokes(R"({"units": "pixels", "height": 500,
      "strokes": [{"diameter": 50, "points": [[250, 100, 0.5]]}]})",
                                                     "paint.json"));
  EXPECT_FLOAT_EQ(file.strokes[0].brush.diameter, 0.1F);
  EXPECT_FLOAT_EQ(file.strokes[0].points[0].x, 0.5F);
  EXPECT_FLOAT_EQ(file.strokes[0].points[0].y, 0.2F);
  EXPECT_FLOAT_EQ(file.strokes[0].points[0].pressure, 0.5F);
}

TEST(StrokeFile, WithoutStrokesInItsListIsEmpty) {
  LUM_ASSERT_OK(const StrokeFile file, parse_strokes(R"({"strokes": []})", "paint.json"));
  EXPECT_TRUE(file.strokes.empty());
}

TEST(StrokeFile, RoundTripsBitByBit) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> in(0.001F, 1.0F);
  StrokeFile file;
  file.nu = in(random);
  file.delta = in(random);
  for (int i = 0; i < 200; ++i) {
    Stroke stroke;
    Brush& b = stroke.brush;
    b.tool = static_cast<PaintTool>(i % 8);
    b.color = {100.0F * in(random), in(random), 1e-6F * in(random)};
    b.diameter = in(random);
    b.opacity = in(random);
    b.texture = in(random);
    b.gradient = in(random);
    b.peak = static_cast<PeakKind>(i % 2);
    b.repeat_peak = i % 3 == 0;
    b.screen_gradient = i % 5 == 0;
    b.add_light = i % 4 == 0;
    b.bucket = i % 7 == 0;
    b.strength = in(random);
    b.importance = in(random);
    b.clip = "a \"quoted\" \\ name\n\xc3\xa9";
    b.copy_from = "edited.png";
    for (int k = 0; k <= i % 4; ++k) stroke.points.push_back({in(random)-0.5F, in(random), in(random)});
    file.strokes.push_back(stroke);
  }
  LUM_ASSERT_OK(const StrokeFile again, parse_strokes(strokes_to_json(file), "again.json"));
  EXPECT_EQ(again.nu, file.nu);
  EXPECT_EQ(again.delta, file.delta);
  ASSERT_EQ(again.strokes.size(), file.strokes.size());
  for (std::size_t i = 0; i < file.strokes.size(); ++i) {
    EXPECT_TRUE(same_brush(again.strokes[i].brush, file.strokes[i].brush)) << i;
    ASSERT_EQ(again.strokes[i].points.size(), file.strokes[i].points.size());
    for (std::size_t k = 0; k < file.strokes[i].points.size(); ++k) {
      EXPECT_EQ(again.strokes[i].points[k].x, file.strokes[i].points[k].x);
      EXPECT_EQ(again.strokes[i].points[k].y, file.strokes[i].points[k].y);
      EXPECT_EQ(again.strokes[i].points[k].pressure, file.strokes[i].points[k].pressure);
    }
  }
  EXPECT_EQ(strokes_to_json(again), strokes_to_json(file));
}

TEST(StrokeFile, WritesOnlyWhatDiffersFromTheDefaults) {
  StrokeFile file;
  file.strokes.push_back({Brush(), {{0.5F, 0.25F, 1.0F}}});
  file.strokes[0].brush.opacity = 0.1F;
  EXPECT_EQ(strokes_to_json(file),
            "{\n  \"nu\": 0.1,\n  \"delta\": 0.5,\n  \"strokes\": [\n"
            "    {\"opacity\": 0.1, \"points\": [[0.5, 0.25]]}\n  ]\n}\n");
}

TEST(StrokeReference, NamesEveryQualityWithItsDefaultAndRange) {
  const std::string table = stroke_reference();
  for (const BrushQuality& quality : brush_qualities()) {
    EXPECT_NE(table.find(std::string("| ") + quality.name + " |"), std::string::npos) << quality.name;
  }
  EXPECT_NE(table.find("| diameter | 0.1 | 1e-05 to 100 picture heights |"), std::string::npos) << table;
  EXPECT_NE(table.find("| peak | \"diffuse\" | diffuse, specular |"), std::string::npos) << table;
}

TEST(StrokeFile, ThatIsNotThereIsMissing) {
  EXPECT_EQ(error_of(load_strokes("/nowhere/paint.json")).kind, ErrorKind::kMissing);
}

TEST(StrokeFile, IsLoadedFromAFile) {
  TemporaryFolder folder;
  LUM_EXPECT_OK(write_file_atomic(folder.file("paint.json"), R"({"strokes": [{"points": [[0, 0]]}]})"));
  LUM_ASSERT_OK(const StrokeFile file, load_strokes(folder.file("paint.json")));
  EXPECT_EQ(file.strokes.size(), 1U);
}

/// One mistake, where it must be reported and what must be said of it.
struct Mistake {
  const char* json;
  const char* where;  ///< line:column
  const char* field;
  const char* says;  ///< found in the message
  friend std::ostream& operator<<(std::ostream& out, const Mistake& mistake) { return out << mistake.json; }
};

class StrokeFileMistake : public ::testing::TestWithParam<Mistake> {};

TEST_P(StrokeFileMistake, IsReportedAtItsPlace) {
  const Mistake& mistake = GetParam();
  const Error error = error_of(parse_strokes(mistake.json, "p.json"));
  EXPECT_EQ(error.kind, ErrorKind::kBadContent);
  EXPECT_EQ(error.where, std::string("p.json:") + mistake.where) << error.message();
  EXPECT_EQ(error.field, mistake.field) << error.message();
  EXPECT_NE(error.message().find(mistake.says), std::string::npos) << error.message();
}

INSTANTIATE_TEST_SUITE_P(
    All, StrokeFileMistake,
    ::testing::Values(
        Mistake{"", "1:1", "", "unexpected end of input"},
        Mistake{"{\n  \"strokes\": [,]}", "2:15", "", "unexpected ','"},
        Mistake{"{\"strokes\": [{\"points\": [[0, 1e999]]}]}", "1:34", "", "number overflow"},
        Mistake{"[]", "1:1", "", "an object is expected"}, Mistake{"{}", "1:1", "strokes", "there are no strokes"},
        Mistake{"{\"strokes\": 3}", "1:13", "strokes", "a list of strokes is expected"},
        Mistake{"{\"strokes\": [],\n \"stroks\": []}", "2:2", "stroks", "did you mean \"strokes\"?"},
        Mistake{"{\"nu\": 2, \"strokes\": []}", "1:8", "nu", "from 0 to 1"},
        Mistake{"{\"delta\": \"a\", \"strokes\": []}", "1:11", "delta", "a number is expected"},
        Mistake{"{\"units\": \"pixel\", \"strokes\": []}", "1:11", "units", "did you mean \"pixels\"?"},
        Mistake{"{\"units\": \"pixels\", \"strokes\": []}", "1:11", "units", "add \"height\""},
        Mistake{"{\"units\": \"pixels\", \"height\": 0, \"strokes\": []}", "1:31", "height", "from 1 to 65536"},
        Mistake{"{\"height\": 5, \"strokes\": []}", "1:2", "height", "only needed with pixels"},
        Mistake{"{\"nu\": 0, \"nu\": 0, \"strokes\": []}", "1:11", "", "twice"},
        Mistake{"{\"strokes\": [\n {\"diametr\": 1}]}", "2:3", "strokes[0].diametr", "did you mean \"diameter\"?"},
        Mistake{"{\"strokes\": [\n {\"diameter\": -1}]}", "2:15", "strokes[0].diameter", "picture heights"},
        Mistake{"{\"strokes\": [{\"opacity\": 1.5}]}", "1:26", "strokes[0].opacity", "from 0 to 1"},
        Mistake{"{\"strokes\": [{\"bucket\": 1}]}", "1:25", "strokes[0].bucket", "true or false"},
        Mistake{"{\"strokes\": [{\"tool\": \"brigten\"}]}", "1:23", "strokes[0].tool", "did you mean \"brighten\"?"},
        Mistake{"{\"strokes\": [{\"peak\": \"x\"}]}", "1:23", "strokes[0].peak", "one of diffuse, specular"},
        Mistake{"{\"strokes\": [{\"color\": [1, 2]}]}", "1:24", "strokes[0].color", "[r, g, b]"},
        Mistake{"{\"strokes\": [{\"color\": [1, 2, -3]}]}", "1:24", "strokes[0].color", "from 0 to"},
        Mistake{"{\"strokes\": [{\"color\": \"#12345g\"}]}", "1:24", "strokes[0].color", "#rrggbb"},
        Mistake{"{\"strokes\": [{\"clip\": null}]}", "1:23", "strokes[0].clip", "a text is expected"},
        Mistake{"{\"strokes\": [{}]}", "1:14", "strokes[0].points", "no points"},
        Mistake{"{\"strokes\": [{\"points\": []}]}", "1:25", "strokes[0].points", "no points"},
        Mistake{"{\"strokes\": [{\"points\": [[0, 0],\n  [1]]}]}", "2:3", "strokes[0].points[1]", "[x, y]"},
        Mistake{"{\"strokes\": [{\"points\": [[0, 0], [1e30, 0]]}]}", "1:34", "strokes[0].points[1]", "nowhere near"},
        Mistake{"{\"strokes\": [{\"points\": [[0, 0, 2]]}]}", "1:26", "strokes[0].points[0]", "pressure"},
        Mistake{"{\"strokes\": [{\"tool\": \"copy\", \"points\": [[0, 0]]}]}", "1:14", "strokes[0].copy_from",
                "needs an image"},
        Mistake{"{\"strokes\": [{\"brush\": \"warm\"}]}", "1:24", "strokes[0].brush", "describe it in \"brushes\""},
        Mistake{"{\"brushes\": {\"warm\": {}}, \"strokes\": [{\"brush\": \"warn\"}]}", "1:49", "strokes[0].brush",
                "did you mean \"warm\"?"},
        Mistake{"{\"brushes\": {\"warm\": {\"points\": []}}, \"strokes\": []}", "1:23", "brushes.warm.points",
                "unknown key"},
        Mistake{"{\"\xc3\xa9\": 1, \"strokes\": [3]}", "1:2", "\xc3\xa9", "unknown key"},
        Mistake{"{\"strokes\": [ \"\xc3\xa9\", 3]}", "1:15", "strokes[0]", "an object is expected"}));

TEST(StrokeFile, OfEndlessBracketsIsRefused) {
  const Error error = error_of(parse_strokes(std::string(100000, '['), "p.json"));
  EXPECT_EQ(error.kind, ErrorKind::kBadContent);
  EXPECT_EQ(error.where, "p.json:1:32");
}

TEST(StrokeFile, SurvivesEveryPrefixAndEveryChangedByte) {
  const std::string text = R"({"units": "pixels", "height": 8, "brushes": {"a": {"color": "#102030"}},
    "strokes": [{"brush": "a", "points": [[1, 2, 0.5], [-3e1, 4]]}, {"tool": "erase", "bucket": true}]})";
  for (std::size_t end = 0; end < text.size(); ++end) EXPECT_FALSE(parse_strokes(text.substr(0, end), "p.json")) << end;
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (const char c : {'"', '{', ']', '\0', '\\', '9', ' ', '\xff'}) {
      std::string changed = text;
      changed[i] = c;
      if (const auto file = parse_strokes(changed, "p.json")) {
        for (const Stroke& stroke : file.value().strokes) LUM_EXPECT_OK(check_stroke(stroke));
      }
    }
  }
}

}  // namespace
}  // namespace luminist
