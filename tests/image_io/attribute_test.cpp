#include <gtest/gtest.h>

#include "image_io/image_io.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

TEST(StoredAttribute, ComesBackFromBothKindsOfFile) {
  const TemporaryFolder folder;
  const Image image(5, 3, 3, 0.25F);
  for (const char* name : {"a.exr", "a.png"}) {
    LUM_EXPECT_OK(write_image(folder.file(name), image, {{"luminist:frame", "seven, \"7\""}, {"other", "x"}}));
    LUM_ASSERT_OK(const StoredAttribute stored, read_attribute(folder.file(name), "luminist:frame"));
    EXPECT_EQ(stored.value, "seven, \"7\"") << name;
    EXPECT_EQ(stored.width, 5);
    EXPECT_EQ(stored.height, 3);
    LUM_ASSERT_OK(const StoredAttribute none, read_attribute(folder.file(name), "luminist:color"));
    EXPECT_EQ(none.value, "");
  }
}

TEST(StoredAttribute, IsNotReadFromADamagedFile) {
  const TemporaryFolder folder;
  LUM_EXPECT_OK(write_image(folder.file("a.png"), Image(64, 64, 3, 0.3F), {{"luminist:frame", "7"}}));
  std::filesystem::resize_file(folder.file("a.png"), 90);
  EXPECT_FALSE(read_attribute(folder.file("a.png"), "luminist:frame"));
  EXPECT_EQ(error_of(read_attribute(folder.file("b.png"), "luminist:frame")).kind, ErrorKind::kMissing);
}

}  // namespace
}  // namespace luminist
