#include "scene/deform.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene_file.h"

namespace luminist {
namespace {

constexpr float kDeformRounding = 1e-5F;

/// A glTF file with one mesh of two triangles, a strip from y = 0 over y = 1 to y = 2, written accessor by accessor.
class StripFile {
 public:
  /// side: 1, or -1 for normals that look to the back.
  explicit StripFile(float side = 1.0F) {
    positions_ = add({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0}, "VEC3");
    normals_ = add({0, 0, side, 0, 0, side, 0, 0, side, 0, 0, side, 0, 0, side, 0, 0, side}, "VEC3");
  }
  /// returns the accessor's number.
  int add(const std::vector<float>& numbers, const std::string& type) {
    const std::size_t size = type == "SCALAR" ? 1 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
    const std::size_t start = bytes_.size();
    for (const float number : numbers) append_raw(bytes_, number);
    if (!accessors_.empty()) accessors_ += ",", views_ += ",";
    accessors_ += R"({"bufferView":)" + std::to_string(count_) + R"(,"componentType":5126,"count":)" +
                  std::to_string(numbers.size() / size) + R"(,"type":")" + type + "\"}";
    views_ += R"({"buffer":0,"byteOffset":)" + std::to_string(start) + R"(,"byteLength":)" +
              std::to_string(bytes_.size() - start) + "}";
    return count_++;
  }
  [[nodiscard]] std::string text(const std::string& attributes, const std::string& primitive, const std::string& nodes,
                                 const std::string& more) const {
    return R"({"asset":{"version":"2.0"},"scene":0,"meshes":[{"primitives":[{"mode":5,"attributes":{"POSITION":)" +
           std::to_string(positions_) + R"(,"NORMAL":)" + std::to_string(normals_) + attributes + "}" + primitive +
           R"(}]}],"nodes":)" + nodes + R"(,"scenes":[{"nodes":[0,1]}],)" + more + R"("accessors":[)" + accessors_ +
           R"(],"bufferViews":[)" + views_ + R"(],"buffers":[{"byteLength":)" + std::to_string(bytes_.size()) +
           R"(,"uri":"data:application/octet-stream;base64,)" + base64(bytes_) + R"("}]})";
  }

 private:
  int positions_ = 0;
  int normals_ = 0;
  int count_ = 0;
  std::string bytes_, accessors_, views_;
};

/// The lower two thirds hang from a root, the upper end from an elbow at y = 1 that turns by 90 degrees around x in a
/// second. The middle goes half with each.
std::string bending(float share) {
  StripFile file;
  const int joints = file.add({0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  const int weights =
      file.add({1, 0, 0, 0, 1, 0, 0, 0, share, share, 0, 0, share, share, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0}, "VEC4");
  std::vector<float> binds(32, 0.0F);
  for (std::size_t i = 0; i < 4; ++i) binds[5 * i] = binds[16 + 5 * i] = 1.0F;
  binds[16 + 13] = -1.0F;  // the elbow stands at y = 1
  const int inverse = file.add(binds, "MAT4");
  const int times = file.add({0, 1}, "SCALAR");
  const float half = std::sqrt(0.5F);
  const int turns = file.add({0, 0, 0, 1, half, 0, 0, half}, "VEC4");
  const std::string nodes =
      R"([{"name":"strip","mesh":0,"skin":0,"translation":[50,0,0]},{"name":"root","children":[2]},)"
      R"({"name":"elbow","translation":[0,1,0]}])";
  return file.text(R"(,"JOINTS_0":)" + std::to_string(joints) + R"(,"WEIGHTS_0":)" + std::to_string(weights), "", nodes,
                   R"("skins":[{"joints":[1,2],"inverseBindMatrices":)" + std::to_string(inverse) +
                       R"(}],"animations":[{"samplers":[{"input":)" + std::to_string(times) + R"(,"output":)" +
                       std::to_string(turns) +
                       R"(}],"channels":[{"sampler":0,"target":{"node":2,"path":"rotation"}}]}],)");
}

/// Two targets: one lifts the upper end by 1 in z, the other widens everything to the right; weights by a track.
std::string morphing(const std::string& interpolation, const std::vector<float>& values, const std::string& node) {
  StripFile file;
  const int lift = file.add({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1}, "VEC3");
  const int widen = file.add({0, 0, 0, 2, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 2, 0, 0}, "VEC3");
  const int times = file.add({0, 1}, "SCALAR");
  const int weights = file.add(values, "SCALAR");
  return file.text(
      "", R"(,"targets":[{"POSITION":)" + std::to_string(lift) + R"(},{"POSITION":)" + std::to_string(widen) + "}]",
      R"([{"name":"strip","mesh":0)" + node + R"(},{"name":"other"}])",
      R"("animations":[{"samplers":[{"input":)" + std::to_string(times) + R"(,"output":)" + std::to_string(weights) +
          R"(,"interpolation":")" + interpolation +
          R"("}],"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}]}],)");
}

