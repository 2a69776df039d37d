#include "prep/half_edges.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "prep/nasty_meshes.h"
#include "raster/mesh_scenes.h"
#include "surface/repair.h"

namespace luminist {
namespace {

std::size_t first_fault(const std::vector<Vec3>& positions, std::span<const std::array<std::uint32_t, 3>> triangles) {
  const QuietOpenMesh quiet;
  TriangleMesh half_edges;
  std::vector<std::uint32_t> own(positions.size());
  std::iota(own.begin(), own.end(), 0U);
  return add_faces(half_edges, positions, own, triangles);
}

TEST(HalfEdges, TakeEveryRepairedSurface) {
  for (const test::NamedMesh& nasty : test::nasty_meshes()) {
    const WeldedMesh surface = repair(nasty.mesh).surface;
    EXPECT_EQ(first_fault(surface.positions, surface.triangles), kNoFault) << nasty;
  }
}

TEST(HalfEdges, TakeHeapsOfTrianglesOnceTheyAreRepaired) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const WeldedMesh surface = repair(test::heap_mesh(seed, 4 + seed % 9, 5, 40)).surface;
    EXPECT_EQ(first_fault(surface.positions, surface.triangles), kNoFault) << "heap " << seed;
  }
}

TEST(HalfEdges, NameTheFirstFaceThatNoManifoldHas) {
  const std::vector<Vec3> positions{Vec3(0.0F), Vec3(0.0F, 1.0F, 0.0F), Vec3(1.0F, 0.0F, 0.0F), Vec3(-1.0F, 0.0F, 0.0F),
                                    Vec3(0.0F, 0.0F, 1.0F)};
  const std::vector<std::array<std::uint32_t, 3>> pages{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};  // on one spine
  EXPECT_EQ(first_fault(positions, pages), 2U);
}

}  // namespace
}  // namespace luminist
