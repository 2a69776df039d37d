#include "scene/mesh.h"

#include <gtest/gtest.h>

#include <random>

namespace luminist {
namespace {

/// Eight corners, twelve triangles, faces outwards.
Mesh cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

Mesh sphere(int rings, int segments) {
  Mesh mesh;
  for (int r = 0; r <= rings; ++r) {
    for (int s = 0; s < segments; ++s) {
      const double theta = kPi * r / rings, phi = 2.0 * kPi * s / segments;
      mesh.positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi));
    }
  }
  for (int r = 0; r < rings; ++r) {
    for (int s = 0; s < segments; ++s) {
      const auto at = [&](int ring, int segment) {
        return static_cast<std::uint32_t>(ring * segments + segment % segments);
      };
      mesh.triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
      mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
    }
  }
  return mesh;
}

TEST(Normals, OfACubeStandOnItsFaces) {
  Mesh mesh = cube();
  compute_normals(mesh, 0.5);
  EXPECT_EQ(mesh.positions.size(), 24U);  // every corner serves three faces
  for (const auto& t : mesh.triangles) {
    const Vec3 face = glm::normalize(
        glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]));
    for (const std::uint32_t index : t) EXPECT_NEAR(glm::dot(face, mesh.normals[index]), 1.0F, 1e-6F);
  }
}

TEST(Normals, OfACubePointAlongItsDiagonalsWithoutCreases) {
  Mesh mesh = cube();
  compute_normals(mesh, kPi);
  ASSERT_EQ(mesh.positions.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    // The angles at a corner weigh its three faces alike, however they are cut into triangles.
    const Vec3 diagonal = glm::normalize(mesh.positions[i] - Vec3(0.5F));
    EXPECT_NEAR(glm::dot(diagonal, mesh.normals[i]), 1.0F, 1e-6F);
  }
}

TEST(Normals, OfASphereAreItsRadii) {
  Mesh mesh = sphere(24, 48);
  const std::size_t before = mesh.positions.size();
  compute_normals(mesh, kPi / 3.0);
  EXPECT_EQ(mesh.positions.size(), before);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    // Facets of 7.5 degrees; the poles are many vertices at one place.
    EXPECT_GT(glm::dot(mesh.normals[i], mesh.positions[i]), 0.999F);
  }
}

TEST(Normals, AreJoinedAcrossVerticesAtOnePosition) {
  Mesh mesh;  // two triangles of a gentle roof that share an edge only by place
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0.1F, -1}, {1, 0, 0}, {0, 0, 0}, {0, 0.1F, 1}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  compute_normals(mesh, kPi / 3.0);
  EXPECT_EQ(mesh.positions.size(), 6U);
  EXPECT_NEAR(mesh.normals[0].z, 0.0F, 1e-6F);
  EXPECT_NEAR(glm::distance(mesh.normals[0], mesh.normals[4]), 0.0F, 1e-6F);
}

TEST(Normals, KeepTheTextureCoordinatesOfSplitVertices) {
  Mesh mesh = cube();
  for (const Vec3& p : mesh.positions) mesh.uvs.emplace_back(p.x + 2.0F * p.y, p.z);
  compute_normals(mesh, 0.5);
  ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.uvs.size(); ++i) {
    EXPECT_EQ(mesh.uvs[i], Vec2(mesh.positions[i].x + 2.0F * mesh.positions[i].y, mesh.positions[i].z));
  }
}

TEST(Normals, AreUnitEvenWhereFacesHaveNoArea) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {5, 5, 5}};
  mesh.triangles = {{0, 1, 2}, {0, 0, 1}, {3, 3, 3}};
  compute_normals(mesh, kPi / 3.0);
  for (const Vec3& n : mesh.normals) EXPECT_NEAR(glm::length(n), 1.0F, 1e-6F);
}

TEST(Normals, OfAStarOfManyCreasesCostNoMoreThanItsTriangles) {
  Mesh mesh;  // 200,000 separate fins around one vertex: quadratic work would not end
  mesh.positions.emplace_back(0.0F);
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  for (std::uint32_t i = 0; i < 200'000; ++i) {
    mesh.positions.emplace_back(normal(random), normal(random), normal(random));
    mesh.positions.emplace_back(normal(random), normal(random), normal(random));
    mesh.triangles.push_back({0, 2 * i + 1, 2 * i + 2});
  }
  compute_normals(mesh, 0.1);
  EXPECT_EQ(mesh.positions.size(), 600'000U);
}

/// A quad in the xy plane, seen from +z, with texture coordinates that run right and down.
Mesh quad() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.normals.assign(4, Vec3(0, 0, 1));
  mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(Tangents, FollowTheTextureAndItsBitangentPointsUp) {
  Mesh mesh = quad();
  compute_tangents(mesh);
  for (const Vec4& t : mesh.tangents) EXPECT_EQ(t, Vec4(1, 0, 0, 1));  // normal x tangent = +y, up in the picture
}

TEST(Tangents, TurnTheirSignOnMirroredTextures) {
  Mesh mesh = quad();
  for (Vec2& uv : mesh.uvs) uv.x = 1.0F - uv.x;
  compute_tangents(mesh);
  for (const Vec4& t : mesh.tangents) EXPECT_EQ(t, Vec4(-1, 0, 0, -1));
}

TEST(Tangents, SplitVerticesOnTheSeamOfAMirroredTexture) {
  Mesh mesh = quad();  // a second quad to the right shows the picture again, mirrored
  mesh.positions.insert(mesh.positions.end(), {{2, 0, 0}, {2, 1, 0}});
  mesh.normals.resize(6, Vec3(0, 0, 1));
  mesh.uvs.insert(mesh.uvs.end(), {{0, 1}, {0, 0}});
  mesh.triangles.push_back({1, 4, 5});
  mesh.triangles.push_back({1, 5, 2});
  compute_tangents(mesh);
  EXPECT_EQ(mesh.positions.size(), 8U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(mesh.tangents[mesh.triangles[i][0]].w, 1.0F);
  for (std::size_t i = 2; i < 4; ++i) EXPECT_EQ(mesh.tangents[mesh.triangles[i][0]].w, -1.0F);
}

TEST(Tangents, AreUnitAndSquareToTheNormalWithoutAnyTextureArea) {
  Mesh mesh = quad();
  mesh.uvs.assign(4, Vec2(0.5F));
  compute_tangents(mesh);
  for (const Vec4& t : mesh.tangents) {
    EXPECT_NEAR(glm::length(Vec3(t)), 1.0F, 1e-6F);
    EXPECT_NEAR(t.z, 0.0F, 1e-6F);
  }
}

TEST(Tangents, NeedTextureCoordinates) {
  Mesh mesh = quad();
  mesh.uvs.clear();
  compute_tangents(mesh);
  EXPECT_TRUE(mesh.tangents.empty());
}

TEST(Bounds, HoldEveryPosition) {
  const Box box = cube().bounds();
  EXPECT_EQ(box.lo, Vec3(0.0F));
  EXPECT_EQ(box.hi, Vec3(1.0F));
  EXPECT_TRUE(Mesh().bounds().empty());
}

}  // namespace
}  // namespace luminist
