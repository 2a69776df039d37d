#include "prep/stroke_mesh.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/files.h"
#include "raster/mesh_scenes.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

bool same(const StrokeMesh& a, const StrokeMesh& b) {
  return a.mesh.positions == b.mesh.positions && a.mesh.normals == b.mesh.normals &&
         a.mesh.triangles == b.mesh.triangles && a.mesh.line_widths == b.mesh.line_widths && a.strokes == b.strokes;
}

std::filesystem::path only_file(const std::filesystem::path& folder) {
  std::filesystem::path found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    EXPECT_TRUE(found.empty()) << "one file for one mesh";
    found = entry.path();
  }
  return found;
}

TEST(StrokeMesh, ComesBackFromItsFileAsItWasMade) {
  const TemporaryFolder folder;
  const std::filesystem::path cache = folder.path() / "new/cache";
  Mesh cube = test::box_mesh();
  cube.line_widths.assign(cube.positions.size(), 0.5F);
  const StrokeMesh without = stroke_mesh(cube, {});
  const StrokeMesh made = stroke_mesh(cube, cache);
  EXPECT_TRUE(same(without, made));
  EXPECT_EQ(made.strokes.size(), made.mesh.positions.size());
  EXPECT_EQ(made.mesh.triangles.size(), cube.triangles.size());
  const auto written = std::filesystem::last_write_time(only_file(cache));
  EXPECT_TRUE(same(stroke_mesh(cube, cache), made));
  EXPECT_EQ(std::filesystem::last_write_time(only_file(cache)), written) << "it was read, not made again";
}

TEST(StrokeMesh, KeepsNormalsThatAreNotThoseOfItsTriangles) {
  const TemporaryFolder folder;
  Mesh cube = test::box_mesh();
  stroke_mesh(cube, folder.path());
  for (std::size_t v = 0; v < cube.normals.size(); ++v) cube.normals[v] = glm::normalize(cube.positions[v]);
  const StrokeMesh made = stroke_mesh(cube, folder.path());
  for (std::size_t v = 0; v < made.mesh.normals.size(); ++v) {
    EXPECT_EQ(made.mesh.normals[v], glm::normalize(made.mesh.positions[v]));
  }
}

TEST(StrokeMesh, OfADamagedFileIsMadeAgain) {
  const TemporaryFolder folder;
  const Mesh cube = test::box_mesh();
  const StrokeMesh made = stroke_mesh(cube, folder.path());
  const std::filesystem::path path = only_file(folder.path());
  LUM_ASSERT_OK(const std::string good, read_file(path));
  for (std::size_t at : {std::size_t{3}, good.size() / 2, good.size() - 1}) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x20);
    LUM_EXPECT_OK(write_file_atomic(path, bad));
    EXPECT_TRUE(same(stroke_mesh(cube, folder.path()), made));
    LUM_ASSERT_OK(const std::string mended, read_file(path));
    EXPECT_EQ(mended, good);
  }
  LUM_EXPECT_OK(write_file_atomic(path, good.substr(0, good.size() / 3)));
  EXPECT_TRUE(same(stroke_mesh(cube, folder.path()), made));
}

TEST(StrokeMesh, DoesWithoutACacheThatCannotBeWritten) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("file")) << "no folder";
  EXPECT_TRUE(same(stroke_mesh(test::box_mesh(), folder.path() / "file/cache"), stroke_mesh(test::box_mesh(), {})));
}

}  // namespace
}  // namespace luminist
