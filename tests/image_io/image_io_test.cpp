#include "image_io/image_io.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <limits>

#include "base/files.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

Image ramp(int width, int height, int channels) {
  Image image(width, height, channels);
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    image.data[i] = static_cast<float>(i) / static_cast<float>(image.data.size());
  }
  return image;
}

TEST(ImageIo, KeepsHalfFloatsInExr) {
  const TemporaryFolder folder;
  Image image = ramp(17, 9, 3);
  image.at(0, 0, 0) = 1000.0F, image.at(1, 0, 1) = -2.5F;
  LUM_EXPECT_OK(write_image(folder.file("a.exr"), image));
  LUM_ASSERT_OK(const Image back, read_image(folder.file("a.exr")));
  ASSERT_TRUE(back.same_size(image));
  ASSERT_EQ(back.channels, 3);
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    // A half float has 11 significant bits; below 2^-14 it counts in steps of 2^-24.
    EXPECT_NEAR(back.data[i], image.data[i], std::abs(image.data[i]) / 2048.0F + 6e-8F);
  }
}

TEST(ImageIo, KeepsFiniteValuesFiniteAndNaNVisibleInExr) {
  const TemporaryFolder folder;
  Image image(2, 1, 3, 1e9F);
  image.at(1, 0, 0) = std::numeric_limits<float>::quiet_NaN();
  LUM_EXPECT_OK(write_image(folder.file("a.exr"), image));
  LUM_ASSERT_OK(const Image back, read_image(folder.file("a.exr")));
  EXPECT_EQ(back.at(0, 0, 0), 65504.0F);  // the largest half
  EXPECT_TRUE(std::isnan(back.at(1, 0, 0)));
}

TEST(ImageIo, StoresPngAsSrgbWithinHalfAStep) {
  const TemporaryFolder folder;
  const Image image = ramp(16, 16, 3);
  LUM_EXPECT_OK(write_image(folder.file("a.png"), image));
  LUM_ASSERT_OK(const Image back, read_image(folder.file("a.png")));
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    EXPECT_NEAR(srgb_from_linear(back.data[i]), srgb_from_linear(image.data[i]), 0.5F / 255.0F + 1e-5F);
  }
}

TEST(ImageIo, ClampsWhatAPngCannotHold) {
  const TemporaryFolder folder;
  Image image(3, 1, 1);
  image.data = {4.0F, -1.0F, std::numeric_limits<float>::quiet_NaN()};
  LUM_EXPECT_OK(write_image(folder.file("a.png"), image));
  LUM_ASSERT_OK(const Image back, read_image(folder.file("a.png")));
  EXPECT_EQ(back.data, (std::vector<float>{1.0F, 0.0F, 0.0F}));
}

TEST(ImageIo, KeepsTheNumberOfChannels) {
  const TemporaryFolder folder;
  std::vector<ImageSource> sources;
  for (const std::string kind : {".png", ".exr"}) {
    for (int channels = 1; channels <= 4; ++channels) {
      sources.push_back({folder.file(std::to_string(channels) + kind), {}, Encoding::kAuto});
      LUM_EXPECT_OK(write_image(sources.back().name, ramp(5, 4, channels)));
    }
  }
  const std::vector<Result<Image>> images = read_images(sources);
  for (std::size_t i = 0; i < images.size(); ++i) {
    ASSERT_TRUE(images[i]) << images[i].error().message();
    EXPECT_EQ(images[i]->channels, static_cast<int>(i % 4) + 1) << sources[i].name;
  }
}

TEST(ImageIo, NeverAppliesATransferCurveToAlpha) {
  Image image(1, 1, 4);
  image.data = {0.5F, 0.5F, 0.5F, 0.5F};
  LUM_ASSERT_OK(const std::string png, encode_png(image, Encoding::kSrgb));
  LUM_ASSERT_OK(const Image color, decode_image(png, "picture", Encoding::kAuto));
  LUM_ASSERT_OK(const Image stored, decode_image(png, "picture", Encoding::kLinear));
  EXPECT_NEAR(color.data[0], 0.5F, 0.005F);     // half an 8-bit step, doubled by the curve's slope here
  EXPECT_NEAR(stored.data[0], 0.735F, 0.003F);  // srgb_from_linear(0.5)
  EXPECT_NEAR(color.data[3], 0.5F, 0.5F / 255.0F + 1e-6F);
  EXPECT_EQ(color.data[3], stored.data[3]);
}

TEST(ImageIo, DoesNotMultiplyColourByAlpha) {
  Image image(1, 1, 4);
  image.data = {1.0F, 0.0F, 1.0F, 0.0F};
  LUM_ASSERT_OK(const std::string png, encode_png(image, Encoding::kSrgb));
  LUM_ASSERT_OK(const Image back, decode_image(png, "picture", Encoding::kSrgb));
  EXPECT_EQ(back.data, image.data);
}

TEST(ImageIo, StoresAttributesAsText) {
  const TemporaryFolder folder;
  const std::map<std::string, std::string> attributes{{"luminist:hash", "0123abcd"}, {"luminist:note", "key and fill"}};
  for (const std::string name : {"a.png", "a.exr"}) {
    LUM_EXPECT_OK(write_image(folder.file(name), ramp(4, 4, 3), attributes));
    LUM_ASSERT_OK(const std::string bytes, read_file(folder.file(name)));
    for (const auto& [key, value] : attributes) {
      EXPECT_NE(bytes.find(key), std::string::npos) << name;
      EXPECT_NE(bytes.find(value), std::string::npos) << name;
    }
  }
}

