#include "surface/repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "raster/mesh_scenes.h"

namespace luminist {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// No directed side twice, and one fan of triangles around every position.
void expect_manifold(const WeldedMesh& surface) {
  std::set<Edge> sides;
  std::map<std::uint32_t, std::vector<std::size_t>> around;
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const auto& t = surface.triangles[f];
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(sides.emplace(t[k], t[(k + 1) % 3]).second) << "a side twice";
      around[t[k]].push_back(f);
    }
  }
  EXPECT_EQ(around.size(), surface.positions.size());
  const auto share_side_at = [&](std::size_t f, std::size_t g, std::uint32_t at) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& t = surface.triangles[f];
      const Edge side{t[k], t[(k + 1) % 3]};
      if (side.first != at && side.second != at) continue;
      const auto& u = surface.triangles[g];
      for (std::size_t m = 0; m < 3; ++m) {
        if (u[m] == side.second && u[(m + 1) % 3] == side.first) return true;
      }
    }
    return false;
  };
  for (auto& [at, faces] : around) {
    std::vector<std::size_t> fan{faces.back()};
    std::vector<std::size_t> rest(faces.begin(), faces.end() - 1);
    for (std::size_t i = 0; i < fan.size(); ++i) {
      std::erase_if(rest, [&, from = fan[i], place = at](std::size_t f) {
        if (!share_side_at(from, f, place)) return false;
        fan.push_back(f);
        return true;
      });
    }
    EXPECT_TRUE(rest.empty()) << "position " << at << " has several fans";
  }
}

double volume_of(const WeldedMesh& surface) {
  double sum = 0.0;
  for (const auto& t : surface.triangles) {
    sum += static_cast<double>(
        glm::dot(surface.positions[t[0]], glm::cross(surface.positions[t[1]], surface.positions[t[2]])));
  }
  return sum / 6.0;
}

Mesh with_smooth_normals(Mesh mesh) {
  mesh.normals.clear();
  compute_normals(mesh, kPi);
  return mesh;
}

TEST(Repair, FindsNothingWrongWithASphereAndGivesItBack) {
  const Mesh sphere = test::sphere_mesh(1.0F, 24);
  const Repaired repaired = repair(sphere);
  // Its poles are rows of triangles without area.
  EXPECT_EQ(repaired.report.degenerate, 96U);
  EXPECT_EQ(repaired.report.flipped + repaired.report.duplicate + repaired.report.split_positions, 0U);
  EXPECT_EQ(repaired.report.open_edges, 0U);
  EXPECT_EQ(repaired.report.components, 1U);
  EXPECT_EQ(repaired.surface.positions.size(), 23U * 48U + 2U);
  expect_manifold(repaired.surface);
  const Mesh good = with_surface(sphere, repaired.surface);
  const Repaired again = repair(good);
  EXPECT_TRUE(again.report.was_good());
  const Mesh same = with_surface(good, again.surface);
  EXPECT_EQ(same.triangles, good.triangles);
  EXPECT_EQ(same.positions, good.positions);
  EXPECT_EQ(same.normals, good.normals);
}

TEST(Repair, WeldsSplitNormals) {
  const Mesh cube = test::box_mesh();
  const Repaired repaired = repair(cube);
  EXPECT_TRUE(repaired.report.was_good());
  EXPECT_EQ(repaired.report.welded, 16U);
  EXPECT_EQ(repaired.surface.positions.size(), 8U);
  EXPECT_NEAR(volume_of(repaired.surface), 8.0, 1e-5);
}

TEST(Repair, DropsWhatIsThereTwiceOrHasNoArea) {
  Mesh mesh = test::box_mesh();
  const std::size_t good = mesh.triangles.size();
  mesh.triangles.push_back(mesh.triangles[3]);
  mesh.triangles.push_back({mesh.triangles[5][2], mesh.triangles[5][1], mesh.triangles[5][0]});
  mesh.triangles.push_back({0, 0, 1});
  mesh.positions.push_back(0.5F * (mesh.positions[0] + mesh.positions[1]));
  mesh.normals.push_back(mesh.normals[0]);
  mesh.triangles.push_back({0, 1, static_cast<std::uint32_t>(mesh.positions.size() - 1)});
  const Repaired repaired = repair(mesh);
  EXPECT_EQ(repaired.report.duplicate, 2U);
  EXPECT_EQ(repaired.report.degenerate, 2U);
  EXPECT_EQ(repaired.surface.triangles.size(), good);
  EXPECT_EQ(with_surface(mesh, repaired.surface).positions.size(), mesh.positions.size() - 1);
  expect_manifold(repaired.surface);
}

