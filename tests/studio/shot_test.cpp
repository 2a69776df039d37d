#include "studio/shot.h"

#include <fstream>

#include "base/files.h"
#include "studio/action.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

TEST(FindInput, LooksBesideFirstAndBelowTheRootsThen) {
  const TemporaryFolder beside;
  const TemporaryFolder root;
  const AssetRoots roots({root.path()});
  std::ofstream(root.file("both")) << "root";
  std::ofstream(root.file("only")) << "root";
  std::ofstream(beside.file("both")) << "beside";
  LUM_ASSERT_OK(const std::string both, find_input("both", beside.path(), roots));
  LUM_ASSERT_OK(const std::string only, find_input("only", beside.path(), roots));
  EXPECT_EQ(both, beside.file("both"));
  EXPECT_EQ(only, root.file("only"));
  EXPECT_EQ(error_of(find_input("none", beside.path(), roots)).where, beside.file("none"));
  EXPECT_EQ(error_of(find_input("", beside.path(), roots)).kind, ErrorKind::kUsage);
}

TEST(PortablePath, IsRelativeToARootAndElseAbsolute) {
  const TemporaryFolder root;
  const TemporaryFolder other;
  fs::create_directories(root.path() / "meshes/jug");
  std::ofstream(root.path() / "meshes/jug/jug.glb") << "x";
  std::ofstream(other.file("jug.glb")) << "x";
  const AssetRoots roots({root.path()});
  EXPECT_EQ(portable_path((root.path() / "meshes/../meshes/jug/jug.glb").string(), roots), "meshes/jug/jug.glb");
  EXPECT_EQ(portable_path(other.file("jug.glb"), roots), fs::canonical(other.file("jug.glb")).string());
}

TEST(Shot, IsReadBackFromADocument) {
  Shot shot;
  shot.scene = "meshes/a \"b\".glb";
  shot.scene_options = {true, false};
  shot.camera = "left";
  shot.width = 123;
  shot.style = "toon";
  Document document;
  write_shot(shot, document);
  LUM_ASSERT_OK(const Shot read, read_shot(document));
  EXPECT_TRUE(same_stage(read, shot));
  EXPECT_EQ(read.camera, "left");
  for (const char* path : {"shot/scene", "shot/size", "shot/style"}) {
    Document broken = document;
    broken.set(path, "[1]");
    EXPECT_EQ(error_of(read_shot(broken)).field, path);
  }
}

TEST(Action, ReadsItsFieldsAndNamesTheWrongOnes) {
  LUM_ASSERT_OK(const Action action,
                Action::parse(R"({"do": "set", "path": "a", "value": [0.5, 1], "n": 3, "list": ["x", "y"]})", "s:4"));
  EXPECT_EQ(action.verb(), "set");
  LUM_ASSERT_OK(const std::string value, action.value_text("value"));
  EXPECT_EQ(value, "0.5,1");
  LUM_ASSERT_OK(const auto list, action.texts("list"));
  EXPECT_EQ(list, (std::vector<std::string>{"x", "y"}));
  LUM_ASSERT_OK(const auto absent, action.text("absent"));
  EXPECT_FALSE(absent);
  const Error wrong = error_of(action.text("n"));
  EXPECT_EQ(wrong.where, "s:4");
  EXPECT_EQ(wrong.field, "n");
  const std::vector<std::string> known = {"path", "value", "list", "number"};
  EXPECT_EQ(error_of(action.check_fields(known)).field, "n");
  EXPECT_EQ(error_of(Action::parse("{}", "s:4")).field, "do");
  EXPECT_EQ(error_of(Action::parse("{\"do\": \"x\"", "s:4")).kind, ErrorKind::kBadContent);
}

}  // namespace
}  // namespace luminist
