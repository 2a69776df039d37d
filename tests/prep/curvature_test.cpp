#include "prep/curvature.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "prep/nasty_meshes.h"
#include "raster/mesh_scenes.h"

namespace luminist {
namespace {

constexpr double kDegree = kPi / 180.0;

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

/// Between two directions without sign.
double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), std::abs(glm::dot(a, b)));
}

TEST(Curvature, OfATorusIsKnown) {
  const WeldedMesh torus = repair(test::torus_mesh(1.0, 0.3, 64, 32)).surface;
  const Curvature curvature = curvature_of(torus, sides_of(torus));
  std::vector<double> directions, largest, others;
  for (std::size_t v = 0; v < torus.positions.size(); ++v) {
    const glm::dvec3 p(torus.positions[v]);
    const double axis = std::hypot(p.x, p.y);
    const glm::dvec3 middle(p.x / axis, p.y / axis, 0.0);
    const glm::dvec3 around(-middle.y, middle.x, 0.0);
    const glm::dvec3 n = (p - middle) / 0.3;
    directions.push_back(angle_between(curvature.directions[v], glm::cross(around, n)));
    largest.push_back(std::abs(curvature.largest[v] * 0.3 - 1.0));
    others.push_back(std::abs(curvature.other[v] - glm::dot(n, middle) / axis));
  }
  // Second order in the size of triangles, which is a tenth of the small radius' circle.
  EXPECT_LT(median(directions), 1.0 * kDegree);
  EXPECT_LT(median(largest), 0.02);
  EXPECT_LT(median(others), 0.05);
}

TEST(Curvature, OfATubeRunsAroundIt) {
  const WeldedMesh tube = repair(test::tube_mesh(0.5, 2.0, 48, 16)).surface;
  const Curvature curvature = curvature_of(tube, sides_of(tube));
  std::vector<double> directions, largest;
  for (std::size_t v = 0; v < tube.positions.size(); ++v) {
    const glm::dvec3 p(tube.positions[v]);
    directions.push_back(angle_between(curvature.directions[v], {-p.z, 0.0, p.x}));
    largest.push_back(curvature.largest[v] * 0.5);
  }
  EXPECT_LT(median(directions), 0.5 * kDegree);
  EXPECT_NEAR(median(largest), 1.0, 0.01);
}

TEST(Curvature, OfAHollowIsNegative) {
  Mesh hollow = test::sphere_mesh(2.0F, 24);
  for (auto& t : hollow.triangles) std::swap(t[1], t[2]);
  // A quarter of it is open, so that it is not turned outwards.
  std::erase_if(hollow.triangles, [&](const auto& t) { return hollow.positions[t[0]].y > 1.0F; });
  const WeldedMesh surface = repair(hollow).surface;
  const Curvature curvature = curvature_of(surface, sides_of(surface));
  EXPECT_NEAR(median(curvature.largest), -0.5, 0.01);
}

TEST(StrokeField, OfAnEllipsoidFollowsItsCurvature) {
  Mesh mesh = test::sphere_mesh(1.0F, 32);
  for (Vec3& p : mesh.positions) p *= Vec3(1.0F, 3.0F, 1.0F);
  const WeldedMesh surface = repair(mesh).surface;
  const StrokeField field = stroke_field(surface, sides_of(surface));
  std::vector<double> errors;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const glm::dvec3 p(surface.positions[v]);
    if (std::abs(p.y) < 2.0) errors.push_back(angle_between(field.directions[v], {-p.z, 0.0, p.x}));
  }
  EXPECT_LT(median(errors), 2.0 * kDegree);  // the diagonals of the mesh lean the normals to one side
}

TEST(StrokeField, FlatPlacesTakeOverFromBentOnes) {
  // A half tube with a flat sheet along its side: on the sheet strokes go on as they run around the tube.
  Mesh mesh;
  constexpr int kColumns = 40;
  constexpr int kRows = 12;
  for (int j = 0; j <= kRows; ++j) {
    for (int i = 0; i <= kColumns; ++i) {
      const double u = std::min(i, 20) * kPi / 20.0;
      mesh.positions.emplace_back(std::cos(u) + 0.0, j * 0.25, std::sin(u) - 0.15 * std::max(i - 20, 0));
    }
  }
  for (std::uint32_t j = 0; j < kRows; ++j) {
    for (std::uint32_t i = 0; i < kColumns; ++i) {
      const std::uint32_t a = j * (kColumns + 1) + i;
      const std::uint32_t b = a + kColumns + 1;
      mesh.triangles.push_back({a, b, b + 1}), mesh.triangles.push_back({a, b + 1, a + 1});
    }
  }
  compute_normals(mesh, kPi);
  const WeldedMesh surface = repair(mesh).surface;
  const StrokeField field = stroke_field(surface, sides_of(surface));
  double worst = 0.0;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    if (surface.positions[v].z < -0.5F) worst = std::max(worst, angle_between(field.directions[v], {0.0, 0.0, 1.0}));
  }
  EXPECT_LT(worst, 5.0 * kDegree);
}

TEST(StrokeField, IsFiniteUnitAndTangentOnEverySurface) {
  std::vector<test::NamedMesh> meshes = test::nasty_meshes();
  meshes.push_back({"plane", test::quad_mesh()});
  for (const test::NamedMesh& named : meshes) {
    const WeldedMesh surface = repair(named.mesh).surface;
    const StrokeField field = stroke_field(surface, sides_of(surface));
    ASSERT_EQ(field.directions.size(), surface.positions.size()) << named.name;
    for (std::size_t v = 0; v < field.directions.size(); ++v) {
      EXPECT_NEAR(glm::length(field.directions[v]), 1.0, 1e-9) << named.name;
      EXPECT_NEAR(glm::dot(field.directions[v], field.normals[v]), 0.0, 1e-9) << named.name;
      EXPECT_TRUE(field.confidence[v] >= 0.0 && field.confidence[v] <= 1.0) << named.name;
    }
  }
}

}  // namespace
}  // namespace luminist
