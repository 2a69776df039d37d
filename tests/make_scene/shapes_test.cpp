#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

#include "make_scene/curve.h"
#include "make_scene/drape.h"
#include "make_scene/noise.h"
#include "make_scene/painting.h"
#include "make_scene/slab.h"
#include "make_scene/surface_nets.h"

namespace luminist {
namespace {

/// How many times each undirected edge is used, joined by position: 2 everywhere on a closed surface.
bool is_closed(const Mesh& mesh) {
  using Place = std::tuple<float, float, float>;
  std::map<std::pair<Place, Place>, int> uses;
  const auto place = [&](std::uint32_t i) {
    return Place(mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z);
  };
  for (const auto& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Place a = place(t[c]);
      const Place b = place(t[(c + 1) % 3]);
      ++uses[{a, b}];
      --uses[{b, a}];
    }
  }
  for (const auto& [edge, balance] : uses) {
    if (balance != 0) return false;
  }
  return !uses.empty();
}

TEST(Tessellate, GivesARevolvedProfileOutwardNormalsThatAgreeAtTheSeam) {
  const Mesh mesh = tessellate(revolve(Curve::profile({{1.0, 0.0}, {1.2, 0.5}, {1.0, 1.0}})), 24, 8);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3 out(mesh.positions[i].x, 0.0F, mesh.positions[i].z);
    EXPECT_GT(glm::dot(mesh.normals[i], glm::normalize(out)), 0.5F);
  }
  for (std::size_t row = 0; row <= 8; ++row) {
    EXPECT_LT(glm::length(mesh.normals[row * 25] - mesh.normals[row * 25 + 24]), 1e-3F);  // one-sided differences there
  }
}

TEST(Curve, PassesThroughItsPointsAndIsWalkedByLength) {
  const Curve curve({{0, 0, 0, 1}, {1, 0, 0, 2}, {1, 2, 0, 3}});
  const Point4 knot = curve.at(curve.fraction_at_point(1));
  EXPECT_NEAR(glm::length(knot - Point4(1, 0, 0, 2)), 0.0, 1e-9);
  const double step = glm::length(Point3(curve.at(0.51)) - Point3(curve.at(0.50)));
  EXPECT_NEAR(step, 0.01 * curve.length(), 0.002 * 0.01 * curve.length() * 10);  // chords of a table of 32 per segment
}

TEST(Sweep, MakesATubeOfTheCurvesRadius) {
  const Curve path({{0, 0, 0, 0.1}, {0, 0.5, 0.2, 0.1}, {0.3, 1.0, 0.2, 0.1}});
  const Surface tube = sweep(path);
  for (const double v : {0.1, 0.45, 0.8}) {
    for (const double u : {0.0, 0.3, 0.7}) {
      EXPECT_NEAR(glm::length(tube(u, v) - Point3(path.at(v))), 0.1, 1e-4);  // frames are interpolated linearly
    }
  }
}

TEST(Slab, IsAClosedBoxOfItsExtentsWithRoundEdges) {
  const Mesh mesh = slab({1.0F, 0.5F, 0.25F}, 0.1F);
  EXPECT_TRUE(is_closed(mesh));
  const Box box = mesh.bounds();
  EXPECT_LT(glm::length(box.hi - Vec3(1.0F, 0.5F, 0.25F)), 1e-6F);
  EXPECT_LT(glm::length(box.lo + Vec3(1.0F, 0.5F, 0.25F)), 1e-6F);
  for (const Vec3& p : mesh.positions)
    EXPECT_LT(glm::length(glm::max(glm::abs(p) - Vec3(0.9F, 0.4F, 0.15F), Vec3(0.0F))), 0.1001F);
}

TEST(SurfaceNets, FindASphereAndSnapToIt) {
  const Field field = [](const Point3& p) { return sphere_distance(p, {0.1, 0.2, 0.3}, 1.0); };
  Mesh mesh = surface_nets(field, {{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}}, 0.1);
  snap_to_field(mesh, field, 0.1);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_EQ(mesh.positions.size(), mesh.triangles.size() / 2 + 2);  // one sphere
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3 out = mesh.positions[i] - Vec3(0.1F, 0.2F, 0.3F);
    EXPECT_NEAR(glm::length(out), 1.0F, 1e-4F);
    EXPECT_GT(glm::dot(mesh.normals[i], out), 0.999F);
  }
}

TEST(SmoothUnion, IsAtMostAQuarterOfItsWidthBelowTheMinimum) {
  EXPECT_NEAR(smooth_union(0.3, 0.3, 0.2), 0.25, 1e-12);
  EXPECT_EQ(smooth_union(0.3, 0.6, 0.2), 0.3);
  EXPECT_EQ(smooth_difference(-0.5, 0.9, 0.2), -0.5);
}

TEST(Noise, RepeatsWithItsPeriod) {
  for (const double x : {0.2, 1.7, 2.4}) {
    EXPECT_NEAR(noise({x, 0.5, 0.1}, 4), noise({x + 4.0, 0.5, 0.1}, 4), 1e-12);  // x + 4 is rounded
    EXPECT_NEAR(cells({x, 0.5, 0.1}, 4).nearest, cells({x, 4.5, 0.1}, 4).nearest, 1e-12);
  }
  EXPECT_EQ(noise({2.0, 3.0, 4.0}), 0.0);  // at lattice points
}

TEST(PaintNormals, PointAwayFromASlope) {
  const Image map = paint_normals(32, 32, [](double u, double) { return 0.1 * u; }, {1.0, 1.0});
  const Vec3 n = 2.0F * map.rgb(map.index(16, 16)) - Vec3(1.0F);
  EXPECT_NEAR(n.x / n.z, -0.1F, 1e-4F);  // heights climb towards larger u
  const Image down = paint_normals(32, 32, [](double, double v) { return 0.1 * v; }, {1.0, 1.0});
  EXPECT_GT(down.at(16, 16, 1), 0.5F);  // green is towards smaller v, downhill here
}

TEST(Fallen, ClothRestsOnWhatItFallsOn) {
  Drape drape;
  drape.columns = drape.rows = 20;
  drape.start = [](double u, double v) { return Point3(0.4 * (u - 0.5), 0.05, 0.4 * (v - 0.5)); };
  drape.size = {0.4, 0.4};
  drape.obstacle = [](const Point3& p) { return std::max(p.y, std::max(std::abs(p.x), std::abs(p.z)) - 0.1); };
  drape.steps = 200;
  const Mesh cloth = fallen(drape);
  float lowest = 1.0F;
  for (const Vec3& p : cloth.positions) {
    EXPECT_GT(drape.obstacle(Point3(p)), -1e-3);
    lowest = std::min(lowest, p.y);
  }
  EXPECT_LT(lowest, -0.05F);                                            // its edges hang over the block's
  EXPECT_NEAR(cloth.positions[10 * 21 + 10].y, drape.thickness, 0.01);  // its middle lies on top, within half a cell
}

}  // namespace
}  // namespace luminist
