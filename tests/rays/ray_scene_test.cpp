#include "rays/ray_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "rays/surface_rays.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

/// A square of half side `half` in the plane z = 0 of its object, and where it stands.
Scene square_scene(float half, const Mat4& world_from_object) {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{-half, -half, 0.0F}, {half, -half, 0.0F}, {half, half, 0.0F}, {-half, half, 0.0F}};
  mesh.normals.assign(4, Vec3(0.0F, 0.0F, 1.0F));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes.push_back(mesh);
  scene.materials.emplace_back();
  Object object;
  object.world_from_object = world_from_object;
  scene.objects.push_back(object);
  return scene;
}

unsigned char blocked(const RayScene& rays, const Vec3& from, const Vec3& to) {
  const Segment segment{from, to};
  unsigned char answer = 2;
  rays.occluded({&segment, 1}, {&answer, 1});
  return answer;
}

TEST(RayScene, BlocksWhatCrossesATriangleAndNothingElse) {
  LUM_ASSERT_OK(const RayScene rays, RayScene::create(square_scene(1.0F, Mat4(1.0F))));
  EXPECT_EQ(blocked(rays, {0.2F, 0.1F, 1.0F}, {0.2F, 0.1F, -1.0F}), 1);
  EXPECT_EQ(blocked(rays, {0.2F, 0.1F, -1.0F}, {0.2F, 0.1F, 1.0F}), 1) << "from the back as well";
  EXPECT_EQ(blocked(rays, {1.2F, 0.1F, 1.0F}, {1.2F, 0.1F, -1.0F}), 0) << "passes beside it";
  EXPECT_EQ(blocked(rays, {0.2F, 0.1F, 2.0F}, {0.2F, 0.1F, 1.0F}), 0) << "ends before it";
}

TEST(RayScene, DoesNotCountSurfacesAtTheEndsOfASegment) {
  LUM_ASSERT_OK(const RayScene rays, RayScene::create(square_scene(1.0F, Mat4(1.0F))));
  EXPECT_EQ(blocked(rays, {0.2F, 0.1F, 3.0F}, {0.3F, 0.1F, 0.0F}), 0);
  EXPECT_EQ(blocked(rays, {0.2F, 0.1F, 0.0F}, {0.3F, 0.1F, 3.0F}), 0);
}

TEST(RayScene, ALightFarAwayIsBlockedAsNearToTheReceiverAsALampIs) {
  LUM_ASSERT_OK(const RayScene rays, RayScene::create(square_scene(1.0F, Mat4(1.0F))));
  const Vec3 receiver(0.2F, 0.1F, -0.001F);  // a thousandth of the square below it
  for (const float distance : {1.0F, 3e3F, 1e6F}) {
    const Vec3 light = receiver + distance * glm::normalize(Vec3(0.3F, 0.2F, 1.0F));
    EXPECT_EQ(blocked(rays, light, receiver), 1) << distance;
    EXPECT_TRUE(rays.blocked({light, receiver})) << distance;
    EXPECT_EQ(blocked(rays, light, {0.2F, 0.1F, 0.0F}), 0) << "it does not block itself, " << distance;
    EXPECT_EQ(blocked(rays, light, {1.2F, 0.1F, -0.001F}), 0) << "passes beside it, " << distance;
  }
}

TEST(RayScene, PlacesObjectsInTheWorld) {
  Mat4 lifted(1.0F);
  lifted[3] = Vec4(5.0F, 0.0F, 2.0F, 1.0F);
  LUM_ASSERT_OK(const RayScene rays, RayScene::create(square_scene(1.0F, lifted)));
  EXPECT_EQ(blocked(rays, {0.0F, 0.0F, 4.0F}, {0.0F, 0.0F, -4.0F}), 0);
  EXPECT_EQ(blocked(rays, {5.0F, 0.0F, 4.0F}, {5.0F, 0.0F, -4.0F}), 1);
  EXPECT_EQ(blocked(rays, {5.0F, 0.0F, 1.0F}, {5.0F, 0.0F, -4.0F}), 0);
}

/// The surface of the cube of half side `half`, wound outwards.
Mesh cube_mesh(float half) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.emplace_back(i % 2 == 0 ? -half : half, i / 2 % 2 == 0 ? -half : half, i < 4 ? -half : half);
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  for (const Vec3& p : mesh.positions) mesh.normals.push_back(glm::normalize(p));
  return mesh;
}

TEST(RayScene, ShadowMeshBlocksWhatGoesThroughItAndNotWhatEndsInIt) {
  Mat4 mirrored(1.0F);
  mirrored[0][0] = -1.0F;
  for (const Mat4& place : {Mat4(1.0F), mirrored}) {
    Scene scene = square_scene(1.0F, place);
    scene.meshes.push_back(cube_mesh(0.5F));
    scene.objects[0].shadow_mesh = 1;
    LUM_ASSERT_OK(const RayScene rays, RayScene::create(scene));
    EXPECT_GT(rays.shadow_slack(0), 0.0F);
    EXPECT_EQ(rays.shadow_slack(1), 0.0F) << "there is no such object";
    EXPECT_EQ(blocked(rays, {0.1F, 0.2F, 3.0F}, {0.2F, 0.1F, -3.0F}), 1) << "through the cube";
    EXPECT_EQ(blocked(rays, {0.1F, 0.2F, 3.0F}, {0.2F, 0.1F, 0.4F}), 0) << "into the cube: its object is lit";
    EXPECT_EQ(blocked(rays, {0.1F, 0.2F, 0.2F}, {0.2F, 0.1F, 3.0F}), 1) << "a light in the cube lights nothing outside";
    EXPECT_EQ(blocked(rays, {0.8F, 0.2F, 3.0F}, {0.8F, 0.1F, -3.0F}), 0) << "the square itself blocks nothing";
  }
}

