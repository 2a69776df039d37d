// Images made byte by byte: unusual ones, and those that lie, break off or kill the helper.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>
#include <thread>

#include "base/files.h"
#include "image_io/image_io.h"
#include "image_io/packet.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

void append_big_endian(std::string& to, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) to += static_cast<char>(value >> static_cast<unsigned>(shift));
}

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

std::string chunk(const std::string& type, const std::string& data) {
  std::string result;
  append_big_endian(result, static_cast<std::uint32_t>(data.size()));
  result += type + data;
  append_big_endian(result, crc32(type + data));
  return result;
}

/// One grey pixel of 16 bits.
std::string deep_png(std::uint16_t value) {
  const std::string row{0, static_cast<char>(value >> 8U), static_cast<char>(value & 0xffU)};  // filter, high, low
  std::uint32_t a = 1, b = 0;                                                                  // Adler-32
  for (const char c : row) a = (a + static_cast<unsigned char>(c)) % 65521, b = (b + a) % 65521;
  std::string zlib("\x78\x01\x01\x03\x00\xfc\xff", 7);  // one stored block of three bytes
  zlib += row;
  append_big_endian(zlib, (b << 16U) | a);
  std::string header;
  append_big_endian(header, 1);
  append_big_endian(header, 1);
  header += std::string{16, 0, 0, 0, 0};
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", zlib) + chunk("IEND", "");
}

/// A well-formed PNG that declares a size and holds next to nothing.
std::string declared_png(std::uint32_t width, std::uint32_t height, char color_type) {
  std::string header;
  append_big_endian(header, width);
  append_big_endian(header, height);
  header += std::string{8, color_type, 0, 0, 0};
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) +
         chunk("IDAT", std::string("\x78\x9c\x03\x00\x00\x00\x00\x01", 8)) + chunk("IEND", "");
}

std::string small_exr() {
  const TemporaryFolder folder;
  EXPECT_TRUE(write_image(folder.file("a.exr"), Image(4, 3, 3, 0.5F)));
  return *read_file(folder.file("a.exr"));
}

/// Replaces the four numbers of a box2i attribute.
std::string with_box(std::string exr, const std::string& attribute, std::array<std::int32_t, 4> box) {
  const std::size_t at = exr.find(attribute + std::string("\0box2i\0", 7));
  EXPECT_NE(at, std::string::npos);
  std::memcpy(exr.data() + at + attribute.size() + 7 + 4, box.data(), sizeof(box));
  return exr;
}

std::vector<ErrorKind> kinds_of(const std::vector<std::string>& files) {
  std::vector<ImageSource> sources;
  for (const std::string& file : files) sources.push_back({"hostile", file, Encoding::kAuto});
  std::vector<ErrorKind> kinds;
  for (const Result<Image>& result : read_images(sources)) kinds.push_back(error_of(result).kind);
  return kinds;
}

