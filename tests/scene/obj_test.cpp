#include <gtest/gtest.h>

#include <fmt/format.h>

#include "image_io/image_io.h"
#include "scene_file.h"

namespace luminist {
namespace {

/// The whole message of the error that loading gives.
std::string message_of(SceneFile& file, ErrorKind kind) {
  const Error error = error_of(file.load());
  EXPECT_EQ(error.kind, kind) << error.message();
  return error.message();
}

TEST(Obj, GivesATetrahedronWithNormals) {
  SceneFile file("tetra.obj", tetrahedron_obj());
  LUM_ASSERT_OK(const Scene scene, file.load());
  expect_sound(scene);
  EXPECT_EQ(scene.triangle_count(), 4U);
  EXPECT_NEAR(six_volumes(scene.meshes[0]), 1.0, 1e-6);
  EXPECT_EQ(scene.objects[0].name, "tetra");
  EXPECT_EQ(file.warnings(), 0U);
}

TEST(Obj, TakesIndicesFromTheEndLineEndsOfWindowsAndMissingLastLineEnd) {
  std::string obj = "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf -3 -2 -1";
  SceneFile file("a.obj", obj);
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_EQ(scene.meshes[0].positions.size(), 3U);
  EXPECT_GT(scene.meshes[0].normals[0].z, 0.99F);
}

TEST(Obj, CutsPolygonsOfAnySize) {
  std::string obj, face = "f";
  for (int i = 0; i < 300; ++i) {  // more corners than one byte can count
    obj += "v " + std::to_string(std::cos(kPi * i / 150.0)) + " " + std::to_string(std::sin(kPi * i / 150.0)) + " 0\n";
    face += fmt::format(" {}", i + 1);
  }
  SceneFile file("a.obj", obj + face + "\n");
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_EQ(scene.triangle_count(), 298U);
}

TEST(Obj, SharesCornersAndFlipsTextureCoordinates) {
  SceneFile file("a.obj",
                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 0.75\nvt 0 0.75\nvn 0 0 2\n"
                 "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n");
  LUM_ASSERT_OK(const Scene scene, file.load());
  const Mesh& mesh = scene.meshes[0];
  ASSERT_EQ(mesh.positions.size(), 4U);
  EXPECT_EQ(mesh.uvs[0], Vec2(0, 1));
  EXPECT_EQ(mesh.uvs[2], Vec2(1, 0.25F));
  EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));  // made unit
}

TEST(Obj, MakesAnObjectOfEveryGroupAndMaterial) {
  SceneFile file(
      "a.obj",
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
      "o one\nusemtl red\nf 1 3 2\nusemtl blue paint\nf 1 2 4\no two\nusemtl red\nf 1 4 3\ng one\nf 2 3 4\n");
  file.put("a.mtl", "newmtl red\nKd 1 0 0\nNs 200\nnewmtl blue paint\nKd 0 0 1\nPr 0.25\nPm 1\nKe 0 0 2\n");
  LUM_ASSERT_OK(const Scene scene, file.load());
  expect_sound(scene);
  ASSERT_EQ(scene.objects.size(), 3U);
  EXPECT_EQ(scene.objects[0].name, "one");
  EXPECT_EQ(scene.objects[1].name, "one-2");
  EXPECT_EQ(scene.objects[2].name, "two");
  EXPECT_EQ(scene.meshes[0].triangles.size(), 2U);  // the group comes back
  ASSERT_EQ(scene.materials.size(), 2U);
  EXPECT_EQ(scene.materials[0].base_color, Vec3(1, 0, 0));
  EXPECT_NEAR(scene.materials[0].roughness, std::pow(2.0 / 202.0, 0.25), 1e-5);
  EXPECT_EQ(scene.materials[1].name, "blue paint");
  EXPECT_EQ(scene.materials[1].metallic, 1.0F);
  EXPECT_EQ(scene.materials[1].roughness, 0.25F);
  EXPECT_EQ(scene.materials[1].emissive, Vec3(0, 0, 2));
}

