#include "surface/shadow_caster.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "raster/mesh_scenes.h"

namespace luminist {
namespace {

TEST(ShadowCaster, TellsClosedPiecesFromOpenOnes) {
  Mesh mesh = test::sphere_mesh(1.0F, 12);
  const std::size_t of_sphere = shadow_caster(mesh).closed.size();
  EXPECT_EQ(of_sphere, 2U * 12U * 24U - 48U) << "the triangles without area at the poles are gone";
  const Mesh quad = test::quad_mesh();
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), quad.positions.begin(), quad.positions.end());
  mesh.normals.insert(mesh.normals.end(), quad.normals.begin(), quad.normals.end());
  for (const auto& [a, b, c] : quad.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
  const ShadowCaster caster = shadow_caster(mesh);
  EXPECT_EQ(caster.closed.size(), of_sphere);
  EXPECT_EQ(caster.open.size(), 2U);
}

TEST(ShadowCaster, TakesASmallHoleForAFaultAndALargeOneForABorder) {
  Mesh mesh = test::sphere_mesh(1.0F, 24);
  const Mesh whole = mesh;
  mesh.triangles.erase(mesh.triangles.begin() + 400, mesh.triangles.begin() + 402);
  EXPECT_TRUE(shadow_caster(mesh).open.empty());
  mesh = whole;
  std::erase_if(mesh.triangles, [&](const auto& t) { return mesh.positions[t[0]].y > 0.5F; });
  EXPECT_TRUE(shadow_caster(mesh).closed.empty());
}

}  // namespace
}  // namespace luminist
