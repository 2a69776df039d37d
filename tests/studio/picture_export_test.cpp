#include "studio/picture_export.h"

#include "image_io/image_io.h"
#include "studio/script.h"
#include "studio/session_fixture.h"

namespace luminist {
namespace {

class PictureExportTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    LUM_EXPECT_OK(session_->add_light({.name = "key", .from_paint = false}));
    LUM_EXPECT_OK(session_->add_light({.name = "fill", .from_paint = false}));
    LUM_EXPECT_OK(session_->set({"lights/fill/color=0.1,0.2,0.4"}));
  }
  [[nodiscard]] bool there(const std::string& name) const { return std::filesystem::exists(out_ / name); }
  std::filesystem::path out_ = folder_.path() / "out";
};

TEST_F(PictureExportTest, WritesWhatIsChosenAndNothingElse) {
  PictureChoice choice;
  choice.paint = false;
  choice.residual = true;
  choice.rig = false;
  LUM_ASSERT_OK(const auto files, export_pictures(*session_, choice, out_));
  EXPECT_EQ(files.size(), 2U);
  EXPECT_TRUE(there("picture.png") && there("residual.png"));
  EXPECT_FALSE(there("picture.exr") || there("target.png") || there("rig.toml") || there("sheet.png"));
}

TEST_F(PictureExportTest, LightsAloneAddUpToThePicture) {
  PictureChoice choice;
  choice.paint = choice.png = choice.rig = false;
  choice.exr = choice.each_light = true;
  LUM_EXPECT_OK(export_pictures(*session_, choice, out_));
  const auto read = [&](const std::string& name) { return read_image((out_ / name).string()); };
  LUM_ASSERT_OK(const Image whole, read("picture.exr"));
  LUM_ASSERT_OK(const Image key, read("light_key.exr"));
  LUM_ASSERT_OK(const Image fill, read("light_fill.exr"));
  LUM_ASSERT_OK(const Image none, read("no_lights.exr"));
  for (std::size_t i = 0; i < whole.data.size(); ++i) {
    // Each has what is there without lights; files hold 11 bits of a number.
    EXPECT_NEAR(key.data[i] + fill.data[i] - none.data[i], whole.data[i], 3e-3F * (1.0F + whole.data[i]));
  }
}

TEST_F(PictureExportTest, ASheetShowsAllOfThem) {
  PictureChoice choice;
  choice.png = choice.rig = false;
  choice.sheet = choice.each_light = true;  // light, paint, key, fill, none: two rows
  LUM_ASSERT_OK(const auto files, export_pictures(*session_, choice, out_));
  ASSERT_EQ(files.size(), 1U);
  LUM_ASSERT_OK(const Image sheet, read_image(files.front().string()));
  EXPECT_GT(sheet.width, 3 * 400);
  EXPECT_GT(sheet.height, 2 * 300);
}

TEST_F(PictureExportTest, TellsHowFarItIsAndStopsWhenItIsTold) {
  PictureChoice choice;
  choice.each_light = true;
  int told = 0;
  const auto stopped = export_pictures(*session_, choice, out_, [&](const std::string&, int done, int all) {
    EXPECT_EQ(done, told++);
    EXPECT_EQ(all, 5);
    return done < 2;
  });
  EXPECT_EQ(error_of(stopped).kind, ErrorKind::kCancelled);
  EXPECT_EQ(told, 3);
  EXPECT_TRUE(there("picture.png"));
  EXPECT_FALSE(there("no_lights.png"));
}

TEST_F(PictureExportTest, NothingChosenIsAnError) {
  PictureChoice choice;
  choice.png = choice.rig = false;
  EXPECT_EQ(error_of(export_pictures(*session_, choice, out_)).kind, ErrorKind::kNothingToDo);
}

TEST_F(PictureExportTest, AScriptChoosesToo) {
  std::ofstream(folder_.file("export.jsonl")) << R"({"do": "open", "scene": "ball.obj", "size": [16, 12]}
{"do": "export_pictures", "to": "out", "pictures": ["importance"], "formats": ["exr"], "rig": false}
)";
  LUM_EXPECT_OK(run_script(*device_, roots_, folder_.file("export.jsonl"), folder_.path(), {}, diagnostics_));
  EXPECT_TRUE(there("importance.exr"));
  EXPECT_FALSE(there("picture.exr") || there("importance.png") || there("rig.toml"));
  std::ofstream(folder_.file("wrong.jsonl")) << R"({"do": "open", "scene": "ball.obj", "size": [16, 12]}
{"do": "export_pictures", "to": "out", "pictures": ["lights"]}
)";
  EXPECT_EQ(error_of(run_script(*device_, roots_, folder_.file("wrong.jsonl"), folder_.path(), {}, diagnostics_)).field,
            "pictures");
}

}  // namespace
}  // namespace luminist
