#include <gtest/gtest.h>

#include "scene_file.h"

namespace luminist {
namespace {

void expect_tetrahedron(const std::string& name, const std::string& bytes) {
  SceneFile file(name, bytes);
  LUM_ASSERT_OK(const Scene scene, file.load());
  expect_sound(scene);
  EXPECT_EQ(file.warnings(), 0U) << name;
  EXPECT_EQ(scene.triangle_count(), 4U) << name;
  EXPECT_NEAR(six_volumes(scene.meshes[0]), 1.0, 1e-6) << name;
  EXPECT_EQ(scene.objects[0].name, std::filesystem::path(name).stem().string());
}

TEST(Ply, IsReadAsTextAndInBothByteOrders) {
  expect_tetrahedron("tetra.ply", tetrahedron_ply());
  expect_tetrahedron("little.PLY", binary_ply(false));
  expect_tetrahedron("big.ply", binary_ply(true));
}

TEST(Ply, KeepsItsNormalsAndStepsOverWhatItDoesNotKnow) {
  std::string ply =
      "ply\r\nformat ascii 1.0\r\nobj_info by hand\r\nelement camera 1\r\nproperty list uchar float view\r\n"
      "element vertex 3\r\nproperty float nx\r\nproperty float ny\r\nproperty float nz\r\nproperty float confidence\r\n"
      "property float x\r\nproperty float y\r\nproperty float z\r\nelement face 1\r\nproperty uchar flag\r\n"
      "property list uint8 uint32 vertex_index\r\nproperty list uchar float texcoord\r\nend_header\r\n"
      "2 0.5 0.5\r\n0 0 1 9 0 0 0\r\n0 0 1 9 1 0 0\r\n0 0.6 0.8 9 0 1 0\r\n7 3 0 1 2 6 0 0 1 0 0 1\r\n";
  SceneFile file("a.ply", ply);
  LUM_ASSERT_OK(const Scene scene, file.load());
  EXPECT_EQ(scene.meshes[0].normals[2], Vec3(0, 0.6F, 0.8F));
}

TEST(Ply, SaysWhereItIsBroken) {
  const std::string ply = tetrahedron_ply();
  const auto where = [](const std::string& bytes) {
    SceneFile file("a.ply", bytes);
    const Error error = error_of(file.load());
    EXPECT_EQ(error.kind, ErrorKind::kBadContent);
    return error.where.substr(file.folder().path().string().size() + 1);
  };
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = ply;
    return changed.replace(changed.find(from), from.size(), to);
  };
  EXPECT_EQ(where("plx\n"), "a.ply:1");
  EXPECT_EQ(where(with("ascii", "latin")), "a.ply:2");
  EXPECT_EQ(where(with("property float y", "property flaot y")), "a.ply:6");
  EXPECT_EQ(where(with("1 0 0\n", "1 zero 0\n")), "a.ply:12");
  EXPECT_EQ(where(with("3 0 3 2", "3 0 x 2")), "a.ply:17");
  EXPECT_EQ(where(with("3 0 3 2", "-3 0 3 2")), "a.ply:17");
  EXPECT_EQ(where(with("property float z\n", "")), "a.ply");
}

TEST(Ply, MayNotDeclareMoreThanItHolds) {
  std::string huge = binary_ply(false);
  huge.replace(huge.find("element vertex 4"), 16, "element vertex 999999999999");
  SceneFile file("a.ply", huge);
  EXPECT_EQ(error_of(file.load()).kind, ErrorKind::kBadContent);
  std::string list =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nproperty list uint double w\nend_header\n" +
      std::string(12, '\0') + "\xff\xff\xff\xff";
  SceneFile other("a.ply", list);  // 4,294,967,295 numbers of 8 bytes
  EXPECT_EQ(error_of(other.load()).kind, ErrorKind::kBadContent);
}

TEST(Stl, IsReadAsTextAndBinaryWithCornersWelded) {
  expect_tetrahedron("a.stl", text_stl());
  expect_tetrahedron("a.stl", binary_stl());
  std::string lying = binary_stl();
  lying.replace(0, 5, "solid");  // some writers begin binary files so
  expect_tetrahedron("a.stl", lying);
}

TEST(Stl, ThatIsSmoothSharesItsVertices) {
  std::string file = "solid\n";  // a gentle roof
  for (const char* face : {"0 0 0 1 0 0 0 0.1 -1", "1 0 0 0 0 0 0 0.1 1"}) {
    float v[9];
    ASSERT_EQ(
        std::sscanf(face, "%f %f %f %f %f %f %f %f %f", v, v + 1, v + 2, v + 3, v + 4, v + 5, v + 6, v + 7, v + 8), 9);
    file += "facet normal 0 0 0\n outer loop\n";
    for (int i = 0; i < 3; ++i) {
      file += "vertex " + std::to_string(v[3 * i]) + " " + std::to_string(v[3 * i + 1]) + " " +
              std::to_string(v[3 * i + 2]) + "\n";
    }
    file += "endloop\nendfacet\n";
  }
  SceneFile roof("a.stl", file + "endsolid\n");
  LUM_ASSERT_OK(const Scene scene, roof.load());
  EXPECT_EQ(scene.meshes[0].positions.size(), 4U);
}

TEST(Stl, ThatIsCutOffIsRefused) {
  for (const std::string& whole : {binary_stl(), text_stl()}) {
    SceneFile file("a.stl", whole.substr(0, whole.size() - 30));
    EXPECT_EQ(error_of(file.load()).kind, ErrorKind::kBadContent);
  }
  std::string more = binary_stl();
  more[80] = 5;
  SceneFile file("a.stl", more);
  EXPECT_EQ(error_of(file.load()).kind, ErrorKind::kBadContent);
}

TEST(Off, IsReadWithCommentsColoursAndNormals) {
  expect_tetrahedron("a.off", tetrahedron_off());
  expect_tetrahedron("a.off",
                     "# first\n\nCNOFF\n# counts\n4 4 0\n"
                     "0 0 0 -1 -1 -1 255 0 0 255\n1 0 0 1 0 0 0 0 0 255 # x\n0 1 0 0 1 0 1 1 1 1\n0 0 1 0 0 1 2 2 2 2\n"
                     "3 0 2 1 255 0 0\n\n3 0 1 3 12\n3 0 3 2\n# last\n3 1 2 3 0.5 0.5 0.5 1\n");
}

TEST(Off, SaysWhereItIsBroken) {
  const auto where = [](const std::string& bytes) {
    SceneFile file("a.off", bytes);
    const Error error = error_of(file.load());
    EXPECT_EQ(error.kind, ErrorKind::kBadContent);
    return error.where.substr(file.folder().path().string().size() + 1);
  };
  EXPECT_EQ(where("4OFF\n"), "a.off:1");
  EXPECT_EQ(where("OFF\n1 x\n"), "a.off:2");
  EXPECT_EQ(where("OFF\n999999999 1 0\n0 0 0\n"), "a.off:2");
  EXPECT_EQ(where("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), "a.off:4");
  EXPECT_EQ(where("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n9 0 1 2\n"), "a.off:6");
}

TEST(BareMesh, DropsBrokenFacesInEveryFormat) {
  std::string stl = binary_stl();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(stl.data() + 84 + 12, &nan, sizeof(nan));  // the first corner of the first face
  std::string ply = tetrahedron_ply(), off = tetrahedron_off();
  ply.replace(ply.find("3 0 1 3"), 7, "3 0 1 9");
  off.replace(off.find("3 0 1 3"), 7, "3 0 -1 3");
  std::string ply_nan = tetrahedron_ply(), off_huge = tetrahedron_off();
  ply_nan.replace(ply_nan.find("0 0 1\n3 0"), 5, "0 0 nan");
  off_huge.replace(off_huge.find("0 0 1\n3 0"), 5, "0 0 1e400");
  struct Case {
    std::string name, bytes, warning;
    std::size_t left;
  };
  for (const Case& c : std::vector<Case>{
           {"a.stl", stl, "1 face dropped: a corner is not a finite number (first: face 0, vertex 0)", 3},
           {"a.ply", ply, "1 face dropped: an index points to nothing (first: face 1, vertex 9)", 3},
           {"a.off", off, "1 face dropped: an index points to nothing (first: face 1, vertex -1)", 3},
           {"a.ply", ply_nan, "3 faces dropped: a corner is not a finite number (first: face 1, vertex 3)", 1},
           {"a.off", off_huge, "3 faces dropped: a corner is not a finite number (first: face 1, vertex 3)", 1}}) {
    SceneFile file(c.name, c.bytes);
    LUM_ASSERT_OK(const Scene scene, file.load());
    expect_sound(scene);
    EXPECT_EQ(file.warning(), c.warning);
    EXPECT_EQ(scene.triangle_count(), c.left);
  }
}

}  // namespace
}  // namespace luminist
