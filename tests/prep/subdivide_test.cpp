#include "prep/subdivide.h"

#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace luminist {
namespace {

Cage cube() {
  Cage cage;
  for (int i = 0; i < 8; ++i) cage.positions.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
  cage.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return cage;
}

/// Six times the volume that a closed mesh encloses; negative if it is inside out.
double six_volumes(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    sum += glm::dot(mesh.positions[t[0]], glm::cross(mesh.positions[t[1]], mesh.positions[t[2]]));
  }
  return sum;
}

TEST(Subdivide, GivesFourTimesTheQuadsWithEveryLevel) {
  for (const int levels : {0, 1, 2, 3}) {
    LUM_ASSERT_OK(const Mesh mesh, subdivide(cube(), levels));
    EXPECT_EQ(mesh.triangles.size(), 12U << (2 * levels));
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_TRUE(mesh.uvs.empty());
  }
}

TEST(Subdivide, FollowsTheRuleOfCatmullAndClarkAtACorner) {
  LUM_ASSERT_OK(const Mesh mesh, subdivide(cube(), 1));
  // A corner of valence 3 moves to (Q + 2R + 0 S) / 3: face points average (1/3, 1/3, 1/3), edge middles (1/6, ...).
  float nearest = 1.0F;
  for (const Vec3& p : mesh.positions) nearest = std::min(nearest, glm::length(p - Vec3(2.0F / 9.0F)));
  EXPECT_LT(nearest, 1e-6F);  // rounding of floats
}

TEST(Subdivide, KeepsTheSurfaceClosedAndFacingOut) {
  LUM_ASSERT_OK(const Mesh mesh, subdivide(cube(), 3));
  EXPECT_GT(six_volumes(mesh), 0.0);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_GT(glm::dot(mesh.normals[i], mesh.positions[i] - Vec3(0.5F)), 0.0F);
  }
}

TEST(Subdivide, TakesTrianglesAsFacesThatRepeatACorner) {
  Cage cage;
  cage.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  cage.faces = {{0, 2, 1, 1}, {0, 1, 3, 3}, {0, 3, 2, 2}, {1, 2, 3, 3}};
  LUM_ASSERT_OK(const Mesh mesh, subdivide(cage, 1));
  EXPECT_EQ(mesh.triangles.size(), 24U);  // three quads for every triangle
  EXPECT_GT(six_volumes(mesh), 0.0);
}

TEST(Subdivide, NamesTheFaceThatMakesNoManifold) {
  Cage cage = cube();
  cage.faces.push_back({0, 2, 3, 1});
  const Error error = error_of(subdivide(cage, 1));
  EXPECT_EQ(error.kind, ErrorKind::kBadContent);
  EXPECT_NE(error.what.find("face 6"), std::string::npos) << error.message();
}

TEST(Subdivide, NamesTheCornerThatDoesNotExist) {
  Cage cage = cube();
  cage.faces[2][1] = 8;
  const Error error = error_of(subdivide(cage, 1));
  EXPECT_EQ(error.kind, ErrorKind::kBadContent);
  EXPECT_NE(error.what.find("face 2 names vertex 8"), std::string::npos) << error.message();
}

TEST(Subdivide, RefusesMoreTrianglesThanASceneMayHave) {
  EXPECT_EQ(error_of(subdivide(cube(), 12)).kind, ErrorKind::kLimit);
}

TEST(SubdivideLoop, JoinsVerticesAtOnePlaceAndRoundsTheShape) {
  Mesh octahedron;  // three vertices for every face, as a loader that splits corners gives
  const Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int octant = 0; octant < 8; ++octant) {
    const float sx = octant & 1 ? -1.0F : 1.0F;
    const float sy = octant & 2 ? -1.0F : 1.0F;
    const float sz = octant & 4 ? -1.0F : 1.0F;
    const auto base = static_cast<std::uint32_t>(octahedron.positions.size());
    for (const Vec3& p : {sx * axes[0], sy * axes[1], sz * axes[2]}) octahedron.positions.push_back(p);
    if (sx * sy * sz > 0.0F)
      octahedron.triangles.push_back({base, base + 1, base + 2});
    else
      octahedron.triangles.push_back({base, base + 2, base + 1});
  }
  LUM_ASSERT_OK(const Mesh mesh, subdivide_loop(octahedron, 3));
  EXPECT_EQ(mesh.triangles.size(), 8U * 64U);
  EXPECT_EQ(mesh.positions.size(), 258U);  // V = F / 2 + 2: it is one closed surface
  float lo = 2.0F;
  float hi = 0.0F;
  for (const Vec3& p : mesh.positions) lo = std::min(lo, glm::length(p)), hi = std::max(hi, glm::length(p));
  EXPECT_LT(hi / lo, 1.25F);  // the octahedron itself has sqrt(3)
}

}  // namespace
}  // namespace luminist
