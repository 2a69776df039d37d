#include "rays/surface_rays.h"

#include <gtest/gtest.h>

#include <limits>

#include <glm/gtc/matrix_transform.hpp>

#include "support/fixtures.h"

namespace luminist {
namespace {

/// Two squares of half side 1 across the z axis, "far" at z = 0 and "near" at z = 1, twice as large.
Scene two_squares() {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{-1.0F, -1.0F, 0.0F}, {1.0F, -1.0F, 0.0F}, {1.0F, 1.0F, 0.0F}, {-1.0F, 1.0F, 0.0F}};
  mesh.normals.assign(4, Vec3(0.0F, 0.0F, 1.0F));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes.push_back(mesh);
  scene.materials.emplace_back();
  Object far_square;
  far_square.name = "far";
  Object near_square;
  near_square.name = "near";
  near_square.world_from_object =
      glm::scale(glm::translate(Mat4(1.0F), Vec3(0.0F, 0.0F, 1.0F)), Vec3(2.0F, 2.0F, 1.0F));
  scene.objects = {far_square, near_square};
  return scene;
}

Ray down_at(float x, float y) {
  return {{x, y, 3.0F}, {0.0F, 0.0F, -2.0F}, 0.0F, 10.0F};
}

TEST(SurfaceRays, MeetTheNearestObjectAndSayWhereOnItsMesh) {
  const Scene scene = two_squares();
  LUM_ASSERT_OK(const SurfaceRays rays, SurfaceRays::create(scene));
  const auto hit = rays.first(down_at(1.0F, 0.5F));
  ASSERT_TRUE(hit.hit());
  EXPECT_EQ(hit.object, 1U);
  EXPECT_FLOAT_EQ(hit.distance, 1.0F);  // in lengths of the way
  Vec3 place(0.0F);
  for (int corner = 0; corner < 3; ++corner) {
    place += hit.weights()[corner] * scene.meshes[0].positions[scene.meshes[0].triangles[hit.triangle][corner]];
  }
  EXPECT_NEAR(place.x, 0.5F, 1e-6F);  // single precision
  EXPECT_NEAR(place.y, 0.25F, 1e-6F);
}

TEST(SurfaceRays, PassThroughTheObjectsThatAreNotAskedFor) {
  LUM_ASSERT_OK(const SurfaceRays rays, SurfaceRays::create(two_squares()));
  const auto hit = rays.first(down_at(0.5F, 0.5F), 0);
  ASSERT_TRUE(hit.hit());
  EXPECT_EQ(hit.object, 0U);
  EXPECT_FLOAT_EQ(hit.distance, 1.5F);
  EXPECT_FALSE(rays.first(down_at(1.5F, 0.5F), 0).hit());
}

TEST(SurfaceRays, MeetBothSidesAndNothingBeyondTheirEnds) {
  LUM_ASSERT_OK(const SurfaceRays rays, SurfaceRays::create(two_squares()));
  EXPECT_TRUE(rays.first({{0.0F, 0.1F, -3.0F}, {0.0F, 0.0F, 1.0F}, 0.0F, 10.0F}).hit());
  EXPECT_FALSE(rays.first({{0.0F, 0.1F, -3.0F}, {0.0F, 0.0F, 1.0F}, 0.0F, 2.9F}).hit());
  const auto past_near = rays.first({{0.0F, 0.1F, 3.0F}, {0.0F, 0.0F, -1.0F}, 2.5F, 10.0F});
  ASSERT_TRUE(past_near.hit());
  EXPECT_EQ(past_near.object, 0U);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(rays.first({{nan, 0.0F, 3.0F}, {0.0F, 0.0F, -1.0F}, 0.0F, 10.0F}).hit());
}

TEST(SurfaceRays, SeeTheMeshAndNotTheOneThatCastsItsShadow) {
  Scene scene = two_squares();
  Mesh small = scene.meshes[0];
  for (Vec3& p : small.positions) p *= 0.1F;
  scene.meshes.push_back(small);
  scene.objects[1].shadow_mesh = 1;
  LUM_ASSERT_OK(const SurfaceRays rays, SurfaceRays::create(scene));
  const auto hit = rays.first(down_at(1.0F, 1.0F));
  ASSERT_TRUE(hit.hit());
  EXPECT_EQ(hit.object, 1U);
}

}  // namespace
}  // namespace luminist
