#include "app/light_pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/fixtures.h"

namespace luminist {
namespace {

Camera camera() {
  Camera camera;
  camera.fov_y = 1.0F;
  camera.world_from_camera[3] = Vec4(0.0F, 0.0F, 5.0F, 1.0F);  // looks along -z
  return camera;
}

/// A wall at z = 0, seen in 40 x 30 pixels, one unit a pixel.
SurfaceBuffer wall() {
  SurfaceBuffer surface;
  surface.width = 40;
  surface.height = 30;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      surface.position.emplace_back(x - 20, 15 - y, 0);
      surface.object.push_back(1);
    }
  }
  return surface;
}

TEST(LightPose, ThePointInFrontOfTheCameraIsInTheMiddle) {
  const auto at = project(camera(), Vec3(0.0F), 640, 480);
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->x, 320.0F, 1e-3F);  // rounding of a projection in floats
  EXPECT_NEAR(at->y, 240.0F, 1e-3F);
  EXPECT_FALSE(project(camera(), Vec3(0.0F, 0.0F, 6.0F), 640, 480)) << "behind the eye";
}

TEST(LightPose, ADragFollowsThePointer) {
  const Vec3 point(0.4F, -0.3F, 1.0F);
  const auto before = project(camera(), point, 640, 480);
  const auto after = project(camera(), dragged(camera(), point, Vec2(30.0F, -12.0F), 480), 640, 480);
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(after->x - before->x, 30.0F, 1e-2F);
  EXPECT_NEAR(after->y - before->y, -12.0F, 1e-2F);
}

TEST(LightPose, ALightShinesAtTheSurfaceNearestToItsAxis) {
  const LightPose pose{Vec3(3.0F, 4.0F, 10.0F), Vec3(0.0F, 0.0F, -1.0F)};
  const auto aim = aim_point(wall(), pose);
  ASSERT_TRUE(aim);
  EXPECT_EQ(*aim, Vec3(3.0F, 4.0F, 0.0F));
  EXPECT_FALSE(aim_point(wall(), {pose.position, Vec3(0.0F, 0.0F, 1.0F)})) << "all of it lies behind";
}

TEST(LightPose, WhereALightGoesItsAimStays) {
  const Vec3 aim(1.0F, 2.0F, 3.0F);
  const LightPose moved = moved_to({Vec3(9.0F), Vec3(0.0F, -1.0F, 0.0F)}, Vec3(5.0F, 2.0F, 3.0F), aim);
  EXPECT_EQ(moved.position, Vec3(5.0F, 2.0F, 3.0F));
  EXPECT_NEAR(glm::length(*moved.direction - Vec3(-1.0F, 0.0F, 0.0F)), 0.0F, 1e-6F);
}

TEST(LightPose, TheBallPutsALightBackWhereItWas) {
  const Vec3 aim(0.5F, 0.0F, 0.0F);
  const Vec3 place(-1.0F, 2.0F, 1.5F);
  const Vec3 way = seen_from(camera(), aim, place);
  EXPECT_NEAR(glm::length(way), 1.0F, 1e-6F);
  EXPECT_NEAR(glm::length(place_at(camera(), aim, place, way) - place), 0.0F, 1e-5F);
}

TEST(LightPose, ALightWithoutAPlaceTurnsAroundTheSceneAtItsRim) {
  LUM_ASSERT_OK(const LightTypes types, LightTypes::load(AssetRoots::standard()));
  const SceneFrame scene{Vec3(1.0F, 0.0F, 0.0F), 3.0F};
  const Light sun = make_light(types, "sun", "sun", scene).value();
  const auto pose = pose_of(sun, scene);
  ASSERT_TRUE(pose && pose->direction);
  EXPECT_NEAR(glm::length(pose->position + 3.0F * *pose->direction - scene.center), 0.0F, 1e-5F);
  EXPECT_EQ(aim_point(wall(), *pose), scene.center);
  const LightPose turned = moved_to(*pose, scene.center + Vec3(0.0F, 9.0F, 0.0F), scene.center);
  EXPECT_NEAR(glm::length(*turned.direction - Vec3(0.0F, -1.0F, 0.0F)), 0.0F, 1e-6F);
  EXPECT_NEAR(glm::length(turned.position - scene.center - Vec3(0.0F, 3.0F, 0.0F)), 0.0F, 1e-5F);
  const std::vector<std::string> assigned = pose_assignments(sun, turned);
  ASSERT_EQ(assigned.size(), 1U) << "it has no place to be put at";
  EXPECT_TRUE(assigned.front().starts_with("lights/sun/direction=")) << assigned.front();
  EXPECT_EQ(rim_rays(turned).front().front(), turned.position);
}

}  // namespace
}  // namespace luminist