TEST(Repair, TurnsTrianglesAsMostAreTurnedAndClosedPiecesOutwards) {
  std::mt19937 random(3);
  for (const double share : {0.2, 0.45, 0.8, 1.0}) {
    Mesh mesh = test::box_mesh();
    const Mesh ball = test::sphere_mesh(0.5F, 12);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::size_t v = 0; v < ball.positions.size(); ++v) {
      mesh.positions.push_back(ball.positions[v] + Vec3(5.0F, 0.0F, 0.0F));
      mesh.normals.push_back(ball.normals[v]);
    }
    for (const auto& t : ball.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    for (auto& t : mesh.triangles) {
      if (std::uniform_real_distribution<double>()(random) < share) std::swap(t[1], t[2]);
    }
    const Repaired repaired = repair(mesh);
    EXPECT_EQ(repaired.report.components, 2U);
    EXPECT_EQ(repaired.report.open_edges + repaired.report.torn_edges, 0U);
    EXPECT_NEAR(volume_of(repaired.surface), 8.0 + 0.5, 0.1);  // of a ball of twelve rows
    expect_manifold(repaired.surface);
  }
}

TEST(Repair, AHollowStaysTurnedInwards) {
  Mesh mesh = test::box_mesh();
  const Mesh ball = test::sphere_mesh(0.5F, 12);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), ball.positions.begin(), ball.positions.end());
  mesh.normals.insert(mesh.normals.end(), ball.normals.begin(), ball.normals.end());
  for (const auto& t : ball.triangles) mesh.triangles.push_back({first + t[0], first + t[2], first + t[1]});
  const Repaired repaired = repair(mesh);
  EXPECT_EQ(repaired.report.flipped, 0U);
  EXPECT_NEAR(volume_of(repaired.surface), 8.0 - 0.5, 0.1);
}

TEST(Repair, SplitsPagesOfABookAndConesThatTouchInAPoint) {
  Mesh book;  // three pages on one spine
  book.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
  book.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const Repaired pages = repair(with_smooth_normals(book));
  EXPECT_EQ(pages.report.split_edges, 1U);
  EXPECT_EQ(pages.report.components, 3U);
  EXPECT_EQ(pages.report.split_positions, 4U);
  expect_manifold(pages.surface);

  Mesh cones;
  cones.positions = {{0, 0, 0}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1}, {1, 0, -1}, {-1, 1, -1}, {-1, -1, -1}};
  cones.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 5, 4}, {0, 6, 5}, {0, 4, 6}};
  const Repaired apart = repair(with_smooth_normals(cones));
  EXPECT_EQ(apart.report.split_positions, 1U);
  EXPECT_EQ(apart.report.components, 2U);
  expect_manifold(apart.surface);
}

TEST(Repair, TearsABandWithOneSideOnly) {
  Mesh band;
  constexpr int kSteps = 24;
  for (int i = 0; i < kSteps; ++i) {
    const double u = 2.0 * kPi * i / kSteps;
    for (const double v : {-0.3, 0.3}) {
      const double r = 1.0 + v * std::cos(0.5 * u);
      band.positions.emplace_back(r * std::cos(u), v * std::sin(0.5 * u), r * std::sin(u));
    }
  }
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    const bool last = i + 1 == kSteps;
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = last ? 1 : a + 2;
    const std::uint32_t c = last ? 0 : a + 3;
    band.triangles.push_back({a, a + 1, b});
    band.triangles.push_back({b, a + 1, c});
  }
  const Repaired repaired = repair(with_smooth_normals(band));
  EXPECT_EQ(repaired.report.torn_edges, 1U);
  EXPECT_EQ(repaired.report.components, 1U);
  EXPECT_EQ(repaired.surface.triangles.size(), band.triangles.size());
  expect_manifold(repaired.surface);
}

TEST(Repair, AnyHeapOfTrianglesBecomesAManifold) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Mesh heap = test::heap_mesh(seed, 4 + seed % 9, 5, 40);
    const Repaired repaired = repair(heap);
    const RepairReport& report = repaired.report;
    EXPECT_EQ(repaired.surface.triangles.size() + report.degenerate + report.duplicate, heap.triangles.size());
    expect_manifold(repaired.surface);
  }
}

TEST(Repair, NothingIsNoFault) {
  const Repaired repaired = repair(Mesh{});
  EXPECT_TRUE(repaired.surface.triangles.empty());
  EXPECT_TRUE(repaired.report.was_good());
  EXPECT_TRUE(with_surface(Mesh{}, repaired.surface).positions.empty());
}

}  // namespace
}  // namespace luminist
