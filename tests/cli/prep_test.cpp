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

}  // namespace
}  // namespace luminist
