#include "make_scene/recipes.h"

#include <gtest/gtest.h>

#include <set>

#include "base/files.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

std::string committed(const std::string& name) {
  return "meshes/" + name + "/" + name + ".glb";
}

Scene load_committed(const std::string& name) {
  Diagnostics diagnostics;
  auto scene = load_scene(committed(name), {}, diagnostics);
  EXPECT_TRUE(scene.has_value()) << (scene ? "" : scene.error().message());
  return scene ? std::move(*scene) : Scene{};
}

class CommittedScene : public testing::TestWithParam<std::string> {};

TEST_P(CommittedScene, HasACameraAndObjectsOfDifferentNames) {
  const Scene scene = load_committed(GetParam());
  ASSERT_FALSE(scene.cameras.empty());
  std::set<std::string> names;
  for (const Object& object : scene.objects) names.insert(object.name);
  EXPECT_EQ(names.size(), scene.objects.size());
  EXPECT_GE(names.size(), 4U);
  EXPECT_GE(scene.triangle_count(), 50000U);
}

TEST_P(CommittedScene, IsFiniteAndHasUnitNormals) {
  const Scene scene = load_committed(GetParam());
  for (const Mesh& mesh : scene.meshes) {
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      ASSERT_TRUE(is_finite(mesh.positions[i]));
      ASSERT_NEAR(glm::length(mesh.normals[i]), 1.0F, 1e-3F);  // the file's normals are rounded to 2^-14
    }
    for (const auto& t : mesh.triangles) {
      for (const std::uint32_t corner : t) ASSERT_LT(corner, mesh.positions.size());
    }
  }
}

TEST_P(CommittedScene, IsSmallEnoughToKeep) {
  LUM_ASSERT_OK(const std::string bytes, read_file(committed(GetParam())));
  EXPECT_LT(bytes.size(), 6U << 20U);
}

TEST_P(CommittedScene, HasARecipe) {
  EXPECT_NE(find_recipe(GetParam()), nullptr);
}

INSTANTIATE_TEST_SUITE_P(All, CommittedScene, testing::Values("bust", "creature", "room", "still_life"),
                         [](const auto& test) { return test.param; });

TEST(Recipes, AreTheCommittedScenes) {
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes()) names.push_back(recipe.name);
  EXPECT_EQ(names, (std::vector<std::string>{"bust", "creature", "room", "still_life"}));
  EXPECT_EQ(find_recipe("teapot"), nullptr);
}

TEST(Recipes, GiveTheCommittedBytes) {  // one scene, the quickest: together they take most of a minute
  const TemporaryFolder folder;
  const std::string path = folder.file("room.glb");
  LUM_EXPECT_OK(save_scene(build_room(), path));
  LUM_ASSERT_OK(const std::string made, read_file(path));
  LUM_ASSERT_OK(const std::string kept, read_file(committed("room")));
  EXPECT_EQ(content_hash(made), content_hash(kept)) << "run `make_scene --all meshes` and look at the scenes again";
}

TEST(Bust, IsOrganic) {
  const Scene scene = load_committed("bust");
  for (const Object& object : scene.objects) {
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
    EXPECT_TRUE(mesh.uvs.empty()) << object.name;
    if (object.name == "bust") {
      EXPECT_GE(mesh.triangles.size(), 50000U);
    }
  }
}

TEST(Room, HasAMirrorAndALampThatGlows) {
  const Scene scene = load_committed("room");
  bool mirror = false;
  bool lamp = false;
  for (const Material& material : scene.materials) {
    mirror = mirror || (material.metallic == 1.0F && material.roughness < 0.05F);
    lamp = lamp || material.emissive.x > 1.0F;
  }
  EXPECT_TRUE(mirror);
  EXPECT_TRUE(lamp);
}

}  // namespace
}  // namespace luminist