/// Where the strip's vertex number i is in the world.
Vec3 vertex(const Scene& scene, std::size_t i) {
  return Vec3(scene.objects[0].world_from_object * Vec4(scene.meshes[0].positions[i], 1.0F));
}
void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_NEAR(glm::distance(a, b), 0.0F, kDeformRounding) << a.x << " " << a.y << " " << a.z;
}

TEST(Skin, BendsWithItsJointsWhereverTheNodeOfItsMeshIs) {
  SceneFile file("a.gltf", bending(0.5F));
  LUM_ASSERT_OK(Scene scene, file.load());
  EXPECT_EQ(file.warnings(), 0U);
  expect_near(vertex(scene, 5), Vec3(1, 2, 0));  // joints place it, not its node
  pose(scene, 1.0);
  expect_near(vertex(scene, 0), Vec3(0, 0, 0));
  expect_near(vertex(scene, 2), Vec3(0, 1, 0));
  expect_near(vertex(scene, 5), Vec3(1, 1, 1));
  expect_near(scene.meshes[0].normals[5], Vec3(0, -1, 0));
  expect_near(scene.meshes[0].normals[0], Vec3(0, 0, 1));
  pose(scene, 0.0);
  expect_near(vertex(scene, 5), Vec3(1, 2, 0));
}

TEST(Skin, WeightsThatDoNotAddUpAreShares) {
  SceneFile file("a.gltf", bending(3.0F));
  LUM_ASSERT_OK(Scene scene, file.load());
  pose(scene, 1.0);
  expect_near(vertex(scene, 2), Vec3(0, 1, 0));
  expect_near(vertex(scene, 4), Vec3(0, 1, 1));
}

TEST(Skin, TheSceneKeepsTheFrameThatItHasAtRest) {
  SceneFile file("a.gltf", bending(0.5F));
  LUM_ASSERT_OK(Scene scene, file.load());
  const SceneFrame rest = scene.frame();
  pose(scene, 1.0);
  EXPECT_EQ(scene.frame().radius, rest.radius);
  EXPECT_LT(scene.bounds().hi.y, 1.5F);
}

TEST(Skin, MatricesThatNoJointAsksForAreLeftOut) {
  StripFile file;
  std::vector<float> matrices(48, 0.0F);
  for (std::size_t i = 0; i < 12; ++i) matrices[16 * (i / 4) + 5 * (i % 4)] = 1.0F;
  const int joints = file.add(std::vector<float>(24, 0.0F), "VEC4");
  std::vector<float> shares(24, 0.0F);
  for (std::size_t i = 0; i < 6; ++i) shares[4 * i] = 1.0F;
  const int weights = file.add(shares, "VEC4");
  const int inverse = file.add(matrices, "MAT4");
  SceneFile loaded(
      "a.gltf", file.text(R"(,"JOINTS_0":)" + std::to_string(joints) + R"(,"WEIGHTS_0":)" + std::to_string(weights), "",
                          R"([{"name":"strip","mesh":0,"skin":0},{"name":"root","translation":[0,0,7]}])",
                          R"("skins":[{"joints":[1],"inverseBindMatrices":)" + std::to_string(inverse) + "}],"));
  LUM_ASSERT_OK(const Scene scene, loaded.load());
  expect_near(vertex(scene, 5), Vec3(1, 2, 7));
}

TEST(Skin, IsFramedWhereItsJointsHoldIt) {
  std::string text = bending(0.5F);
  const std::string root = R"({"name":"root",)";
  text.insert(text.find(root) + root.size(), R"("translation":[0,30,40],)");
  SceneFile file("a.gltf", text);
  LUM_ASSERT_OK(const Scene scene, file.load({.floor = true}));
  const Camera& camera = scene.cameras.front();
  const Vec3 seen(glm::inverse(camera.world_from_camera) * Vec4(scene.bounds().center(), 1.0F));
  EXPECT_NEAR(seen.x / seen.z, 0.0F, 0.1F);  // before the camera and about in the middle of its picture
  EXPECT_NEAR(seen.y / seen.z, 0.0F, 0.1F);
  EXPECT_LT(seen.z, 0.0F);
  EXPECT_NEAR(scene.bounds(true).lo.y, 30.0F, 0.01F);  // the floor is under it
}

