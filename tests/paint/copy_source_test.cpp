#include "paint/copy_source.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/files.h"
#include "paint/ball.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

class CopySource : public ::testing::Test {
 protected:
  void SetUp() override { LUM_EXPECT_OK(write_file_atomic(folder_.file("edited.exr"), "not read by these tests")); }
  [[nodiscard]] Result<Image> load(const std::string& reference, int width, int height) {
    return load_copy_source(reference, folder_.path().string(), width, height,
                            [this](const std::string& /*path*/) -> Result<Image> { return image_; });
  }
  TemporaryFolder folder_;
  Image image_ = varied_picture(120, 100);
};

TEST_F(CopySource, OfThePicturesSizeIsTakenAsItIs) {
  LUM_ASSERT_OK(const Image image, load("edited.exr", 120, 100));
  EXPECT_EQ(image.data, image_.data);
}

TEST_F(CopySource, OfTheSameAspectIsResized) {
  image_ = Image(120, 100, 3, 0.25F);
  for (const auto& [width, height] : {std::pair{60, 50}, {240, 200}, {61, 50}}) {  // the last one is rounded
    LUM_ASSERT_OK(const Image image, load("edited.exr", width, height));
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    EXPECT_NEAR(image.at(30, 30, 1), 0.25F, 1e-6F);
  }
}

TEST_F(CopySource, OfAnotherAspectIsRefused) {
  const Error error = error_of(load("edited.exr", 100, 100));
  EXPECT_EQ(error.kind, ErrorKind::kBadContent);
  EXPECT_EQ(error.field, "copy_from");
  EXPECT_NE(error.what.find("120 x 100"), std::string::npos) << error.what;
}

TEST_F(CopySource, ThatIsNotFiniteIsRefusedWithThePixel) {
  image_.at(7, 3, 1) = std::nanf("");
  const Error error = error_of(load("edited.exr", 120, 100));
  EXPECT_EQ(error.kind, ErrorKind::kBadContent);
  EXPECT_NE(error.what.find("(7, 3)"), std::string::npos) << error.what;
}

TEST_F(CopySource, OutsideTheStrokeFilesFolderIsRefused) {
  EXPECT_EQ(error_of(load("../edited.exr", 120, 100)).kind, ErrorKind::kBadContent);
  EXPECT_EQ(error_of(load("/etc/hostname", 120, 100)).kind, ErrorKind::kBadContent);
}

TEST_F(CopySource, ThatIsNotThereIsMissing) {
  const Error error = error_of(load("other.exr", 120, 100));
  EXPECT_EQ(error.kind, ErrorKind::kMissing);
  EXPECT_EQ(error.field, "copy_from");
}

TEST(SourcePixel, ReadsGreyColourAndAlpha) {
  Image image(1, 1, 4);
  image.data = {0.1F, 0.2F, 0.3F, 0.5F};
  EXPECT_EQ(source_pixel(image, 0), Vec4(0.1F, 0.2F, 0.3F, 0.5F));
  image.channels = 3;
  EXPECT_EQ(source_pixel(image, 0), Vec4(0.1F, 0.2F, 0.3F, 1.0F));
  image.channels = 2;
  EXPECT_EQ(source_pixel(image, 0), Vec4(0.1F, 0.1F, 0.1F, 0.2F));
  image.channels = 1;
  EXPECT_EQ(source_pixel(image, 0), Vec4(0.1F, 0.1F, 0.1F, 1.0F));
}

TEST_F(CopySource, IsWhatTheCopyToolPaints) {
  const SurfaceBuffer surface = ball_surface(120, 100);
  Canvas canvas(surface, Image(120, 100, 3), nullptr,
                [this](const std::string& /*path*/) -> Result<Image> { return image_; });
  Brush brush;
  brush.tool = PaintTool::kCopy;
  brush.copy_from = "edited.exr";
  brush.bucket = true;
  brush.opacity = 0.5F;
  LUM_EXPECT_OK(canvas.apply({brush, {}}, folder_.path().string()));
  for (std::size_t i = 0; i < image_.data.size(); ++i) {
    ASSERT_FLOAT_EQ(canvas.target().color.data[i], 0.5F * image_.data[i]);
  }
}

TEST_F(CopySource, TransparentPixelsPaintNothing) {
  image_ = Image(120, 100, 4, 0.0F);
  const SurfaceBuffer surface = ball_surface(120, 100);
  const Image picture = varied_picture(120, 100);
  Canvas canvas(surface, picture, nullptr, [this](const std::string& /*path*/) -> Result<Image> { return image_; });
  Brush brush;
  brush.tool = PaintTool::kCopy;
  brush.copy_from = "edited.exr";
  brush.bucket = true;
  LUM_EXPECT_OK(canvas.apply({brush, {}}, folder_.path().string()));
  EXPECT_EQ(canvas.target().color.data, picture.data);
  EXPECT_FALSE(canvas.painted());
}

}  // namespace
}  // namespace luminist
