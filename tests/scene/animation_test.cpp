#include "scene/animation.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "scene_file.h"

namespace luminist {
namespace {

constexpr float kRounding = 1e-5F;  // of positions near 1 through a few matrices

Vec3 place_of(const Animation& animation, double seconds, std::size_t node) {
  return Vec3(animation.worlds_at(seconds)[node][3]);
}

Track moves(int node, Track::Interpolation how, std::vector<float> times, std::vector<Vec4> values) {
  return {node, Track::Property::kTranslation, how, std::move(times), std::move(values)};
}

/// An arm that turns by a right angle around z in two seconds, and a hand at its end that rises.
Scene waving() {
  Scene scene;
  Mesh mesh;
  mesh.positions = tetrahedron_points();
  mesh.triangles = tetrahedron_faces();
  compute_normals(mesh, 0.5);
  scene.meshes.push_back(mesh);
  scene.materials.push_back({.name = "plain"});
  Node arm, hand;
  arm.name = "arm";
  arm.scale = Vec3(2.0F);
  hand.name = "hand";
  hand.parent = 0;
  hand.translation = Vec3(1.0F, 0.0F, 0.0F);
  scene.animation.nodes = {arm, hand};
  const float half = std::sqrt(0.5F);
  scene.animation.tracks.push_back({0,
                                    Track::Property::kRotation,
                                    Track::Interpolation::kLinear,
                                    {0.0F, 2.0F},
                                    {Vec4(0, 0, 0, 1), Vec4(0, 0, half, half)}});
  scene.animation.tracks.push_back(
      moves(1, Track::Interpolation::kStep, {0.0F, 1.5F}, {Vec4(1, 0, 0, 0), Vec4(1, 0, 3, 0)}));
  const std::vector<Mat4> rest = scene.animation.worlds_at_rest();
  scene.objects.push_back({.name = "glove", .world_from_object = rest[1], .mount = {.node = 1}});
  scene.objects.push_back({.name = "stone", .world_from_object = glm::translate(Mat4(1.0F), Vec3(5, 0, 0))});
  scene.cameras.push_back({.name = "seen from the hand",
                           .world_from_camera = without_scale(rest[1]),
                           .near_plane = 0.0F,
                           .far_plane = 0.0F,
                           .mount = {.node = 1}});
  scene.lights.push_back(
      {.name = "torch", .position = Vec3(2, 1, 0), .direction = Vec3(1, 0, 0), .mount = {.node = 1}});
  hang(scene);
  return scene;
}

TEST(Animation, StandsStillBeforeItsFirstAndAfterItsLastKey) {
  const Animation animation{{Node{}}, {moves(0, Track::Interpolation::kLinear, {1.0F, 3.0F}, {Vec4(1), Vec4(5)})}};
  EXPECT_EQ(place_of(animation, 0.0, 0), Vec3(1.0F));
  EXPECT_EQ(place_of(animation, 2.0, 0), Vec3(3.0F));
  EXPECT_EQ(place_of(animation, 9.0, 0), Vec3(5.0F));
  EXPECT_EQ(animation.seconds(), 3.0);
}

TEST(Animation, StepsKeepTheValueOfTheLastKey) {
  const Animation animation{{Node{}}, {moves(0, Track::Interpolation::kStep, {0.0F, 1.0F}, {Vec4(1), Vec4(5)})}};
  EXPECT_EQ(place_of(animation, 0.99, 0), Vec3(1.0F));
  EXPECT_EQ(place_of(animation, 1.0, 0), Vec3(5.0F));
}

TEST(Animation, SplinesLeaveAndArriveAlongTheirTangents) {
  // Two seconds from 0 to 1, leaving at 1 and arriving at -1 units a second: half-way (0 + 1) / 2 + 2 / 8 (1 - -1).
  const std::vector<Vec4> values{Vec4(0), Vec4(0), Vec4(1), Vec4(-1), Vec4(1), Vec4(0)};
  const Animation animation{{Node{}}, {moves(0, Track::Interpolation::kCubic, {0.0F, 2.0F}, values)}};
  EXPECT_NEAR(place_of(animation, 1.0, 0).x, 1.0F, kRounding);
  EXPECT_EQ(place_of(animation, 2.0, 0), Vec3(1.0F));
}

TEST(Animation, RotationsTakeTheShorterArc) {
  const float half = std::sqrt(0.5F);
  Animation animation{{Node{}}, {}};
  // The same quarter turn with the sign that goes the long way round.
  animation.tracks.push_back({0,
                              Track::Property::kRotation,
                              Track::Interpolation::kLinear,
                              {0.0F, 1.0F},
                              {Vec4(0, 0, 0, 1), Vec4(0, 0, -half, -half)}});
  const Vec3 turned = Vec3(animation.worlds_at(0.5)[0] * Vec4(1, 0, 0, 0));
  EXPECT_NEAR(glm::distance(turned, Vec3(half, half, 0)), 0.0F, kRounding);
}

TEST(Pose, MovesWhatHangsFromANodeAndNothingElse) {
  Scene scene = waving();
  const Scene rest = scene;
  pose(scene, 2.0);
  const Vec3 hand(0.0F, 2.0F, 6.0F);  // two units up the turned arm, three risen, doubled
  EXPECT_NEAR(glm::distance(Vec3(scene.objects[0].world_from_object[3]), hand), 0.0F, kRounding);
  EXPECT_EQ(scene.objects[1].world_from_object, rest.objects[1].world_from_object);
  EXPECT_NEAR(glm::distance(scene.cameras[0].position(), hand), 0.0F, kRounding);
  EXPECT_NEAR(std::abs(glm::determinant(Mat3(scene.cameras[0].world_from_camera))), 1.0F, kRounding);
  EXPECT_NEAR(glm::distance(scene.lights[0].direction, Vec3(0, 1, 0)), 0.0F, kRounding);
  EXPECT_NEAR(glm::distance(scene.lights[0].position, hand + Vec3(-1, 0, 0)), 0.0F, kRounding);
  EXPECT_EQ(scene.frame().center, rest.frame().center);
  EXPECT_EQ(scene.frame().radius, rest.frame().radius);
}

TEST(Pose, ComesBackToWhereItWas) {
  Scene scene = waving();
  const Mat4 rest = scene.objects[0].world_from_object;
  pose(scene, 2.0);
  pose(scene, 0.0);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(glm::distance(scene.objects[0].world_from_object[i], rest[i]), 0.0F, kRounding);
  }
}

TEST(Pose, CamerasThatMoveKeepEverythingBetweenTheirPlanes) {
  Scene scene = waving();
  pose(scene, 0.0);
  const float near = scene.cameras[0].far_plane;
  scene.animation.tracks[1].values[1] = Vec4(1, 0, 50, 0);
  pose(scene, 2.0);
  EXPECT_GT(scene.cameras[0].far_plane, 100.0F);  // the hand is doubled
  EXPECT_LT(near, 100.0F);
}

TEST(Animation, IsTheSameInTheFileThatIsWritten) {
  Scene scene = waving();
  SceneFile file("a.glb", "");
  LUM_EXPECT_OK(save_scene(scene, file.path()));
  LUM_ASSERT_OK(Scene loaded, file.load());
  EXPECT_EQ(file.warnings(), 0U);
  ASSERT_EQ(loaded.objects.size(), 2U);
  EXPECT_EQ(loaded.objects[0].name, "glove");
  for (const double seconds : {0.0, 0.7, 1.6, 5.0}) {
    pose(scene, seconds);
    pose(loaded, seconds);
    for (std::size_t o = 0; o < 2; ++o) {
      for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(glm::distance(scene.objects[o].world_from_object[i], loaded.objects[o].world_from_object[i]), 0.0F,
                    kRounding);
      }
    }
    EXPECT_NEAR(glm::distance(scene.cameras[0].position(), loaded.cameras[0].position()), 0.0F, kRounding);
    EXPECT_NEAR(glm::distance(scene.lights[0].direction, loaded.lights[0].direction), 0.0F, kRounding);
  }
}

