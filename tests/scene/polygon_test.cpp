#include "scene/polygon.h"

#include <gtest/gtest.h>

#include <random>

namespace luminist {
namespace {

Vec3 area_of(const std::vector<Vec3>& p, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  Vec3 sum(0.0F);
  for (const auto& t : triangles) sum += glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
  return 0.5F * sum;
}

/// The sum of the triangles' own areas: larger than the polygon's if some lie outside of it.
float covered(const std::vector<Vec3>& p, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  float sum = 0.0F;
  for (const auto& t : triangles) sum += 0.5F * glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
  return sum;
}

TEST(Triangulation, CutsAConcavePolygonInside) {
  const std::vector<Vec3> arrow{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {2, 1, 1}, {0, 4, 1}};  // area 16 - 6
  const auto triangles = triangulate(arrow);
  ASSERT_EQ(triangles.size(), 3U);
  EXPECT_NEAR(area_of(arrow, triangles).z, 10.0F, 1e-5F);  // winding kept
  EXPECT_NEAR(covered(arrow, triangles), 10.0F, 1e-5F);
}

TEST(Triangulation, CutsAConcaveQuadAlongItsInnerDiagonal) {
  for (std::size_t turn = 0; turn < 4; ++turn) {
    std::vector<Vec3> dart{{0, 0, 0}, {2, 2, 0}, {0, 1, 0}, {-2, 2, 0}};
    std::rotate(dart.begin(), dart.begin() + static_cast<std::ptrdiff_t>(turn), dart.end());
    EXPECT_NEAR(covered(dart, triangulate(dart)), 2.0F, 1e-6F);
  }
}

TEST(Triangulation, WorksInEveryPlaneAndBothWindings) {
  const std::vector<Vec3> flat{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};  // an L of area 5
  for (const Vec3 normal : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(-0.6F, 0.8F, 0)}) {
    Vec3 u, v;
    tangent_frame(normal, u, v);
    std::vector<Vec3> p;
    for (const Vec3& q : flat) p.push_back(q.x * u + q.y * v + 7.0F * normal);
    const auto triangles = triangulate(p);
    EXPECT_EQ(triangles.size(), 4U);
    EXPECT_NEAR(glm::dot(area_of(p, triangles), normal), 5.0F, 1e-4F);
    EXPECT_NEAR(covered(p, triangles), 5.0F, 1e-4F);
  }
}

TEST(Triangulation, GivesTwoTrianglesLessThanCornersWhateverTheShape) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> anywhere(-1.0F, 1.0F);
  for (std::size_t corners = 3; corners < 60; ++corners) {
    std::vector<Vec3> p;
    for (std::size_t i = 0; i < corners; ++i) p.emplace_back(anywhere(random), anywhere(random), anywhere(random));
    EXPECT_EQ(triangulate(p).size(), corners - 2);
  }
  EXPECT_EQ(triangulate(std::vector<Vec3>(5, Vec3(1.0F))).size(), 3U);  // all in one place
  EXPECT_EQ(triangulate(std::vector<Vec3>(5000, Vec3(1.0F))).size(), 4998U);
  EXPECT_TRUE(triangulate(std::vector<Vec3>(2)).empty());
}

}  // namespace
}  // namespace luminist
