#include "base/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "support/fixtures.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

TEST(WriteFileAtomic, ReplacesTheWholeFileAndLeavesNoTemporary) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a file with spaces.txt");
  LUM_EXPECT_OK(write_file_atomic(path, "old"));
  LUM_EXPECT_OK(write_file_atomic(path, "new content"));
  LUM_ASSERT_OK(const std::string bytes, read_file(path));
  EXPECT_EQ(bytes, "new content");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(WriteFileAtomic, SaysWhyItCannotAndKeepsTheOldFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(error_of(write_file_atomic(folder.file("missing/x"), "a")).kind, ErrorKind::kUnwritable);
  fs::create_directory(folder.path() / "taken");
  EXPECT_EQ(error_of(write_file_atomic(folder.file("taken"), "a")).kind, ErrorKind::kUnwritable);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(ReadFile, RefusesWhatIsNotARegularFile) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo(folder.file("fifo").c_str(), 0600), 0);
  EXPECT_EQ(error_of(read_file(folder.file("fifo"))).kind, ErrorKind::kBadContent);
  EXPECT_EQ(error_of(read_file(folder.path())).kind, ErrorKind::kBadContent);
  EXPECT_EQ(error_of(read_file(folder.file("nothing"))).kind, ErrorKind::kMissing);
}

TEST(ResolveBeside, StaysInTheFolder) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("texture.png")) << "x";
  fs::create_directory(folder.path() / "in");
  std::ofstream(folder.file("in/scene.gltf")) << "x";
  std::ofstream(folder.file("in/near.png")) << "x";
  fs::create_symlink(folder.path() / "texture.png", folder.path() / "in" / "link.png");
  const std::string scene = folder.file("in/scene.gltf");
  LUM_EXPECT_OK(resolve_beside(scene, "near.png"));
  for (const char* bad : {"../texture.png", "/etc/passwd", "file:near.png", "link.png", ""}) {
    EXPECT_EQ(error_of(resolve_beside(scene, bad)).kind, ErrorKind::kBadContent) << bad;
  }
  EXPECT_EQ(error_of(resolve_beside(scene, "gone.png")).kind, ErrorKind::kMissing);
}

TEST(NearestName, FindsTyposAndRefusesStrangers) {
  const std::vector<std::string> names{"barn", "color", "shadow_density"};
  EXPECT_EQ(nearest_name("colour", names), "color");
  EXPECT_EQ(nearest_name("shadow_denisty", names), "shadow_density");
  EXPECT_EQ(nearest_name("elephant", names), "");
}

TEST(ContentHash, NamesContent) {
  EXPECT_EQ(content_hash("a"), content_hash("a"));
  EXPECT_NE(content_hash("a"), content_hash("b"));
  EXPECT_EQ(content_hash("").size(), 32U);
}

TEST(Error, ReadsAsOneLine) {
  const Error error{ErrorKind::kBadContent, "a number is missing", "rig.toml:3:5", "barn", "give three"};
  EXPECT_EQ(error.message(), "error[E300] rig.toml:3:5: a number is missing (barn); give three");
}

}  // namespace
}  // namespace luminist