TEST(ImageIo, WritesTheSamePictureAsTheSameBytes) {
  const TemporaryFolder folder;
  for (const std::string kind : {".png", ".exr"}) {
    LUM_EXPECT_OK(write_image(folder.file("a" + kind), ramp(40, 30, 3)));
    LUM_EXPECT_OK(write_image(folder.file("b" + kind), ramp(40, 30, 3)));
    LUM_ASSERT_OK(const std::string a, read_file(folder.file("a" + kind)));
    LUM_ASSERT_OK(const std::string b, read_file(folder.file("b" + kind)));
    EXPECT_TRUE(a == b) << kind;
  }
}

TEST(ImageIo, ReadsManyImagesAndGivesEachItsOwnResult) {
  const TemporaryFolder folder;
  LUM_EXPECT_OK(write_image(folder.file("first.png"), ramp(3, 2, 3)));
  LUM_ASSERT_OK(const std::string png, encode_png(ramp(7, 5, 1), Encoding::kLinear));
  const std::vector<ImageSource> sources{{folder.file("first.png"), {}, Encoding::kAuto},
                                         {folder.file("missing.png"), {}, Encoding::kAuto},
                                         {"garbage", "these are words", Encoding::kAuto},
                                         {"inside", png, Encoding::kLinear}};
  const std::vector<Result<Image>> results = read_images(sources);
  ASSERT_EQ(results.size(), 4U);
  ASSERT_TRUE(results[0] && results[3]);
  EXPECT_EQ(results[0]->width, 3);
  EXPECT_EQ(error_of(results[1]).kind, ErrorKind::kMissing);
  EXPECT_EQ(error_of(results[2]).kind, ErrorKind::kBadContent);
  EXPECT_EQ(error_of(results[2]).where, "garbage");
  EXPECT_EQ(results[3]->width, 7);
  EXPECT_TRUE(read_images({}).empty());
}

TEST(ImageIo, TakesFileNamesWithSpacesAndForeignLetters) {
  const TemporaryFolder folder;
  const std::string name = folder.file("grüner Apfel, 'zwei' \n 果.png");
  LUM_EXPECT_OK(write_image(name, ramp(4, 4, 3)));
  LUM_EXPECT_OK(read_image(name));
}

TEST(ImageIo, SaysWhenAFileIsMissingOrNoFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(error_of(read_image(folder.file("none.exr"))).kind, ErrorKind::kMissing);
  EXPECT_EQ(error_of(read_image(folder.path().string())).kind, ErrorKind::kBadContent);
  ASSERT_EQ(::mkfifo(folder.file("fifo.png").c_str(), 0600), 0);
  const Error fifo = error_of(read_image(folder.file("fifo.png")));  // and does not wait for a writer
  EXPECT_EQ(fifo.kind, ErrorKind::kBadContent);
  EXPECT_EQ(fifo.where, folder.file("fifo.png"));
}

TEST(ImageIo, RefusesToWriteWhatItCannotAndLeavesTheOldFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(error_of(write_image(folder.file("a.jpg"), ramp(2, 2, 3))).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(write_image(folder.file("a.png"), ramp(2, 2, 5))).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(write_image(folder.file("none/a.png"), ramp(2, 2, 3))).kind, ErrorKind::kUnwritable);
  EXPECT_EQ(error_of(write_image(folder.file("a.exr"), Image())).kind, ErrorKind::kLimit);
  ASSERT_EQ(::mkdir(folder.file("b.exr").c_str(), 0700), 0);
  EXPECT_EQ(error_of(write_image(folder.file("b.exr"), ramp(2, 2, 3))).kind, ErrorKind::kUnwritable);
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++entries;
  EXPECT_EQ(entries, 1U);  // no temporary file stays
}

TEST(ImageIo, WritesManyFilesOfBothKindsAsItWritesOne) {
  const TemporaryFolder folder;
  const Image wide = ramp(6, 3, 3);
  const Image tall = ramp(3, 6, 1);
  const std::vector<ImageFile> files = {{folder.file("a.png"), &wide},
                                        {folder.file("b.exr"), &tall},
                                        {folder.file("c.png"), &tall, {{"note", "kept"}}},
                                        {folder.file("d.exr"), &wide}};
  LUM_EXPECT_OK(write_images(files));
  LUM_EXPECT_OK(write_image(folder.file("one.png"), wide));
  EXPECT_EQ(*read_file(folder.file("a.png")), *read_file(folder.file("one.png")));
  LUM_ASSERT_OK(const Image b, read_image(folder.file("b.exr")));
  LUM_ASSERT_OK(const Image c, read_image(folder.file("c.png")));
  LUM_ASSERT_OK(const Image d, read_image(folder.file("d.exr")));
  EXPECT_EQ(b.height, 6);
  EXPECT_EQ(c.channels, 1);
  EXPECT_EQ(d.width, 6);
}

TEST(ImageIo, WritesNoneOfManyIfOneCannotBe) {
  const TemporaryFolder folder;
  const Image image = ramp(2, 2, 3);
  const std::vector<ImageFile> files = {{folder.file("a.png"), &image}, {folder.file("b.jpg"), &image}};
  EXPECT_EQ(error_of(write_images(files)).kind, ErrorKind::kUsage);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace luminist
