// Cut and damaged scene files: an answer, never a crash.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <random>

#include <fmt/format.h>

#include "scene_file.h"

namespace luminist {
namespace {

struct Sample {
  std::string name;
  std::string bytes;
};

/// A small file of each format. The .glb has no picture, so that no helper has to start for each of its mutants.
const std::vector<Sample>& samples() {
  static const std::vector<Sample> all = [] {
    std::vector<Sample> made{
        {"a.obj", std::string("mtllib a.mtl\nvn 0 0 1\nvt 0 0\n") + tetrahedron_obj() + "f 1/1/1 2/1/1 3/1/1 4/1/1\n"},
        {"a.ply", tetrahedron_ply()},
        {"b.ply", binary_ply(false)},
        {"c.ply", binary_ply(true)},
        {"a.stl", text_stl()},
        {"b.stl", binary_stl()},
        {"a.off", tetrahedron_off()},
        {"a.gltf", tetrahedron_gltf(embedded_buffer(), R"("materials":[{"name":"m"}],)",
                                    R"([{"mesh":0,"children":[1]},{"translation":[1,2,3]}])", R"(,"material":0)")}};
    SceneFile source("a.obj", tetrahedron_obj());
    const auto scene = source.load();
    const TemporaryFolder folder;
    EXPECT_TRUE(save_scene(*scene, folder.file("a.glb")));
    made.push_back({"a.glb", *read_file(folder.file("a.glb"))});
    return made;
  }();
  return all;
}

/// Loads a damaged file and checks what comes back. Returns whether it was refused.
bool survives(SceneFile& file, const Sample& sample, const std::string& bytes) {
  file.put(sample.name, bytes);
  Diagnostics diagnostics;
  const Result<Scene> scene = load_scene(file.folder().file(sample.name), {}, diagnostics);
  if (scene) {
    expect_sound(*scene);
    return false;
  }
  const ErrorKind kind = scene.error().kind;
  EXPECT_TRUE(kind == ErrorKind::kBadContent || kind == ErrorKind::kMissing || kind == ErrorKind::kLimit)
      << scene.error().message();
  EXPECT_NE(scene.error().where.find(sample.name), std::string::npos) << scene.error().message();
  return true;
}

TEST(DamagedScene, MayBreakOffAnywhere) {
  for (const Sample& sample : samples()) {
    SceneFile file("a.mtl", "newmtl m\n");
    std::size_t refused = 0;
    for (std::size_t size = 0; size < sample.bytes.size(); ++size)
      refused += survives(file, sample, sample.bytes.substr(0, size)) ? 1 : 0;
    EXPECT_GT(refused, sample.bytes.size() / 3) << sample.name;
    EXPECT_FALSE(survives(file, sample, sample.bytes)) << sample.name;
  }
}

TEST(DamagedScene, MayHaveAnyBytesChanged) {
  std::mt19937 random(7);
  for (const Sample& sample : samples()) {
    SceneFile file("a.mtl", "newmtl m\n");
    for (int i = 0; i < 400; ++i) {
      std::string mutant = sample.bytes;
      for (int n = 0; n <= i % 5; ++n) {
        const std::size_t at = random() % mutant.size();
        if (i % 3 == 0) {  // another digit, sign or bracket: stays well formed more often
          mutant[at] = "0123456789-,.[]{}\""[random() % 18];
        } else if (i % 3 == 1) {
          mutant[at] = static_cast<char>(random());
        } else {
          mutant.erase(at, 1 + random() % 4);
        }
      }
      survives(file, sample, mutant);
    }
  }
}

TEST(SceneFiles, ThatAreMissingOrNoFilesAreNamed) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  for (const char* extension : {".gltf", ".glb", ".obj", ".ply", ".stl", ".off", ".xyz"}) {
    const std::string path = folder.file(std::string("none") + extension);
    const Error error = error_of(load_scene(path, {}, diagnostics));
    EXPECT_EQ(error.kind, ErrorKind::kMissing);
    EXPECT_EQ(error.where, path);
  }
  ASSERT_EQ(::mkfifo(folder.file("pipe.glb").c_str(), 0600), 0);
  EXPECT_EQ(error_of(load_scene(folder.file("pipe.glb"), {}, diagnostics)).kind, ErrorKind::kBadContent);
  ASSERT_EQ(::mkdir(folder.file("folder.obj").c_str(), 0700), 0);
  EXPECT_EQ(error_of(load_scene(folder.file("folder.obj"), {}, diagnostics)).kind, ErrorKind::kBadContent);
}

TEST(SceneFiles, OfAnUnknownKindAreRefusedWithTheKnownOnes) {
  SceneFile file("a.fbx", "?");
  const Error error = error_of(file.load());
  EXPECT_EQ(error.kind, ErrorKind::kBadContent);
  EXPECT_NE(error.hint.find(".glb"), std::string::npos);
}

TEST(SceneFiles, MayHaveUnusualNames) {
  for (const char* name :
       {"with space.obj", "-dash.obj", "grün 果.obj", "quo'te\".obj", "new\nline.obj", "UPPER.OBJ"}) {
    SceneFile file(name, tetrahedron_obj());
    LUM_EXPECT_OK(file.load());
  }
}

TEST(SceneFiles, WithMoreThanTwentyMillionTrianglesAreOverTheLimit) {
  std::string nodes = "[{\"children\":[";  // one small mesh, shown by very many nodes
  std::string buffer;
  const std::uint32_t triangles = 60'000;
  for (const Vec3& p : tetrahedron_points()) {
    for (int i = 0; i < 3; ++i) append_raw(buffer, p[i]);
  }
  for (std::uint32_t i = 0; i < triangles; ++i) {
    for (const std::uint32_t index : tetrahedron_faces()[i % 4]) append_raw(buffer, static_cast<std::uint16_t>(index));
  }
  for (int i = 1; i <= 400; ++i) nodes += fmt::format("{}{}", i > 1 ? "," : "", i);
  nodes += "]}";
  for (int i = 1; i <= 400; ++i) nodes += ",{\"mesh\":0}";
  std::string gltf = tetrahedron_gltf("a.bin", "", nodes + "]");
  const auto replace = [&](const std::string& from, const std::string& to) {
    gltf.replace(gltf.find(from), from.size(), to);
  };
  replace(R"("count":12)", R"("count":)" + std::to_string(3 * triangles));
  replace(R"("byteLength":24)", R"("byteLength":)" + std::to_string(6 * triangles));
  replace(R"("byteLength":72)", R"("byteLength":)" + std::to_string(buffer.size()));
  SceneFile file("a.gltf", gltf);
  file.put("a.bin", buffer);
  EXPECT_EQ(error_of(file.load()).kind, ErrorKind::kLimit);
}

}  // namespace
}  // namespace luminist
