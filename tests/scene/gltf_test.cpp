#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "image_io/image_io.h"
#include "scene_file.h"

namespace luminist {
namespace {

std::string message_of(const std::string& gltf, ErrorKind kind = ErrorKind::kBadContent) {
  SceneFile file("a.gltf", gltf);
  const Error error = error_of(file.load());
  EXPECT_EQ(error.kind, kind) << error.message();
  return error.message();
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The tetrahedron's glTF with one piece of its text replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string gltf = tetrahedron_gltf(embedded_buffer());
  EXPECT_TRUE(contains(gltf, from));
  return gltf.replace(gltf.find(from), from.size(), to);
}

TEST(Gltf, ReadsBuffersInsideAndBeside) {
  for (const bool inside : {true, false}) {
    SceneFile file("a.gltf", tetrahedron_gltf(inside ? embedded_buffer() : "my%20data/%C3%A4.bin"));
    LUM_EXPECT_OK(make_folder(file.folder().path() / "my data"));
    file.put("my data/ä.bin", tetrahedron_buffer());
    LUM_ASSERT_OK(const Scene scene, file.load());
    expect_sound(scene);
    EXPECT_EQ(scene.objects[0].name, "tetra");
    EXPECT_NEAR(six_volumes(scene.meshes[0]), 1.0, 1e-6);
    EXPECT_EQ(scene.materials[0].name, "default");
  }
}

TEST(Gltf, PlacesObjectsThroughTheNodeHierarchy) {
  const std::string nodes = R"([{"children":[1,2],"translation":[0,0,5],"scale":[2,2,2]},)"
                            R"({"mesh":0,"name":"a","rotation":[0,0,0.70710678,0.70710678]},)"
                            R"({"mesh":0,"name":"a","matrix":[1,0,0,0,0,1,0,0,0,0,1,0,1,0,0,1]}])";
  SceneFile file("a.gltf", tetrahedron_gltf(embedded_buffer(), "", nodes));
  LUM_ASSERT_OK(const Scene scene, file.load());
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.objects[0].mesh, scene.objects[1].mesh);
  EXPECT_EQ(scene.objects[1].name, "a-2");
  const Vec3 turned = Vec3(scene.objects[0].world_from_object * Vec4(1, 0, 0, 1));  // a quarter turn about z
  EXPECT_NEAR(glm::distance(turned, Vec3(0, 2, 5)), 0.0F, 1e-5F);
  EXPECT_EQ(Vec3(scene.objects[1].world_from_object * Vec4(0, 0, 0, 1)), Vec3(2, 0, 5));
}

TEST(Gltf, TakesReflectionsOutOfItsTransforms) {
  SceneFile file("a.gltf", tetrahedron_gltf(embedded_buffer(), "", R"([{"mesh":0,"scale":[1,-1,1]}])"));
  LUM_ASSERT_OK(const Scene scene, file.load());
  const Object& object = scene.objects[0];
  EXPECT_GT(glm::determinant(Mat3(object.world_from_object)), 0.0F);
  const Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
  EXPECT_NEAR(six_volumes(mesh), 1.0, 1e-6);  // front faces still look outwards
  EXPECT_EQ(scene.bounds().lo, Vec3(0, -1, 0));
}

/// A reflected node that shows the tetrahedron and names a shadow mesh; `primitives` are those of mesh 1.
std::string with_shadow_mesh(const std::string& reference, const std::string& primitives = "") {
  const std::string node =
      R"([{"mesh":0,"name":"a","scale":[-1,1,1],"extras":{"luminist":{"shadow_mesh":)" + reference + "}}}]";
  std::string gltf = tetrahedron_gltf(embedded_buffer(), "", node);
  const std::size_t end_of_meshes = gltf.find(R"(],"accessors")");
  return gltf.insert(end_of_meshes, R"(,{"primitives":[)" + primitives + "]}");
}

TEST(Gltf, JoinsThePrimitivesOfAShadowMeshAndReflectsItWithItsObject) {
  const std::string primitive = R"({"attributes":{"POSITION":0},"indices":1})";
  SceneFile file("a.gltf", with_shadow_mesh("1", primitive + "," + primitive));
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_EQ(file.warnings(), 0U);
  expect_sound(scene);
  ASSERT_EQ(scene.objects.size(), 1U);
  ASSERT_GE(scene.objects[0].shadow_mesh, 0);
  const Mesh& shadow = scene.meshes[static_cast<std::size_t>(scene.objects[0].shadow_mesh)];
  EXPECT_EQ(shadow.triangles.size(), 8U);
  EXPECT_NEAR(six_volumes(shadow), 2.0, 1e-6) << "front faces still look outwards";
}

TEST(Gltf, WarnsOfAShadowMeshThatIsNotThere) {
  for (const char* reference : {"7", "-1", "0.5", "\"a\""}) {
    SceneFile file("a.gltf", with_shadow_mesh(reference));
    LUM_ASSERT_OK(const Scene scene, file.load());
    EXPECT_TRUE(contains(file.warning(), "\"a\" names a shadow mesh that is not there")) << reference;
    EXPECT_EQ(scene.objects[0].shadow_mesh, -1);
  }
}

TEST(Gltf, LeavesTheShadowToTheMeshItselfIfItsShadowMeshHasNoFaces) {
  SceneFile file("a.gltf", with_shadow_mesh("1"));
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_TRUE(contains(file.warning(), "\"a\": no face of its shadow mesh is left")) << file.warning();
  EXPECT_EQ(scene.objects[0].shadow_mesh, -1);
  expect_sound(scene);
}

TEST(Gltf, ReadsMaterialsAndTheirPictures) {
  LUM_ASSERT_OK(const std::string png, encode_png(Image(2, 2, 3, 0.5F), Encoding::kLinear));
  const std::string more =
      R"("materials":[{"name":"paint","doubleSided":true,"emissiveFactor":[1,0.5,0],)"
      R"("extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":4}},)"
      R"("pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1],"metallicFactor":0.25,"roughnessFactor":0.75,)"
      R"("baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":0}},"normalTexture":{"index":1,"scale":0.5}}],)"
      R"("textures":[{"source":0,"sampler":0},{"source":0}],"samplers":[{"wrapS":33071}],)"
      R"("images":[{"uri":"data:image/png;base64,)" +
      base64(png) + R"("}],)";
  SceneFile file("a.gltf", tetrahedron_gltf(embedded_buffer(), more, R"([{"mesh":0}])", R"(,"material":0)"));
  LUM_ASSERT_OK(const Scene scene, file.load());
  expect_sound(scene);
  ASSERT_EQ(scene.materials.size(), 1U);
  const Material& m = scene.materials[0];
  EXPECT_EQ(m.base_color, Vec3(0.5F, 0.25F, 1.0F));
  EXPECT_EQ(m.metallic, 0.25F);
  EXPECT_EQ(m.roughness, 0.75F);
  EXPECT_EQ(m.emissive, Vec3(4, 2, 0));
  EXPECT_EQ(m.normal_scale, 0.5F);
  EXPECT_TRUE(m.double_sided);
  ASSERT_EQ(scene.textures.size(), 3U);
  const Texture& color = scene.textures[static_cast<std::size_t>(m.base_color_texture)];
  const Texture& data = scene.textures[static_cast<std::size_t>(m.metallic_roughness_texture)];
  EXPECT_NEAR(color.image.data[0], linear_from_srgb(128.0F / 255.0F), 1e-6F);  // one picture, two meanings
  EXPECT_NEAR(data.image.data[0], 128.0F / 255.0F, 1e-6F);
  EXPECT_FALSE(color.repeat_u);
  EXPECT_TRUE(color.repeat_v);
}