TEST(Skin, AJointThatIsNotThereIsNamed) {
  std::string text = bending(0.5F);
  text.replace(text.find("\"joints\":[1,2]"), 14, "\"joints\":[1,7]");
  SceneFile file("a.gltf", text);
  EXPECT_EQ(error_of(file.load()).field, "skins[0].joints");
  std::string few = bending(0.5F);
  few.replace(few.find("\"joints\":[1,2]"), 14, "\"joints\":[1]");
  SceneFile fewer("b.gltf", few);
  EXPECT_EQ(error_of(fewer.load()).kind, ErrorKind::kBadContent);
}

TEST(Morph, TargetsAreAddedByTheirWeights) {
  SceneFile file("a.gltf", morphing("LINEAR", {0, 0, 1, 0.5F}, R"(,"translation":[0,0,5])"));
  LUM_ASSERT_OK(Scene scene, file.load());
  EXPECT_EQ(file.warnings(), 0U);
  expect_near(vertex(scene, 5), Vec3(1, 2, 5));
  pose(scene, 0.5);
  expect_near(vertex(scene, 5), Vec3(1.5F, 2, 5.5F));
  expect_near(vertex(scene, 0), Vec3(0, 0, 5));
  pose(scene, 7.0);
  expect_near(vertex(scene, 5), Vec3(2, 2, 6));
  // The upper half has risen by 45 degrees: its normals lean back, those of the lower end stay.
  expect_near(scene.meshes[0].normals[5], Vec3(0, -std::sqrt(0.5F), std::sqrt(0.5F)));
  expect_near(scene.meshes[0].normals[0], Vec3(0, 0, 1));
}

TEST(Morph, WhereNormalsLookInwardsThoseOfTheTargetsAreTurnedToo) {
  for (const float side : {1.0F, -1.0F}) {
    StripFile file(side);
    const int still = file.add(std::vector<float>(18, 0.0F), "VEC3");
    std::vector<float> lean(18, 0.0F);  // of every normal to the right
    for (std::size_t i = 0; i < 6; ++i) lean[3 * i] = side;
    const int leaning = file.add(lean, "VEC3");
    SceneFile loaded("a.gltf", file.text("",
                                         R"(,"targets":[{"POSITION":)" + std::to_string(still) + R"(,"NORMAL":)" +
                                             std::to_string(leaning) + "}]",
                                         R"([{"name":"strip","mesh":0,"weights":[1]},{"name":"other"}])", ""));
    LUM_ASSERT_OK(const Scene scene, loaded.load());
    EXPECT_EQ(loaded.warnings(), side < 0.0F ? 1U : 0U);
    expect_near(scene.meshes[0].normals[0], Vec3(std::sqrt(0.5F), 0, std::sqrt(0.5F)));
  }
}

TEST(Morph, StepsAndSplinesGoAsTheFormatSays) {
  SceneFile stepping("a.gltf", morphing("STEP", {0.25F, 0, 1, 0}, ""));
  LUM_ASSERT_OK(Scene scene, stepping.load());
  pose(scene, 0.9);
  expect_near(vertex(scene, 5), Vec3(1, 2, 0.25F));
  // One second from 0 to 1, leaving and arriving at rest: half-way at half time, 5/32 at a quarter.
  SceneFile curving("b.gltf", morphing("CUBICSPLINE", {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}, ""));
  LUM_ASSERT_OK(Scene curve, curving.load());
  pose(curve, 0.25);
  expect_near(vertex(curve, 5), Vec3(1, 2, 5.0F / 32.0F));
}

TEST(Morph, AReflectedNodeReflectsItsTargets) {
  SceneFile file("a.gltf", morphing("LINEAR", {0, 0, 0, 1}, R"(,"scale":[-1,1,1])"));
  LUM_ASSERT_OK(Scene scene, file.load());
  pose(scene, 1.0);
  Box box = scene.bounds();
  EXPECT_NEAR(box.lo.x, -3.0F, kDeformRounding);
  EXPECT_NEAR(box.hi.x, 0.0F, kDeformRounding);
}

TEST(Morph, WithoutATrackTheWeightsOfTheNodeHold) {
  std::string text = morphing("LINEAR", {0, 0, 1, 0}, R"(,"weights":[0.5,0])");
  text.erase(text.find("\"animations\""), text.find("\"accessors\"") - text.find("\"animations\""));
  SceneFile file("a.gltf", text);
  LUM_ASSERT_OK(const Scene scene, file.load());
  expect_near(vertex(scene, 5), Vec3(1, 2, 0.5F));
  EXPECT_TRUE(scene.animation.empty());
  EXPECT_TRUE(scene.deformers.empty());
}

}  // namespace
}  // namespace luminist
