#include "project/tile_store.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/fixtures.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  return files;
}

TEST(TileStore, WritesOneContentOnce) {
  const TemporaryFolder folder;
  TileStore store(folder.path() / "tiles");
  LUM_ASSERT_OK(const std::string first, store.put("paint"));
  LUM_ASSERT_OK(const std::string second, store.put("paint"));
  LUM_ASSERT_OK(const std::string other, store.put("other paint"));
  EXPECT_EQ(first, second);
  EXPECT_NE(first, other);
  EXPECT_EQ(files_below(folder.path()).size(), 2U);
  LUM_EXPECT_OK(store.sync());
  LUM_ASSERT_OK(const std::string bytes, store.get(first));
  EXPECT_EQ(bytes, "paint");
}

TEST(TileStore, NamesADamagedTile) {
  const TemporaryFolder folder;
  TileStore store(folder.path());
  LUM_ASSERT_OK(const std::string name, store.put("paint"));
  std::ofstream(files_below(folder.path()).front()) << "taint";
  EXPECT_EQ(error_of(store.get(name)).kind, ErrorKind::kBadContent);
}

TEST(TileStore, WritesATileAgainThatAPowerCutLeftShort) {
  const TemporaryFolder folder;
  TileStore store(folder.path());
  LUM_ASSERT_OK(const std::string name, store.put("paint"));
  fs::resize_file(files_below(folder.path()).front(), 0);
  LUM_ASSERT_OK(const std::string again, store.put("paint"));
  LUM_ASSERT_OK(const std::string bytes, store.get(again));
  EXPECT_EQ(bytes, "paint");
  EXPECT_EQ(again, name);
}

TEST(TileStore, MovesFromMemoryToAFolder) {
  const TemporaryFolder folder;
  TileStore memory;
  LUM_ASSERT_OK(const std::string name, memory.put("paint"));
  LUM_EXPECT_OK(memory.copy_to(folder.path() / "tiles"));
  const TileStore disk(folder.path() / "tiles");
  LUM_ASSERT_OK(const std::string bytes, disk.get(name));
  EXPECT_EQ(bytes, "paint");
}

TEST(TileStore, SaysWhereItCannotWrite) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("file")) << "no folder";
  TileStore store(folder.path() / "file" / "tiles");
  EXPECT_EQ(error_of(store.put("paint")).kind, ErrorKind::kUnwritable);
}

}  // namespace
}  // namespace luminist