TEST(Obj, ReadsTexturesOnceAndPacksRoughnessWithMetallic) {
  SceneFile file("a.obj",
                 "mtllib my materials.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                 "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 3/3 2/2 1/1\n");
  file.put("my materials.mtl",
           "newmtl a\nKd 0 0 0\nmap_Kd tex tures\\wood oak.png\nmap_Pr rough.png\nmap_Pm metal.png\nnorm normal.png\n"
           "newmtl b\nmap_Kd tex tures/wood oak.png\n");
  LUM_EXPECT_OK(make_folder(file.folder().path() / "tex tures"));
  LUM_EXPECT_OK(write_image(file.folder().file("tex tures/wood oak.png"), Image(2, 2, 3, 0.5F)));
  LUM_EXPECT_OK(write_image(file.folder().file("rough.png"), Image(2, 2, 1, 1.0F)));
  LUM_EXPECT_OK(write_image(file.folder().file("metal.png"), Image(4, 4, 1, 0.0F)));
  LUM_EXPECT_OK(write_image(file.folder().file("normal.png"), Image(2, 2, 3, 1.0F)));
  LUM_ASSERT_OK(const Scene scene, file.load());
  expect_sound(scene);
  ASSERT_EQ(scene.textures.size(), 3U);
  const Material& a = scene.materials[0];
  EXPECT_EQ(a.base_color_texture, scene.materials[1].base_color_texture);
  EXPECT_EQ(a.base_color, Vec3(1.0F));  // a black factor in front of a picture is not meant
  const Image& wood = scene.textures[static_cast<std::size_t>(a.base_color_texture)].image;
  EXPECT_NEAR(wood.data[0], 0.5F, 0.005F);  // decoded from sRGB; half a step of 8 bits
  const Image& packed = scene.textures[static_cast<std::size_t>(a.metallic_roughness_texture)].image;
  EXPECT_EQ(packed.at(1, 1, 1), 1.0F);
  EXPECT_EQ(packed.at(1, 1, 2), 0.0F);
  EXPECT_FALSE(scene.meshes[0].tangents.empty());  // the normal map needs them
}

TEST(Obj, GoesOnWithoutMissingMaterialsAndTextures) {
  SceneFile file("a.obj", std::string("mtllib none.mtl\n") + tetrahedron_obj());
  LUM_EXPECT_OK(file.load());
  EXPECT_EQ(file.warning(), "the material library \"none.mtl\" is not there");
  EXPECT_EQ(file.warned_at(), file.path() + ":1");
  SceneFile other("a.obj", std::string("mtllib a.mtl\nusemtl a\n") + tetrahedron_obj());
  other.put("a.mtl", "newmtl a\nmap_Kd gone.png\n");
  LUM_EXPECT_OK(other.load());
  EXPECT_EQ(other.warning(), "the texture \"gone.png\" is not there and is left out");
}

TEST(Obj, RefusesReferencesThatLeaveItsFolder) {
  for (const char* name : {"../a.mtl", "/etc/passwd", "x/../../a.mtl", "file:///etc/passwd"}) {
    SceneFile file("a.obj", std::string("mtllib ") + name + "\n" + tetrahedron_obj());
    EXPECT_NE(message_of(file, ErrorKind::kBadContent).find(file.path() + ":1"), std::string::npos);
    SceneFile texture("a.obj", std::string("mtllib a.mtl\nusemtl a\n") + tetrahedron_obj());
    texture.put("a.mtl", std::string("newmtl a\nmap_Kd ") + name + "\n");
    EXPECT_NE(message_of(texture, ErrorKind::kBadContent).find(name), std::string::npos);
  }
}

TEST(Obj, RefusesABrokenTextureByName) {
  SceneFile file("a.obj", std::string("mtllib a.mtl\nusemtl a\n") + tetrahedron_obj());
  file.put("a.mtl", "newmtl a\nmap_Kd broken.png\n");
  file.put("broken.png", "\x89PNG\r\n\x1a\nno");
  EXPECT_NE(message_of(file, ErrorKind::kBadContent).find("broken.png"), std::string::npos);
}

TEST(Obj, DropsFacesWithIndicesOutsideAndNamesTheFirst) {
  SceneFile file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\nf 1 2 0\nf -9 1 2\nf 1/7 2/7 3/7\nf 1 2\n");
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_EQ(scene.triangle_count(), 1U);
  EXPECT_EQ(file.warnings(), 2U);
  SceneFile one("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\nf 1 2 99999999999\n");
  LUM_EXPECT_OK(one.load());
  EXPECT_EQ(one.warning(), "2 faces dropped: an index points to nothing (first: corner 9/0/0)");
  EXPECT_EQ(one.warned_at(), one.path() + ":5");
}

TEST(Obj, DropsFacesWithBrokenVerticesAndNamesTheFirst) {
  for (const char* vertex :
       {"v nan 0 0", "v 0 inf 0", "v 0 0 -inf", "v 1e39 0 0", "v 0 0", "v one two three", "v 1e30 0 0"}) {
    SceneFile file("a.obj", std::string(tetrahedron_obj()) + vertex + "\nf 1 2 5\nf 3 5 4\n");
    LUM_ASSERT_OK(const Scene scene, file.load());
    expect_sound(scene);
    EXPECT_EQ(scene.triangle_count(), 4U) << vertex;
    EXPECT_EQ(file.warning(), "2 faces dropped: a corner is not a finite number (first: vertex 5)") << vertex;
    EXPECT_EQ(file.warned_at(), file.path() + ":12");
  }
}

TEST(Obj, WithoutAnyFaceIsRefused) {
  for (const char* text :
       {"", "# nothing\n", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}) {
    SceneFile file("a.obj", text);
    EXPECT_NE(message_of(file, ErrorKind::kBadContent).find("no face is left"), std::string::npos);
  }
}

TEST(Obj, ReplacesBrokenNormals) {
  SceneFile file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn nan nan nan\nvn 0 0 1\nf 1//1 2//2 3//3\n");
  LUM_ASSERT_OK(const Scene scene, file.load());
  expect_sound(scene);
  for (const Vec3& n : scene.meshes[0].normals) EXPECT_GT(n.z, 0.99F);
}

TEST(Obj, TurnsNormalsThatLookInwards) {
  std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\nvn -1 -1 -1\n";
  SceneFile file("a.obj", obj + "f 1//1 3//1 2//1\nf 1//2 2//2 4//2\nf 1//3 4//3 3//3\nf 2//4 3//4 4//4\n");
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_NE(file.warning().find("look inwards"), std::string::npos);
  for (const auto& t : scene.meshes[0].triangles) {
    const std::vector<Vec3>& p = scene.meshes[0].positions;
    EXPECT_GT(glm::dot(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]), scene.meshes[0].normals[t[0]]), 0.0F);
  }
}

TEST(Obj, TurnsAClosedSurfaceThatIsInsideOut) {
  SceneFile file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_NE(file.warning().find("inside out"), std::string::npos);
  EXPECT_NEAR(six_volumes(scene.meshes[0]), 1.0, 1e-6);
}

TEST(Obj, LeavesAnOpenSurfaceAsItIs) {
  SceneFile file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\n");
  LUM_EXPECT_OK(file.load());
  EXPECT_EQ(file.warnings(), 0U);
}

TEST(Obj, ReadsAMillionTriangles) {
  std::string obj;
  const int side = 708;  // 2 * 707^2 triangles
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x)
      obj += "v " + std::to_string(x) + " " + std::to_string((x * y) % 7) + " " + std::to_string(y) + "\n";
  }
  for (int y = 0; y + 1 < side; ++y) {
    for (int x = 0; x + 1 < side; ++x) {
      const int a = y * side + x + 1;
      obj += "f " + std::to_string(a) + " " + std::to_string(a + side) + " " + std::to_string(a + side + 1) + " " +
             std::to_string(a + 1) + "\n";
    }
  }
  SceneFile file("grid.obj", obj);
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_EQ(scene.triangle_count(), 2U * 707U * 707U);
}

}  // namespace
}  // namespace luminist