TEST(Gltf, RefusesAMaskOfLineWidthsThatIsNoTexture) {
  for (const char* index : {"7", "-2", "0.5", "\"mask\""}) {
    const std::string more =
        R"("materials":[{"extras":{"luminist":{"line_width_texture":)" + std::string(index) + "}}}],";
    SceneFile file("a.gltf", tetrahedron_gltf(embedded_buffer(), more, R"([{"mesh":0}])", R"(,"material":0)"));
    const auto scene = file.load();
    ASSERT_FALSE(scene) << index;
    EXPECT_EQ(scene.error().kind, ErrorKind::kBadContent);
    EXPECT_EQ(scene.error().field, "materials[0].extras.luminist.line_width_texture") << index;
  }
}

TEST(Gltf, TakesNoMaskFromTheExtrasOfOthers) {
  for (const char* extras :
       {"3", "{}", R"({"luminist":1})", R"({"luminist":{"other":2}})", R"({"line_width_texture":0})"}) {
    const std::string more = R"("materials":[{"extras":)" + std::string(extras) + "}],";
    SceneFile file("a.gltf", tetrahedron_gltf(embedded_buffer(), more, R"([{"mesh":0}])", R"(,"material":0)"));
    LUM_ASSERT_OK(const Scene scene, file.load());
    EXPECT_EQ(scene.materials[0].line_width_texture, -1) << extras;
  }
}

