#include "prep/decimate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luminist {
namespace {

/// A sphere of radius 1 as a grid: its seam and poles have vertices at one place.
Mesh sphere(int columns, int rows) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double around = i == columns ? 0.0 : 2.0 * kPi * i / columns;
      const double down = kPi * j / rows;
      const double ring = j == 0 || j == rows ? 0.0 : std::sin(down);
      mesh.positions.emplace_back(ring * std::sin(around), -std::cos(down), ring * std::cos(around));
      mesh.uvs.emplace_back(0.0F, 0.0F);
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (columns + 1) + i);
      const auto c = a + static_cast<std::uint32_t>(columns) + 1;
      mesh.triangles.push_back({a, a + 1, c + 1});
      mesh.triangles.push_back({a, c + 1, c});
    }
  }
  return mesh;
}

TEST(Decimate, ReachesTheBudgetAndStaysNearTheShape) {
  const Mesh mesh = decimate(sphere(64, 48), 800);
  EXPECT_LE(mesh.triangles.size(), 800U);
  EXPECT_GT(mesh.triangles.size(), 700U);
  EXPECT_TRUE(mesh.uvs.empty());
  for (const Vec3& p : mesh.positions) EXPECT_NEAR(glm::length(p), 1.0F, 0.01F);  // collapses choose among the vertices
  for (const auto& t : mesh.triangles) {
    const Vec3 middle = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0F;
    EXPECT_GT(glm::length(middle), 0.96F);  // 800 triangles of a sphere sag by about 1 %
  }
}

TEST(Decimate, LeavesAClosedSurfaceClosed) {
  const Mesh mesh = decimate(sphere(64, 48), 500);
  EXPECT_EQ(mesh.positions.size(), mesh.triangles.size() / 2 + 2);  // Euler: seam and poles were joined
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_GT(glm::dot(mesh.normals[i], mesh.positions[i]), 0.9F);  // normals are new and face out
  }
}

TEST(Decimate, OnlyJoinsVerticesWhenTheBudgetIsLarge) {
  const Mesh mesh = decimate(sphere(16, 12), 100000);
  EXPECT_EQ(mesh.triangles.size(), 2U * 16U * 12U - 2U * 16U);  // the poles' zero-area triangles are gone
}

TEST(Decimate, DropsTheThirdFaceOfAnEdge) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  EXPECT_EQ(decimate(mesh, 10).triangles.size(), 2U);
}

TEST(Decimate, IsTheSameEveryTime) {
  const Mesh first = decimate(sphere(48, 32), 600);
  const Mesh second = decimate(sphere(48, 32), 600);
  EXPECT_EQ(first.triangles, second.triangles);
  EXPECT_EQ(first.positions, second.positions);
}

}  // namespace
}  // namespace luminist