TEST(RayScene, ShadowMeshWithABorderBlocksOnBothSides) {
  Scene scene = square_scene(1.0F, Mat4(1.0F));
  scene.meshes.push_back(square_scene(0.5F, Mat4(1.0F)).meshes[0]);
  scene.objects[0].shadow_mesh = 1;
  LUM_ASSERT_OK(const RayScene rays, RayScene::create(scene));
  EXPECT_EQ(blocked(rays, {0.1F, 0.2F, 3.0F}, {0.2F, 0.1F, -3.0F}), 1);
  EXPECT_EQ(blocked(rays, {0.1F, 0.2F, -3.0F}, {0.2F, 0.1F, 3.0F}), 1);
  EXPECT_EQ(blocked(rays, {0.8F, 0.2F, 3.0F}, {0.8F, 0.1F, -3.0F}), 0);
}

TEST(RayScene, TakesSegmentsThatAreNotFiniteOrHaveNoLengthAsFree) {
  LUM_ASSERT_OK(const RayScene rays, RayScene::create(square_scene(1.0F, Mat4(1.0F))));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(blocked(rays, {0.0F, 0.0F, nan}, {0.0F, 0.0F, -1.0F}), 0);
  EXPECT_EQ(blocked(rays, {0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, -infinity}), 0);
  EXPECT_EQ(blocked(rays, {0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 1.0F}), 0);
  EXPECT_EQ(blocked(rays, {0.0F, 0.0F, 1e30F}, {0.0F, 0.0F, 1.0F}), 0);
  EXPECT_EQ(blocked(rays, {1e20F, 0.0F, 1.0F}, {1e20F, 0.0F, -1.0F}), 0);
}

TEST(SurfaceRays, TheClosestHitNamesObjectTriangleAndPlace) {
  Scene scene = square_scene(1.0F, Mat4(1.0F));
  Object behind = scene.objects.front();
  behind.world_from_object[3] = Vec4(0.0F, 0.0F, -1.0F, 1.0F);
  scene.objects.insert(scene.objects.begin(), behind);
  LUM_ASSERT_OK(const SurfaceRays rays, SurfaceRays::create(scene));
  const RayHit hit = rays.first({{0.5F, -0.5F, 3.0F}, {0.0F, 0.0F, -2.0F}});
  ASSERT_TRUE(hit.hit());
  EXPECT_EQ(hit.object, 1U) << "the nearer one, by its place in the scene";
  EXPECT_EQ(hit.triangle, 0U);
  EXPECT_NEAR(hit.distance, 1.5F, 1e-6F) << "in lengths of the direction";
  // p = (1 - u - v) p0 + u p1 + v p2 with p0 = (-1, -1), p1 = (1, -1), p2 = (1, 1).
  EXPECT_NEAR(-1.0F + 2.0F * (hit.u + hit.v), 0.5F, 1e-6F);
  EXPECT_NEAR(-1.0F + 2.0F * hit.v, -0.5F, 1e-6F);
  EXPECT_FALSE(rays.first({{3.0F, 0.0F, 3.0F}, {0.0F, 0.0F, -1.0F}}).hit());
  EXPECT_FALSE(rays.first({{0.0F, 0.0F, 3.0F}, {0.0F, 0.0F, std::nanf("")}}).hit());
}

TEST(RayScene, AnEmptySceneBlocksNothing) {
  LUM_ASSERT_OK(const RayScene rays, RayScene::create(Scene{}));
  EXPECT_EQ(blocked(rays, {0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, -1.0F}), 0);
}

TEST(RayScene, AgreesWithThePlaneForManyRandomSegmentsAndRepeatsItsBits) {
  LUM_ASSERT_OK(const RayScene rays, RayScene::create(square_scene(1.0F, Mat4(1.0F))));
  std::mt19937 random(7);
  std::uniform_real_distribution<float> coordinate(-2.0F, 2.0F);
  std::vector<Segment> segments(1003);  // not a multiple of the packet
  for (Segment& s : segments) {
    s.from = {coordinate(random), coordinate(random), coordinate(random)};
    s.to = {coordinate(random), coordinate(random), coordinate(random)};
  }
  std::vector<unsigned char> first(segments.size());
  std::vector<unsigned char> again(segments.size());
  rays.occluded(segments, first);
  rays.occluded(segments, again);
  EXPECT_EQ(first, again);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Vec3 a = segments[i].from;
    const Vec3 b = segments[i].to;
    const float t = a.z / (a.z - b.z);
    const Vec3 hit = a + t * (b - a);
    const float rim = std::max(std::abs(hit.x), std::abs(hit.y));
    ASSERT_EQ(rays.blocked(segments[i]), first[i] != 0) << i;
    if (std::abs(rim - 1.0F) < 1e-4F || std::abs(t) < 1e-4F || std::abs(t - 1.0F) < 1e-4F)
      continue;  // rounding decides
    EXPECT_EQ(first[i], t > 0.0F && t < 1.0F && rim < 1.0F ? 1 : 0) << "segment " << i;
  }
}

}  // namespace
}  // namespace luminist
