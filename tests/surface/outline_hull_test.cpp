#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <utility>

#include "raster/mesh_scenes.h"
#include "surface/outline_hull.h"
#include "surface/repair.h"

namespace luminist {
namespace {

Mesh plane() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  compute_normals(mesh, kPi);
  return mesh;
}

TEST(OutlineHull, OfACubeWithSplitNormalsIsClosedAndMovesEveryFaceByOne) {
  const Mesh cube = test::box_mesh();  // 24 vertices
  const OutlineHull hull = outline_hull(cube);
  ASSERT_EQ(hull.positions.size(), 8U) << "no vertex is split, so nothing tears";
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const auto& t : hull.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++sides[std::minmax(t[k], t[(k + 1) % 3])];
  }
  for (const auto& [side, count] : sides) EXPECT_EQ(count, 2);
  for (std::size_t v = 0; v < 8; ++v) {
    const Vec3 moved = hull.positions[v] + hull.directions[v];
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(std::abs(moved[axis]), 2.0F, 1e-5F) << "a larger cube";
  }
}

TEST(OutlineHull, HasAStripAlongOpenBorders) {
  const OutlineHull hull = outline_hull(plane());
  EXPECT_EQ(hull.triangles.size(), 2U + 4U * 4U) << "two sides of two triangles for each of four edges";
  Box moved;
  for (std::size_t v = 0; v < hull.positions.size(); ++v) moved.extend(hull.positions[v] + 0.5F * hull.directions[v]);
  EXPECT_NEAR(moved.lo.x, -0.5F, 1e-6F);
  EXPECT_NEAR(moved.hi.x, 2.5F, 1e-6F);
  EXPECT_NEAR(moved.lo.y, -0.5F, 1e-6F);
  EXPECT_NEAR(moved.hi.y, 1.5F, 1e-6F);
}

TEST(OutlineHull, KeepsTheWidthsOfTheMesh) {
  Mesh mesh = plane();
  mesh.line_widths = {0.0F, 0.25F, 0.5F, 1.0F};
  const OutlineHull hull = outline_hull(mesh);
  for (std::size_t v = 0; v < hull.positions.size(); ++v) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      if (hull.positions[v] == mesh.positions[i]) {
        EXPECT_EQ(hull.widths[v], mesh.line_widths[i]);
      }
    }
  }
}

TEST(OutlineHull, MultipliesItsWidthsByTheRedOfAMask) {
  Mesh mesh = plane();
  mesh.uvs = {{0.25F, 0.5F}, {0.75F, 0.5F}, {0.75F, 0.5F}, {0.5F, 0.5F}};
  Texture mask{"mask", Image(2, 1, 3, 0.9F), false, false};
  mask.image.set_rgb(0, Vec3(0.0F, 1.0F, 1.0F));
  mask.image.set_rgb(1, Vec3(1.0F, 0.0F, 0.0F));
  const std::array<float, 4> wanted{0.0F, 1.0F, 1.0F, 0.5F};  // pixels' centres, and half-way between them
  const auto expect = [&](float factor) {
    const OutlineHull hull = outline_hull(mesh, &mask);
    for (std::size_t v = 0; v < hull.positions.size(); ++v) {
      for (std::size_t i = 0; i < 4; ++i) {
        if (hull.positions[v] == mesh.positions[i]) {
          EXPECT_FLOAT_EQ(hull.widths[v], factor * wanted[i]);
        }
      }
    }
  };
  expect(1.0F);
  mesh.line_widths.assign(4, 0.5F);
  expect(0.5F);
  mesh.uvs.clear();
  for (const float width : outline_hull(mesh, &mask).widths) EXPECT_EQ(width, 0.5F) << "without uvs no mask";
}

TEST(OutlineHull, TakesTheLeastOfTheCornersThatAreJoinedInIt) {
  Mesh mesh = plane();
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  mesh.normals.assign(6, Vec3(0, 0, 1));
  mesh.line_widths = {0.2F, 1.0F, 0.7F, 0.4F, 0.3F, 1.0F};  // the diagonal's ends twice
  const OutlineHull hull = outline_hull(mesh);
  for (std::size_t v = 0; v < hull.positions.size(); ++v) {
    const Vec3& p = hull.positions[v];
    EXPECT_EQ(hull.widths[v], p == Vec3(0, 0, 0) ? 0.2F : p == Vec3(2, 1, 0) ? 0.3F : 1.0F);
  }
}

TEST(OutlineHull, SpikesDoNotGrowWithoutBound) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    Mesh heap;
    for (int i = 0; i < 9; ++i) heap.positions.emplace_back(random() % 5, random() % 5, random() % 5);
    for (int i = 0; i < 40; ++i) {
      heap.triangles.push_back({static_cast<std::uint32_t>(random() % 9), static_cast<std::uint32_t>(random() % 9),
                                static_cast<std::uint32_t>(random() % 9)});
    }
    compute_normals(heap, kPi);
    const OutlineHull hull = outline_hull(heap);
    for (const Vec3& d : hull.directions) {
      EXPECT_TRUE(is_finite(d));
      EXPECT_LE(glm::length(d), OutlineHull::kLongest * 1.0001F);
    }
  }
}

TEST(OutlineHull, OfNothingIsNothing) {
  EXPECT_TRUE(outline_hull(Mesh{}).triangles.empty());
}

}  // namespace
}  // namespace luminist
