#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "scene_file.h"

namespace luminist {
namespace {

/// One of everything.
Scene rich_scene() {
  Scene scene;
  Mesh mesh = tetrahedron_with_uvs();
  compute_tangents(mesh);
  scene.meshes.push_back(mesh);
  Image color(4, 2, 3), data(2, 2, 3, 0.5F);
  for (std::size_t i = 0; i < color.data.size(); ++i)
    color.data[i] = static_cast<float>(i) / static_cast<float>(color.data.size());
  scene.textures.push_back({"pattern", color, true, false});
  scene.textures.push_back({"bumps", data, false, true});
  Material glazed{.name = "glazed",
                  .base_color = Vec3(0.1F, 0.2F, 0.3F),
                  .metallic = 0.1F,
                  .roughness = 0.2F,
                  .emissive = Vec3(3.0F, 0.5F, 0.0F),
                  .normal_scale = 0.7F,
                  .base_color_texture = 0,
                  .metallic_roughness_texture = 1,
                  .normal_texture = 1,
                  .emissive_texture = 0,
                  .line_width_texture = 1,
                  .double_sided = false};
  scene.materials = {glazed, {.name = "plain"}};
  scene.objects.push_back({"jug", 0, 0, glm::rotate(Mat4(1.0F), 0.3F, Vec3(0, 1, 0)), false});
  scene.objects.push_back({"copy", 0, 1, glm::translate(Mat4(1.0F), Vec3(3, 0, 0.1F)), false});
  scene.objects.push_back({"wall", 0, 1, glm::translate(Mat4(1.0F), Vec3(0, 0, -9)), true});
  Camera camera{.name = "front",
                .world_from_camera = glm::translate(glm::rotate(Mat4(1.0F), 0.4F, Vec3(1, 0, 0)), Vec3(0, 1, 7)),
                .fov_y = 0.51F,
                .near_plane = 0.2F,
                .far_plane = 33.0F};
  scene.cameras.push_back(camera);
  scene.lights.push_back({.name = "lamp",
                          .kind = PunctualLight::Kind::kSpot,
                          .color = Vec3(1, 0.9F, 0.8F),
                          .intensity = 12.0F,
                          .range = 5.0F,
                          .inner_angle = 0.2F,
                          .outer_angle = 0.6F,
                          .position = Vec3(1, 2, 3),
                          .direction = glm::normalize(Vec3(-1, -2, -3))});
  scene.lights.push_back({.name = "sky", .kind = PunctualLight::Kind::kSun, .direction = Vec3(0, -1, 0)});
  return scene;
}

TEST(SavedScene, ComesBackWhole) {
  const TemporaryFolder folder;
  const Scene scene = rich_scene();
  LUM_EXPECT_OK(save_scene(scene, folder.file("ä scene.glb")));
  Diagnostics diagnostics;
  LUM_ASSERT_OK(const Scene back, load_scene(folder.file("ä scene.glb"), {}, diagnostics));
  EXPECT_TRUE(diagnostics.warnings().empty());
  expect_sound(back);
  ASSERT_EQ(back.objects.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(back.objects[i].name, scene.objects[i].name);
    EXPECT_EQ(back.objects[i].world_from_object, scene.objects[i].world_from_object);
    EXPECT_EQ(back.objects[i].backdrop, scene.objects[i].backdrop);
    EXPECT_EQ(back.objects[i].material, scene.objects[i].material);
    const Mesh& mesh = back.meshes[static_cast<std::size_t>(back.objects[i].mesh)];
    EXPECT_EQ(mesh.positions, scene.meshes[0].positions);
    EXPECT_EQ(mesh.normals, scene.meshes[0].normals);
    EXPECT_EQ(mesh.uvs, scene.meshes[0].uvs);
    EXPECT_EQ(mesh.triangles, scene.meshes[0].triangles);
    EXPECT_EQ(mesh.tangents, scene.meshes[0].tangents);
  }
  ASSERT_EQ(back.cameras.size(), 1U);
  EXPECT_EQ(back.cameras[0].world_from_camera, scene.cameras[0].world_from_camera);
  EXPECT_EQ(back.cameras[0].fov_y, 0.51F);
  EXPECT_EQ(back.cameras[0].near_plane, 0.2F);
  EXPECT_EQ(back.cameras[0].far_plane, 33.0F);
}

TEST(SavedScene, KeepsShadowMeshes) {
  const TemporaryFolder folder;
  Scene scene = rich_scene();
  Mesh proxy = scene.meshes[0];
  for (Vec3& p : proxy.positions) p *= 0.5F;
  scene.meshes.push_back(proxy);
  scene.objects[0].shadow_mesh = 1;  // of the jug
  scene.objects[2].shadow_mesh = 0;  // of the wall, a backdrop: a mesh that is seen as well
  LUM_EXPECT_OK(save_scene(scene, folder.file("a.glb")));
  Diagnostics diagnostics;
  LUM_ASSERT_OK(const Scene back, load_scene(folder.file("a.glb"), {}, diagnostics));
  EXPECT_TRUE(diagnostics.warnings().empty());
  expect_sound(back);
  ASSERT_EQ(back.objects.size(), 3U);
  ASSERT_GE(back.objects[0].shadow_mesh, 0);
  EXPECT_EQ(back.meshes[static_cast<std::size_t>(back.objects[0].shadow_mesh)].positions, proxy.positions);
  EXPECT_EQ(back.objects[1].shadow_mesh, -1);
  EXPECT_EQ(back.objects[1].blocking_mesh(), back.objects[1].mesh);
  EXPECT_TRUE(back.objects[2].backdrop);
  ASSERT_GE(back.objects[2].shadow_mesh, 0);
  EXPECT_EQ(back.meshes[static_cast<std::size_t>(back.objects[2].shadow_mesh)].positions, scene.meshes[0].positions);
}

TEST(SavedScene, KeepsMaterialsPicturesAndLights) {
  const TemporaryFolder folder;
  const Scene scene = rich_scene();
  LUM_EXPECT_OK(save_scene(scene, folder.file("a.glb")));
  Diagnostics diagnostics;
  LUM_ASSERT_OK(const Scene back, load_scene(folder.file("a.glb"), {}, diagnostics));
  ASSERT_EQ(back.materials.size(), 2U);
  const Material &a = back.materials[0], &b = scene.materials[0];
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.base_color, b.base_color);
  EXPECT_EQ(a.metallic, b.metallic);
  EXPECT_EQ(a.roughness, b.roughness);
  EXPECT_NEAR(glm::distance(a.emissive, b.emissive), 0.0F, 1e-6F);  // a product of factor and strength
  EXPECT_EQ(a.normal_scale, b.normal_scale);
  EXPECT_FALSE(a.double_sided);
  EXPECT_TRUE(back.materials[1].double_sided);
  EXPECT_EQ(a.base_color_texture, a.emissive_texture);
  EXPECT_EQ(a.metallic_roughness_texture, a.normal_texture);
  EXPECT_EQ(a.line_width_texture, a.normal_texture) << "numbers, stored as they are";
  const Texture& pattern = back.textures[static_cast<std::size_t>(a.base_color_texture)];
  EXPECT_EQ(pattern.name, "pattern");
  EXPECT_TRUE(pattern.repeat_u);
  EXPECT_FALSE(pattern.repeat_v);
  for (std::size_t i = 0; i < pattern.image.data.size(); ++i) {
    EXPECT_NEAR(srgb_from_linear(pattern.image.data[i]), srgb_from_linear(scene.textures[0].image.data[i]),
                0.51F / 255.0F);
  }
  EXPECT_NEAR(back.textures[static_cast<std::size_t>(a.normal_texture)].image.data[0], 0.5F, 0.51F / 255.0F);
  ASSERT_EQ(back.lights.size(), 2U);
  EXPECT_EQ(back.lights[0].name, "lamp");
  EXPECT_EQ(back.lights[0].kind, PunctualLight::Kind::kSpot);
  EXPECT_EQ(back.lights[0].intensity, 12.0F);
  EXPECT_FLOAT_EQ(back.lights[0].outer_angle, 0.6F);
  EXPECT_EQ(back.lights[0].position, Vec3(1, 2, 3));
  EXPECT_NEAR(glm::distance(back.lights[0].direction, scene.lights[0].direction), 0.0F, 1e-6F);
  EXPECT_EQ(back.lights[1].kind, PunctualLight::Kind::kSun);
}

TEST(SavedScene, IsTheSameFileForTheSameSceneAndAfterALoad) {
  const TemporaryFolder folder;
  LUM_EXPECT_OK(save_scene(rich_scene(), folder.file("a.glb")));
  LUM_EXPECT_OK(save_scene(rich_scene(), folder.file("b.glb")));
  LUM_ASSERT_OK(const std::string a, read_file(folder.file("a.glb")));
  LUM_ASSERT_OK(const std::string b, read_file(folder.file("b.glb")));
  EXPECT_TRUE(a == b);
  SceneFile file("c.obj", tetrahedron_obj());
  LUM_ASSERT_OK(const Scene scene, file.load({.floor = true, .wall = true}));
  LUM_EXPECT_OK(save_scene(scene, folder.file("c.glb")));
  Diagnostics diagnostics;
  LUM_ASSERT_OK(const Scene again, load_scene(folder.file("c.glb"), {}, diagnostics));
  LUM_EXPECT_OK(save_scene(again, folder.file("d.glb")));
  LUM_ASSERT_OK(const std::string c, read_file(folder.file("c.glb")));
  LUM_ASSERT_OK(const std::string d, read_file(folder.file("d.glb")));
  EXPECT_TRUE(c == d);
}

TEST(SavedScene, IsNotHalfWritten) {
  const TemporaryFolder folder;
  const Error error = error_of(save_scene(rich_scene(), folder.file("none/a.glb")));
  EXPECT_EQ(error.kind, ErrorKind::kUnwritable);
  EXPECT_EQ(error.where, folder.file("none/a.glb"));
}

}  // namespace
}  // namespace luminist