TEST(Gltf, ReadsCamerasAndLights) {
  const std::string more =
      R"("extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[)"
      R"({"type":"spot","color":[1,0.5,0.25],"intensity":20,"range":7,"spot":{"innerConeAngle":0.1,"outerConeAngle":0.4}},)"
      R"({"type":"point"},{"type":"directional","intensity":3}]}},)"
      R"("cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.1}},)"
      R"({"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0.1,"zfar":9}}],)";
  const std::string nodes =
      R"([{"mesh":0,"children":[1,2,3,4,5]},{"camera":0,"name":"front","translation":[0,0,9],"scale":[3,3,3]},{"camera":1},)"
      R"({"name":"key","translation":[0,4,0],"rotation":[-0.70710678,0,0,0.70710678],"extensions":{"KHR_lights_punctual":{"light":0}}},)"
      R"({"extensions":{"KHR_lights_punctual":{"light":1}}},{"extensions":{"KHR_lights_punctual":{"light":2}}}])";
  SceneFile file("a.gltf", tetrahedron_gltf(embedded_buffer(), more, nodes));
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_TRUE(contains(file.warning(), "cameras[1]"));
  ASSERT_EQ(scene.cameras.size(), 1U);
  expect_sound(scene);  // an infinite far plane becomes one behind the scene
  EXPECT_EQ(scene.cameras[0].name, "front");
  EXPECT_EQ(scene.cameras[0].position(), Vec3(0, 0, 9));
  EXPECT_NEAR(glm::length(Vec3(scene.cameras[0].world_from_camera[0])), 1.0F, 1e-6F);
  EXPECT_GT(scene.cameras[0].far_plane, 9.0F);
  ASSERT_EQ(scene.lights.size(), 3U);
  const PunctualLight& key = scene.lights[0];
  EXPECT_EQ(key.kind, PunctualLight::Kind::kSpot);
  EXPECT_EQ(key.name, "key");
  EXPECT_EQ(key.color, Vec3(1, 0.5F, 0.25F));
  EXPECT_EQ(key.intensity, 20.0F);
  EXPECT_EQ(key.range, 7.0F);
  EXPECT_FLOAT_EQ(key.outer_angle, 0.4F);
  EXPECT_EQ(key.position, Vec3(0, 4, 0));
  EXPECT_NEAR(glm::distance(key.direction, Vec3(0, -1, 0)), 0.0F, 1e-6F);
  EXPECT_EQ(scene.lights[1].kind, PunctualLight::Kind::kPoint);
  EXPECT_EQ(scene.lights[2].kind, PunctualLight::Kind::kSun);
}

TEST(Gltf, UnderstandsStripsFansAndMeshesWithoutIndices) {
  for (const auto& [mode, count] : {std::pair("5", 10U), std::pair("6", 10U), std::pair("4", 4U)}) {
    SceneFile file("a.gltf",
                   tetrahedron_gltf(embedded_buffer(), "", R"([{"mesh":0}])", std::string(",\"mode\":") + mode));
    LUM_ASSERT_OK(const Scene scene, file.load());
    EXPECT_EQ(scene.triangle_count(), count) << mode;
  }
  SceneFile plain("a.gltf", changed(",\"indices\":1", ""));
  LUM_ASSERT_OK(const Scene scene, plain.load());
  EXPECT_EQ(scene.triangle_count(), 1U);  // four vertices hold one triangle
  SceneFile lines("a.gltf", tetrahedron_gltf(embedded_buffer(), "", R"([{"mesh":0}])", ",\"mode\":1"));
  EXPECT_EQ(error_of(lines.load()).kind, ErrorKind::kBadContent);
}

