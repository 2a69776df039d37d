#include "scene/scene.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "scene_file.h"

namespace luminist {
namespace {

Scene two_tetrahedra() {
  Scene scene;
  Mesh mesh;
  mesh.positions = tetrahedron_points();
  mesh.triangles = tetrahedron_faces();
  scene.meshes.push_back(mesh);
  scene.materials.emplace_back();
  scene.objects.push_back({"a", 0, 0, Mat4(1.0F), false});
  scene.objects.push_back({"b", 0, 0, glm::translate(Mat4(1.0F), Vec3(9, 0, 0)), true});
  return scene;
}

TEST(Scene, BoundsLeaveOutBackdropsUnlessAsked) {
  const Scene scene = two_tetrahedra();
  EXPECT_EQ(scene.bounds().hi, Vec3(1.0F));
  EXPECT_EQ(scene.bounds(true).hi, Vec3(10, 1, 1));
}

TEST(Scene, BoundsOfBackdropsAloneAreTheirs) {
  Scene scene = two_tetrahedra();
  scene.objects.erase(scene.objects.begin());
  EXPECT_EQ(scene.bounds().lo, Vec3(9, 0, 0));
  EXPECT_EQ(scene.frame().center, Vec3(9.5F, 0.5F, 0.5F));
}

TEST(Scene, FrameHasAPositiveRadiusEvenForAPointOrNothing) {
  Scene scene = two_tetrahedra();
  EXPECT_FLOAT_EQ(scene.frame().radius, 0.5F * std::sqrt(3.0F));
  scene.meshes[0].positions.assign(4, Vec3(2.0F));
  EXPECT_EQ(scene.frame().radius, 1.0F);
  EXPECT_EQ(Scene().frame().radius, 1.0F);
}

TEST(Scene, CountsTheTrianglesOfEveryInstance) {
  EXPECT_EQ(two_tetrahedra().triangle_count(), 8U);
}

TEST(Scene, FindsCamerasByName) {
  Scene scene;
  scene.cameras = {{.name = "front"}, {.name = "side"}};
  EXPECT_EQ(scene.find_camera("side"), &scene.cameras[1]);
  EXPECT_EQ(scene.find_camera("back"), nullptr);
}

TEST(Camera, MapsItsNearAndFarPlanesToZeroAndOne) {
  Camera camera;
  camera.world_from_camera = glm::translate(Mat4(1.0F), Vec3(1, 2, 3));
  camera.near_plane = 0.5F, camera.far_plane = 20.0F, camera.fov_y = 1.0F;
  const Mat4 clip = camera.clip_from_world(2.0F);
  const auto project = [&](const Vec3& p) {
    const Vec4 q = clip * Vec4(p, 1.0F);
    return Vec3(q) / q.w;
  };
  EXPECT_NEAR(project({1, 2, 2.5F}).z, 0.0F, 1e-6F);
  EXPECT_NEAR(project({1, 2, -17}).z, 1.0F, 1e-6F);
  const float top = 4.0F * std::tan(0.5F);  // half the field of view, four units away
  EXPECT_NEAR(project({1, 2 + top, -1}).y, 1.0F, 1e-5F);
  EXPECT_NEAR(project({1 + 2.0F * top, 2, -1}).x, 1.0F, 1e-5F);
}

}  // namespace
}  // namespace luminist