/// A tetrahedron whose node rises by its own buffer's positions: 4 keys need 4 times, of which it has none that ascend.
std::string with_animation(const std::string& samplers, const std::string& channels) {
  return tetrahedron_gltf(embedded_buffer(),
                          R"("animations":[{"samplers":[)" + samplers + R"(],"channels":[)" + channels + R"(]}],)");
}

TEST(GltfAnimation, SaysWhichKeysAreWrong) {
  const std::string channel = R"({"sampler":0,"target":{"node":0,"path":"translation"}})";
  SceneFile file("a.gltf", with_animation(R"({"input":1,"output":0})", channel));
  EXPECT_NE(error_of(file.load()).message().find("animations[0].channels[0].input"), std::string::npos);
  SceneFile missing("b.gltf", with_animation(R"({"input":7,"output":0})", channel));
  EXPECT_EQ(error_of(missing.load()).kind, ErrorKind::kBadContent);
  SceneFile unknown("c.gltf", with_animation(R"({"input":1,"output":0,"interpolation":"WOBBLE"})", channel));
  EXPECT_NE(error_of(unknown.load()).message().find("WOBBLE"), std::string::npos);
}

TEST(GltfAnimation, LeavesOutWeightsOfNoMorphsWithAWarning) {
  SceneFile file("a.gltf",
                 with_animation(R"({"input":1,"output":0})", R"({"sampler":0,"target":{"node":0,"path":"weights"}})"));
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_NE(file.warning().find("weights"), std::string::npos);
  EXPECT_TRUE(scene.animation.empty());
  EXPECT_TRUE(scene.animation.nodes.empty());
}

}  // namespace
}  // namespace luminist