TEST(Gltf, ReadsSparseAndNormalizedAccessors) {
  std::string buffer = tetrahedron_buffer();
  append_raw(buffer, std::uint16_t{3});  // replaces vertex 3
  append_raw(buffer, std::uint16_t{0});
  for (const float x : {0.0F, 0.0F, 2.0F}) append_raw(buffer, x);
  std::string gltf = changed(R"("type":"VEC3",)",
                             R"("type":"VEC3","sparse":{"count":1,"indices":{"bufferView":2,"componentType":5123},)"
                             R"("values":{"bufferView":3}},)");
  const auto replace = [&](const std::string& from, const std::string& to) {
    gltf.replace(gltf.find(from), from.size(), to);
  };
  replace(
      R"("byteLength":24})",
      R"("byteLength":24},{"buffer":0,"byteOffset":72,"byteLength":2},{"buffer":0,"byteOffset":76,"byteLength":12})");
  replace(base64(tetrahedron_buffer()), base64(buffer));
  replace(R"("byteLength":72)", R"("byteLength":88)");
  SceneFile file("a.gltf", gltf);
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_EQ(scene.bounds().hi.z, 2.0F);
}

TEST(Gltf, RefusesReferencesThatLeaveItsFolder) {
  for (const char* uri :
       {"../a.bin", "/dev/zero", "%2e%2e/a.bin", "file:///etc/passwd", "sub/../../a.bin", "http://x/a.bin"}) {
    EXPECT_TRUE(contains(message_of(tetrahedron_gltf(uri)), "leaves the file's folder")) << uri;
    const std::string image = std::string(R"("images":[{"uri":")") + uri + R"("}],)";
    EXPECT_TRUE(contains(message_of(tetrahedron_gltf(embedded_buffer(), image)), "leaves the file's folder")) << uri;
  }
  EXPECT_TRUE(contains(message_of(tetrahedron_gltf("gone.bin"), ErrorKind::kMissing), "gone.bin"));
}

TEST(Gltf, RefusesNodesThatMakeNoTree) {
  const auto with_nodes = [](const std::string& nodes) { return tetrahedron_gltf(embedded_buffer(), "", nodes); };
  EXPECT_TRUE(contains(message_of(with_nodes(R"([{"mesh":0,"children":[0]}])")), "nodes[0]"));
  EXPECT_TRUE(contains(message_of(with_nodes(R"([{"children":[1]},{"mesh":0,"children":[0]}])")), "own ancestor"));
  EXPECT_TRUE(contains(message_of(with_nodes(R"([{"children":[1,2]},{"children":[3]},{"children":[3]},{"mesh":0}])")),
                       "two parents"));
  EXPECT_TRUE(contains(message_of(with_nodes(R"([{"children":[7]}])")), "nodes[7]"));
  std::string chain = "[";
  for (int i = 1; i <= 70; ++i) chain += R"({"children":[)" + std::to_string(i) + "]},";
  EXPECT_TRUE(contains(message_of(with_nodes(chain + R"({"mesh":0}])")), "deeper than 64"));
}

TEST(Gltf, RefusesAccessorsThatReachOutside) {
  EXPECT_TRUE(contains(message_of(changed(R"("count":4)", R"("count":5)")), "POSITION: accessors[0]"));
  EXPECT_TRUE(contains(message_of(changed(R"("count":12)", R"("count":13)")), "indices: accessors[1]"));
  EXPECT_TRUE(contains(message_of(changed(R"("byteOffset":48)", R"("byteOffset":56)")), "bufferViews[1]"));
  EXPECT_TRUE(contains(message_of(changed(R"("byteLength":48)", R"("byteLength":4000000000000)")), "bufferViews[0]"));
  EXPECT_TRUE(contains(message_of(changed(R"("POSITION":0)", R"("POSITION":9)")), "POSITION"));
  EXPECT_TRUE(contains(message_of(changed(R"("type":"VEC3")", R"("type":"VEC2")")), "accessors[0]"));
  EXPECT_TRUE(contains(message_of(changed(R"("componentType":5123)", R"("componentType":5126)")), "indices"));
  EXPECT_TRUE(contains(message_of(changed(R"("mesh":0)", R"("mesh":3)")), "meshes[3]"));
  EXPECT_TRUE(contains(message_of(changed(R"("POSITION":0)", R"("NORMAL":0)")), "POSITION"));
  message_of(changed(R"("count":4)", R"("count":4000000000000000)"), ErrorKind::kLimit);
}

TEST(Gltf, DropsFacesWithIndicesOutside) {
  std::string buffer = tetrahedron_buffer();
  buffer[48] = 77;  // the first index
  SceneFile file("a.gltf", tetrahedron_gltf("data:application/octet-stream;base64," + base64(buffer)));
  LUM_ASSERT_OK(const Scene scene, file.load());
  expect_sound(scene);
  EXPECT_EQ(scene.triangle_count(), 3U);
  EXPECT_EQ(file.warning(), "1 face dropped: an index points to nothing (first: \"tetra\" face 0, vertex 77)");
}

TEST(Gltf, DropsFacesWithVerticesThatAreNotNumbers) {
  std::string buffer = tetrahedron_buffer();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(buffer.data() + 12, &nan, sizeof(nan));  // x of vertex 1, which three faces use
  SceneFile file("a.gltf", tetrahedron_gltf("data:application/octet-stream;base64," + base64(buffer)));
  LUM_ASSERT_OK(const Scene scene, file.load());
  expect_sound(scene);
  EXPECT_EQ(file.warning(), "3 faces dropped: a corner is not a finite number (first: \"tetra\" face 0, vertex 1)");
}

TEST(Gltf, SaysAtWhichLineItsJsonBreaks) {
  EXPECT_TRUE(contains(message_of("{\n \"asset\": {\n  \"version\" \"2.0\"\n}}"), "a.gltf:3:"));
  EXPECT_TRUE(contains(message_of(R"({"scenes":[]})"), "asset"));
  message_of("");
  message_of(std::string(100'000, '['));  // deep enough to end a recursive parser
  message_of(R"({"asset":{"version":"2.0"},"extras":)" + std::string(200, '[') + std::string(200, ']') + "}");
}

TEST(Gltf, RefusesCompressionItDoesNotKnow) {
  EXPECT_TRUE(contains(
      message_of(tetrahedron_gltf(embedded_buffer(), R"("extensionsRequired":["KHR_draco_mesh_compression"],)")),
      "KHR_draco_mesh_compression"));
}

TEST(Gltf, GoesOnWithoutAMissingPictureButNotWithABrokenOne) {
  const auto with_image = [](const std::string& image) {
    return tetrahedron_gltf(embedded_buffer(),
                            R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],)"
                            R"("textures":[{"source":0}],"images":[)" +
                                image + "],");
  };
  SceneFile file("a.gltf", with_image(R"({"uri":"gone.png"})"));
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_EQ(scene.materials[0].base_color_texture, -1);
  EXPECT_EQ(file.warning(), "the texture \"gone.png\" is not there and is left out");
  EXPECT_TRUE(contains(message_of(with_image(R"({"uri":"data:image/png;base64,AAAA"})")), "images[0]"));
  EXPECT_TRUE(contains(message_of(with_image(R"({"bufferView":9,"mimeType":"image/png"})")), "bufferView"));
  std::string outside = with_image(R"({"bufferView":1,"mimeType":"image/png"})");
  outside.replace(outside.find(R"("byteLength":24)"), 15, R"("byteLength":99)");
  EXPECT_TRUE(contains(message_of(outside), "bufferViews[1]"));
}

}  // namespace
}  // namespace luminist
