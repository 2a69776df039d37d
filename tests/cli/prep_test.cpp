#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "image_io/image_io.h"
#include "scene/scene.h"

namespace luminist {
namespace {

TEST_F(CliTest, PrepLeavesThePictureOfAGoodMeshAsItWas) {
  const Outcome outcome = luminist("prep ball.obj -o ball.glb --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out.substr(0, outcome.out.find('\n')), nullptr, false);
  ASSERT_TRUE(report.is_object()) << outcome.out;
  EXPECT_EQ(report["flipped"], 0);
  EXPECT_EQ(report["components"], 1);
  ASSERT_EQ(luminist("render ball.obj --size 48x48 -o before.exr").status, 0);
  ASSERT_EQ(luminist("render ball.glb --size 48x48 -o after.exr").status, 0);
  LUM_ASSERT_OK(const Image before, read_image(folder_.file("before.exr")));
  LUM_ASSERT_OK(const Image after, read_image(folder_.file("after.exr")));
  ASSERT_TRUE(before.same_size(after));
  for (std::size_t i = 0; i < before.data.size(); ++i) ASSERT_NEAR(before.data[i], after.data[i], 1e-4F);
}

TEST_F(CliTest, PrepSaysWhatWasWrongWithAMesh) {
  write("broken.obj",
        "v 0 0 0\nv 0 1 0\nv 1 0 0\nv -1 0 0\nv 0 0 1\n"
        "f 1 2 3\nf 2 1 4\nf 1 2 5\nf 3 1 2\nf 1 1 2\n");
  const Outcome outcome = luminist("prep broken.obj");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("3 triangles in 3 pieces"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("1 edge of more than two triangles split"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("1 triangle dropped, there twice"), std::string::npos) << outcome.out;
  expect_error(luminist("prep none.obj"), 4);
  expect_error(luminist("prep broken.obj -o repaired.obj"), 2);
  EXPECT_FALSE(exists("repaired.obj")) << "a glTF under another name is nothing that anybody reads";
}

TEST_F(CliTest, PrepUnwrapsAMeshWithoutTextureCoordinatesAndDrawsTheAtlas) {
  write("roof.obj", "v 0 0 0\nv 2 0 0\nv 2 1 1\nv 0 1 1\nv 2 2 0\nv 0 2 0\nf 1 2 3\nf 1 3 4\nf 4 3 5\nf 4 5 6\n");
  const Outcome outcome = luminist("prep roof.obj --draw roof.png -o roof.glb --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out.substr(0, outcome.out.find('\n')), nullptr, false);
  ASSERT_TRUE(report.is_object()) << outcome.out;
  EXPECT_EQ(report["unwrap"]["charts"], 2) << "the ridge is sharp";
  EXPECT_EQ(report["unwrap"]["flipped"], 0);
  LUM_ASSERT_OK(const Image drawing, read_image(folder_.file("roof.png")));
  EXPECT_EQ(drawing.width, drawing.height);
  Diagnostics diagnostics;
  LUM_ASSERT_OK(const Scene scene, load_scene(folder_.file("roof.glb"), {}, diagnostics));
  ASSERT_EQ(scene.meshes.size(), 1U);
  EXPECT_EQ(scene.meshes[0].positions.size(), 8U) << "two of each end of the ridge";
  EXPECT_EQ(scene.meshes[0].uvs.size(), 8U);
  expect_error(luminist("prep roof.obj --draw roof.jpg"), 2);
}

TEST_F(CliTest, PrepMakesProxiesOfTheObjectsThatAreNamed) {
  const Outcome outcome =
      luminist("prep ball.obj --shadow-proxy 'ba*=0.1' --shading-proxy ball=0.5 -o ball.glb --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out.substr(0, outcome.out.find('\n')), nullptr, false);
  ASSERT_TRUE(report.is_object()) << outcome.out;
  const auto& shadow = report["shadow_proxies"][0];
  EXPECT_EQ(shadow["objects"][0], "ball");
  EXPECT_LE(shadow["triangles"], 53);
  EXPECT_LT(shadow["sticks_out"], 0.01);
  EXPECT_EQ(report["shading_proxies"][0]["objects"].size(), 1U);
  Diagnostics diagnostics;
  LUM_ASSERT_OK(const Scene before, load_scene(folder_.file("ball.obj"), {}, diagnostics));
  LUM_ASSERT_OK(const Scene after, load_scene(folder_.file("ball.glb"), {}, diagnostics));
  EXPECT_TRUE(diagnostics.warnings().empty());
  ASSERT_EQ(after.objects.size(), 2U);
  EXPECT_EQ(after.objects[1].shadow_mesh, -1) << "the floor";
  ASSERT_GE(after.objects[0].shadow_mesh, 0);
  EXPECT_EQ(after.meshes[static_cast<std::size_t>(after.objects[0].shadow_mesh)].triangles.size(), shadow["triangles"]);
  // Poles are welded and large triangles may be split, but every place is still there, most with another normal.
  std::map<std::array<long, 3>, Vec3> normals;
  const auto place = [](const Vec3& p) {  // up to the rounding of the poles
    return std::array{std::lround(1e5F * p.x), std::lround(1e5F * p.y), std::lround(1e5F * p.z)};
  };
  for (std::size_t v = 0; v < after.meshes[0].positions.size(); ++v) {
    normals[place(after.meshes[0].positions[v])] = after.meshes[0].normals[v];
  }
  std::size_t turned = 0;
  const std::size_t vertices = before.meshes[0].positions.size();
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto found = normals.find(place(before.meshes[0].positions[v]));
    ASSERT_NE(found, normals.end()) << v;
    turned += found->second != before.meshes[0].normals[v] ? 1 : 0;
  }
  EXPECT_GT(turned, vertices / 2);

  const Outcome spoken = luminist("prep ball.obj --shadow-proxy ball=0.1");
  EXPECT_NE(spoken.out.find("shadow of ball cast by"), std::string::npos) << spoken.out;
}

TEST_F(CliTest, PrepRefusesProxiesThatMakeNoSense) {
  const Outcome unknown = luminist("prep ball.obj --shadow-proxy bal=0.1");
  expect_error(unknown, 2);
  EXPECT_NE(unknown.err.find("did you mean \"ball\"?"), std::string::npos) << unknown.err;
  expect_error(luminist("prep ball.obj --shading-proxy 'x*=0.1'"), 2);
  for (const char* share : {"ball", "ball=", "ball=0", "ball=-1", "ball=1.5", "ball=nan", "ball=many"}) {
    const Outcome outcome = luminist(std::string("prep ball.obj --shading-proxy ") + share);
    expect_error(outcome, 2);
    EXPECT_NE(outcome.err.find("--shading-proxy"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace luminist