TEST(HostileImage, IsRefusedFromItsHeaderWhenItDeclaresTooMuch) {
  const std::vector<std::string> files{
      declared_png(40'000, 10, 2),      // a side
      declared_png(30'000, 30'000, 6),  // values
      declared_png(8'000, 8'000, 0),    // nothing can be so empty
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 100000\n",
  };
  EXPECT_EQ(kinds_of(files), std::vector<ErrorKind>(files.size(), ErrorKind::kLimit));
}

TEST(HostileImage, MayNotDeclareASenselessSize) {
  const std::string exr = small_exr();
  std::vector<std::string> files{declared_png(0x7fffffff, 0x7fffffff, 6), declared_png(0, 5, 2)};
  for (const char* window : {"dataWindow", "displayWindow"}) {
    files.push_back(with_box(exr, window, {0, 0, 2'000'000, 2'000'000}));
    files.push_back(with_box(exr, window, {-2'000'000'000, 0, 2'000'000'000, 3}));
    files.push_back(with_box(exr, window, {5, 5, 1, 1}));
  }
  for (const ErrorKind kind : kinds_of(files)) {
    EXPECT_TRUE(kind == ErrorKind::kLimit || kind == ErrorKind::kBadContent) << static_cast<int>(kind);
  }
}

TEST(DeepImage, KeepsItsSixteenBits) {
  const std::string png = deep_png(0x1234);
  LUM_ASSERT_OK(const Image image, decode_image(png, "deep", Encoding::kLinear));
  EXPECT_FLOAT_EQ(image.data[0], 0x1234 / 65535.0F);
}

TEST(ExrImage, IsLaidIntoItsDisplayWindow) {
  const std::string exr = with_box(small_exr(), "displayWindow", {-1, -2, 5, 1});
  LUM_ASSERT_OK(const Image image, decode_image(exr, "window", Encoding::kAuto));
  EXPECT_EQ(image.width, 7);
  EXPECT_EQ(image.height, 4);
  EXPECT_EQ(image.at(0, 2, 0), 0.0F);
  EXPECT_EQ(image.at(1, 2, 0), 0.5F);
  EXPECT_EQ(image.at(4, 3, 2), 0.5F);
  EXPECT_EQ(image.at(5, 3, 2), 0.0F);
  EXPECT_EQ(image.at(1, 1, 0), 0.0F);
}

TEST(HostileImage, ThatIsNoImageIsBadContent) {
  const std::vector<std::string> files{"x",   "hello world, I am a text", "\x89PNG\r\n\x1a\n", "GIF89a",
                                       "II*", std::string(1000, '\0')};
  EXPECT_EQ(kinds_of(files), std::vector<ErrorKind>(files.size(), ErrorKind::kBadContent));
  EXPECT_EQ(error_of(decode_image("", "empty", Encoding::kAuto)).kind, ErrorKind::kBadContent);
}

/// Every source must come back as an image or as one of the errors that files may cause.
void expect_survival(const std::vector<std::string>& files) {
  std::vector<ImageSource> sources;
  for (const std::string& file : files) sources.push_back({"mutant", file, Encoding::kAuto});
  std::size_t broken = 0;
  for (const Result<Image>& result : read_images(sources)) {
    if (result) continue;
    ++broken;
    const ErrorKind kind = result.error().kind;
    EXPECT_TRUE(kind == ErrorKind::kBadContent || kind == ErrorKind::kLimit || kind == ErrorKind::kChild)
        << result.error().message();
    EXPECT_EQ(result.error().where, "mutant");
  }
  EXPECT_GT(broken, files.size() / 4);
}

TEST(HostileImage, MayBreakOffAnywhere) {
  Image image(9, 7, 3);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = static_cast<float>(i % 13) / 13.0F;
  LUM_ASSERT_OK(const std::string png, encode_png(image, Encoding::kSrgb));
  for (const std::string& whole : {png, small_exr()}) {
    std::vector<std::string> prefixes;
    for (std::size_t size = 1; size < whole.size(); ++size) prefixes.push_back(whole.substr(0, size));
    expect_survival(prefixes);
  }
}

TEST(HostileImage, MayHaveAnyBytesChanged) {
  Image image(9, 7, 3, 0.25F);
  LUM_ASSERT_OK(const std::string png, encode_png(image, Encoding::kSrgb));
  std::mt19937 random(20'240);
  for (const std::string& whole : {png, small_exr()}) {
    std::vector<std::string> mutants;
    for (int i = 0; i < 200; ++i) {
      std::string mutant = whole;
      for (int n = 0; n < 1 + i % 4; ++n) mutant[random() % mutant.size()] = static_cast<char>(random());
      mutants.push_back(std::move(mutant));
    }
    expect_survival(mutants);
  }
}

std::string real_helper() {
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "luminist-image").string();
}

/// Puts another program in the helper's place while it lives.
class FakeHelper {
 public:
  explicit FakeHelper(const std::string& script) {
    EXPECT_TRUE(write_file_atomic(folder_.file("helper"), "#!/bin/sh\n" + script));
    EXPECT_EQ(::chmod(folder_.file("helper").c_str(), 0700), 0);
    ::setenv("LUMINIST_IMAGE_HELPER", folder_.file("helper").c_str(), 1);
  }
  ~FakeHelper() { ::unsetenv("LUMINIST_IMAGE_HELPER"); }
  FakeHelper(const FakeHelper&) = delete;
  FakeHelper& operator=(const FakeHelper&) = delete;

 private:
  TemporaryFolder folder_;
};

TEST(HostileImage, ThatKillsTheHelperIsNamed) {
  const FakeHelper helper("kill -SEGV $$\n");
  const Error error = error_of(decode_image("anything", "killer.png", Encoding::kAuto));
  EXPECT_EQ(error.kind, ErrorKind::kChild);
  EXPECT_EQ(error.where, "killer.png");
  EXPECT_NE(error.what.find("signal 11"), std::string::npos) << error.what;
  EXPECT_EQ(error_of(encode_png(Image(2, 2, 3), Encoding::kSrgb)).kind, ErrorKind::kChild);
}

TEST(HostileImage, ThatKillsTheHelperDoesNotSpoilTheOthers) {
  const TemporaryFolder folder;
  LUM_ASSERT_OK(const std::string png, encode_png(Image(3, 2, 3, 1.0F), Encoding::kSrgb));
  const std::string real = real_helper();
  const std::string mark = folder.file("died");
  const FakeHelper helper("[ -e '" + mark + "' ] && exec '" + real + "' \"$@\"\ntouch '" + mark + "'\nexit 9\n");
  const std::vector<ImageSource> sources{{"killer", png, Encoding::kAuto}, {"fine", png, Encoding::kAuto}};
  const std::vector<Result<Image>> results = read_images(sources);
  EXPECT_EQ(error_of(results[0]).kind, ErrorKind::kChild);
  ASSERT_TRUE(results[1]);
  EXPECT_EQ(results[1]->width, 3);
}

TEST(HostileImage, MayTakeOverTheHelperButNotItsMaster) {
  const FakeHelper helper("head -c 100000 /dev/urandom\n");
  EXPECT_EQ(error_of(decode_image("anything", "evil.png", Encoding::kAuto)).kind, ErrorKind::kChild);
}

TEST(HostileImage, MayTakeOverARunButNotTheNext) {
  const TemporaryFolder folder;
  LUM_ASSERT_OK(const std::string png, encode_png(Image(3, 2, 3, 1.0F), Encoding::kSrgb));
  const std::string real = real_helper();
  const std::string go = folder.file("go"), said = folder.file("said"), lie = folder.file("lie");
  PacketHeader forged;
  forged.width = forged.height = forged.channels = 1;
  forged.sample = Sample::kByte;
  forged.data_size = 1;
  LUM_EXPECT_OK(write_file_atomic(lie, std::string(reinterpret_cast<const char*>(&forged), sizeof(forged)) + "x"));
  // Something of the first run stays behind and answers between it and the next.
  const FakeHelper helper("[ -e '" + go + "' ] || ( while [ ! -e '" + go + "' ]; do sleep 0.02; done; " + "cat '" +
                          lie + "'; touch '" + said + "' ) &\nexec '" + real + "' \"$@\"\n");
  LUM_ASSERT_OK(const Image first, decode_image(png, "first.png", Encoding::kAuto));
  EXPECT_EQ(first.width, 3);
  std::ofstream(go) << "go";
  for (int i = 0; i < 1000 && !std::filesystem::exists(said); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ASSERT_TRUE(std::filesystem::exists(said));
  LUM_ASSERT_OK(const Image second, decode_image(png, "second.png", Encoding::kAuto));
  EXPECT_EQ(second.width, 3);
}

TEST(ImageHelper, IsStartedOnceAndAgainIfItIsGone) {
  const TemporaryFolder folder;
  const std::string real = real_helper();
  const std::string starts = folder.file("starts");
  const FakeHelper helper("echo $$ >> '" + starts + "'\nexec '" + real + "' \"$@\"\n");
  for (int i = 0; i < 3; ++i) {
    LUM_ASSERT_OK(const std::string png, encode_png(Image(3, 2, 3, 1.0F), Encoding::kSrgb));
    LUM_EXPECT_OK(decode_image(png, "a.png", Encoding::kAuto));
  }
  std::vector<pid_t> ids;
  std::ifstream lines(starts);
  for (pid_t id = 0; lines >> id;) ids.push_back(id);
  ASSERT_EQ(ids.size(), 1U);
  EXPECT_EQ(::kill(ids[0], SIGKILL), 0);
  LUM_EXPECT_OK(encode_png(Image(3, 2, 3, 1.0F), Encoding::kSrgb));
}

TEST(HostileImage, NeedsAHelperToBeRead) {
  ::setenv("LUMINIST_IMAGE_HELPER", "/no/such/helper", 1);
  const Error error = error_of(decode_image("anything", "a.png", Encoding::kAuto));
  ::unsetenv("LUMINIST_IMAGE_HELPER");
  EXPECT_EQ(error.kind, ErrorKind::kChild);
}

}  // namespace
}  // namespace luminist
