#include "scene/framing.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "scene_file.h"

namespace luminist {
namespace {

/// The tetrahedron moved and scaled; sizes from micrometres to kilometres are met on the web.
std::string scaled_obj(double scale, double shift) {
  std::string obj;
  for (const Vec3& p : tetrahedron_points()) {
    obj += "v " + std::to_string(scale * p.x + shift) + " " + std::to_string(scale * p.y - shift) + " " +
           std::to_string(scale * p.z) + "\n";
  }
  return obj + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
}

/// The largest |x|, |y| in the picture, and the range of depths.
struct Extent {
  float x = 0.0F, y = 0.0F, nearest = 1.0F, farthest = 0.0F;
};

Extent extent_of(const Scene& scene, bool backdrops) {
  Extent extent;
  for (const Object& object : scene.objects) {
    if (object.backdrop != backdrops) continue;
    for (const Vec3& p : scene.meshes[static_cast<std::size_t>(object.mesh)].positions) {
      const Vec4 q = scene.cameras[0].clip_from_world(1.0F) * object.world_from_object * Vec4(p, 1.0F);
      if (q.w <= 0.0F) continue;  // behind the camera, where a floor goes on
      extent.x = std::max(extent.x, std::abs(q.x / q.w)), extent.y = std::max(extent.y, std::abs(q.y / q.w));
      extent.nearest = std::min(extent.nearest, q.z / q.w), extent.farthest = std::max(extent.farthest, q.z / q.w);
    }
  }
  return extent;
}

TEST(AutomaticCamera, FramesObjectsOfAnySizeAtAnyPlace) {
  for (const double scale : {0.001, 1.0, 1000.0}) {
    for (const double shift : {0.0, 50.0 * scale}) {
      SceneFile file("a.obj", scaled_obj(scale, shift));
      LUM_ASSERT_OK(const Scene scene, file.load());
      const Extent extent = extent_of(scene, false);
      // The wider way fills the picture up to the margin of 12 %; 6 printed decimals move the smallest scale by 1/1000.
      EXPECT_NEAR(std::max(extent.x, extent.y), 1.0F / 1.12F, 0.01F) << scale;
      EXPECT_GT(extent.nearest, 0.0F);
      EXPECT_LT(extent.farthest, 1.0F);
    }
  }
}

TEST(AutomaticCamera, LooksFromTheFrontTheRightAndAbove) {
  SceneFile file("a.obj", tetrahedron_obj());
  LUM_ASSERT_OK(const Scene scene, file.load());
  const Vec3 back(scene.cameras[0].world_from_camera[2]), up(scene.cameras[0].world_from_camera[1]);
  EXPECT_GT(back.z, 0.5F);
  EXPECT_GT(back.x, 0.2F);
  EXPECT_GT(back.y, 0.1F);
  EXPECT_GT(up.y, 0.9F);
  EXPECT_NEAR(glm::determinant(Mat3(scene.cameras[0].world_from_camera)), 1.0F, 1e-5F);
}

TEST(AutomaticCamera, HoldsAFlatSceneSeenFromTheEdge) {
  SceneFile file("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0.0 0\nf 1 2 3\nf 2 3 4\n");
  LUM_ASSERT_OK(const Scene scene, file.load());
  expect_sound(scene);
  EXPECT_LT(extent_of(scene, false).x, 1.0F);
}

TEST(Backdrops, StandUnderAndBehindTheScene) {
  SceneFile file("a.obj", scaled_obj(10.0, 3.0));
  LUM_ASSERT_OK(const Scene scene, file.load({.floor = true, .wall = true}));
  expect_sound(scene);
  ASSERT_EQ(scene.objects.size(), 3U);
  EXPECT_TRUE(scene.objects[1].backdrop && scene.objects[2].backdrop);
  const Mesh& floor = scene.meshes[static_cast<std::size_t>(scene.objects[1].mesh)];
  const Mesh& wall = scene.meshes[static_cast<std::size_t>(scene.objects[2].mesh)];
  const Box box = scene.bounds();
  for (const Vec3& n : floor.normals) EXPECT_NEAR(n.y, 1.0F, 1e-6F);
  EXPECT_LT(floor.bounds().hi.y, box.lo.y);
  EXPECT_GT(floor.bounds().hi.y, box.lo.y - 0.01F * scene.frame().radius);
  const Vec3 towards = wall.normals[0];
  EXPECT_NEAR(towards.y, 0.0F, 1e-6F);
  EXPECT_GT(glm::dot(towards, scene.cameras[0].position() - wall.positions[0]), 0.0F);  // it looks at the camera
  for (const float x : {box.lo.x, box.hi.x}) {
    for (const float z : {box.lo.z, box.hi.z})
      EXPECT_GT(glm::dot(towards, Vec3(x, box.lo.y, z) - wall.positions[0]), 0.0F);
  }
  EXPECT_LE(extent_of(scene, true).farthest, 1.0F);  // the far plane holds them
}

TEST(Backdrops, FillThePictureOfAWidePicture) {
  SceneFile file("a.obj", tetrahedron_obj());
  LUM_ASSERT_OK(const Scene scene, file.load({.floor = true, .wall = true}));
  const Camera& camera = scene.cameras[0];
  const Mat4 world_from_clip = glm::inverse(camera.clip_from_world(2.4F));
  for (const Vec2 corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(-1, 1), Vec2(1, 1)}) {
    const Vec4 far_point = world_from_clip * Vec4(corner, 1.0F, 1.0F);
    const Vec3 direction = glm::normalize(Vec3(far_point) / far_point.w - camera.position());
    bool hit = false;
    for (const Object& object : scene.objects) {
      if (!object.backdrop) continue;
      const Mesh& plane = scene.meshes[static_cast<std::size_t>(object.mesh)];
      const float t =
          glm::dot(plane.positions[0] - camera.position(), plane.normals[0]) / glm::dot(direction, plane.normals[0]);
      const Vec3 p = camera.position() + t * direction;
      const Box box = plane.bounds();
      const Vec3 slack(1e-3F);
      hit |= t > 0.0F && glm::all(glm::greaterThanEqual(p, box.lo - slack)) &&
             glm::all(glm::lessThanEqual(p, box.hi + slack));
    }
    EXPECT_TRUE(hit) << corner.x << " " << corner.y;
  }
}

TEST(Backdrops, MoveTheFarPlaneOfACameraFromTheFile) {
  const std::string camera = R"("cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.1,"zfar":6}}],)";
  const std::string nodes = R"([{"mesh":0,"children":[1]},{"camera":0,"translation":[0,1,5]}])";
  SceneFile file("a.gltf", tetrahedron_gltf(embedded_buffer(), camera, nodes));
  LUM_ASSERT_OK(const Scene alone, file.load());
  EXPECT_EQ(alone.cameras[0].far_plane, 6.0F);
  LUM_ASSERT_OK(const Scene scene, file.load({.floor = true, .wall = true}));
  EXPECT_EQ(scene.cameras[0].near_plane, 0.1F);
  EXPECT_LE(extent_of(scene, true).farthest, 1.0F);
}

TEST(Backdrops, AreNotAddedUnlessAsked) {
  SceneFile file("a.obj", tetrahedron_obj());
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_EQ(scene.objects.size(), 1U);
}

}  // namespace
}  // namespace luminist
