#include "raster/deep_framebuffer.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "gpu/debug_device.h"
#include "raster/mesh_scenes.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

using test::add;
using test::looking;
using test::moved;

class DeepFramebuffers : public DebugDeviceTest {
 protected:
  DeepFramebuffer draw(const Scene& scene, const Camera& camera, int width, int height,
                       std::size_t band_bytes = DeepFramebuffer::kBandBytes) {
    auto meshes = MeshBuffers::create(*device_, scene);
    EXPECT_TRUE(meshes) << meshes.error().message();
    auto deep = DeepFramebuffer::create(*device_, AssetRoots::standard(), *meshes, scene, camera, width, height, {},
                                        band_bytes);
    EXPECT_TRUE(deep) << deep.error().message();
    return std::move(deep).value();
  }
  static std::vector<Vec4> read(const GlBuffer& buffer) {
    std::vector<Vec4> values(buffer.bytes() / sizeof(Vec4));
    buffer.read(0, std::span(values));
    return values;
  }
  static std::vector<std::uint32_t> edges_of(const DeepFramebuffer& deep) {
    std::vector<std::uint32_t> edges(deep.pixel_count());
    deep.edge_of_pixel().read(0, std::span(edges));
    return edges;
  }
};

TEST_F(DeepFramebuffers, OfAnEmptySceneAreEmpty) {
  const DeepFramebuffer deep = draw(Scene{}, looking(Vec3(0, 0, 5), Vec3(0)), 32, 16);
  EXPECT_EQ(deep.sample_count(), 32U * 16U);
  for (const std::uint32_t object : deep.surface().object) EXPECT_EQ(object, 0U);
  for (const Vec4& p : read(deep.position())) EXPECT_EQ(p, Vec4(0.0F));
}

TEST_F(DeepFramebuffers, SphereCoversTheDiscThatGeometrySays) {
  Scene scene;
  add(scene, test::sphere_mesh(1.0F), "ball");
  const Camera camera = looking(Vec3(0, 0, 5), Vec3(0));
  const int size = 256;
  const DeepFramebuffer deep = draw(scene, camera, size, size);
  const double radius = std::tan(std::asin(1.0 / 5.0)) / std::tan(0.5 * camera.fov_y) * 0.5 * size;
  std::size_t covered = 0;
  for (const std::uint32_t object : deep.surface().object) covered += object == 1 ? 1 : 0;
  // The polygon is 0.05 % smaller than the disc, and counting pixels is exact to about one in the radius.
  EXPECT_NEAR(static_cast<double>(covered), kPi * radius * radius, 0.01 * kPi * radius * radius);
}

TEST_F(DeepFramebuffers, NormalsOfASphereArePositionsAndFaceTheEye) {
  Scene scene;
  add(scene, test::sphere_mesh(1.0F), "ball");
  const DeepFramebuffer deep = draw(scene, looking(Vec3(3, 2, 4), Vec3(0)), 128, 128);
  const SurfaceBuffer& surface = deep.surface();
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (surface.object[i] == 0) continue;
    EXPECT_NEAR(glm::length(surface.normal[i]), 1.0F, 1e-5F);
    EXPECT_GE(glm::dot(surface.normal[i], surface.eye - surface.position[i]), 0.0F);
    // Facets of 1.9 degrees lean at most half of that away, a little more where normals are bent at the silhouette.
    EXPECT_LT(glm::length(surface.normal[i] - glm::normalize(surface.position[i])), 0.03F);
  }
}

TEST_F(DeepFramebuffers, PixelCentresAreExact) {
  Scene scene;
  add(scene, test::sphere_mesh(1.0F), "ball");
  const Camera camera = looking(Vec3(3, 2, 4), Vec3(0));
  const DeepFramebuffer deep = draw(scene, camera, 120, 80);
  const SurfaceBuffer& surface = deep.surface();
  const std::vector<Vec4> samples = read(deep.position());
  for (int y = 0; y < surface.height; ++y) {
    for (int x = 0; x < surface.width; ++x) {
      const std::size_t i = surface.index(x, y);
      EXPECT_EQ(Vec3(samples[i]), surface.position[i]);
      if (surface.object[i] == 0) continue;
      const Vec2 at = test::pixel_of(camera, surface.position[i], 120, 80);
      // Interpolation in single precision: a few thousandths of a pixel.
      EXPECT_NEAR(at.x, static_cast<float>(x) + 0.5F, 0.01F);
      EXPECT_NEAR(at.y, static_cast<float>(y) + 0.5F, 0.01F);
    }
  }
}

TEST_F(DeepFramebuffers, EdgeSamplesLieAtTheirOffsets) {
  Scene scene;
  add(scene, test::sphere_mesh(1.0F), "ball");
  const Camera camera = looking(Vec3(3, 2, 4), Vec3(0));
  const DeepFramebuffer deep = draw(scene, camera, 120, 80);
  const std::vector<Vec4> samples = read(deep.position());
  const std::vector<std::uint32_t> edges = edges_of(deep);
  ASSERT_EQ(samples.size(), deep.sample_count());
  std::size_t compared = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i] == DeepFramebuffer::kNoEdge) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec4& p = samples[deep.pixel_count() + 4 * edges[i] + k];
      if (std::bit_cast<std::uint32_t>(p.w) == 0) continue;
      const Vec2 at = test::pixel_of(camera, Vec3(p), 120, 80);
      EXPECT_NEAR(at.x, static_cast<float>(i % 120) + 0.5F + DeepFramebuffer::kEdgeOffsets[k][0], 0.01F);
      EXPECT_NEAR(at.y, static_cast<float>(i / 120) + 0.5F + DeepFramebuffer::kEdgeOffsets[k][1], 0.01F);
      ++compared;
    }
  }
  EXPECT_GT(compared, 100U);
}

TEST_F(DeepFramebuffers, EdgesOfASphereAreItsOutlineAndNothingElse) {
  Scene scene;
  add(scene, test::sphere_mesh(1.0F, 200), "ball");
  const Camera camera = looking(Vec3(0, 0, 5), Vec3(0));
  const int size = 256;
  const DeepFramebuffer deep = draw(scene, camera, size, size);
  const double radius = std::tan(std::asin(1.0 / 5.0)) / std::tan(0.5 * camera.fov_y) * 0.5 * size;
  const std::vector<std::uint32_t> edges = edges_of(deep);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double r = std::hypot(x + 0.5 - 0.5 * size, y + 0.5 - 0.5 * size);
      const bool edge = edges[deep.surface().index(x, y)] != DeepFramebuffer::kNoEdge;
      if (std::abs(r - radius) > 4.0) {
        EXPECT_FALSE(edge) << x << "," << y;
      }
      if (std::abs(r - radius) < 0.1) {
        EXPECT_TRUE(edge) << x << "," << y;
      }
    }
  }
  // An outline of 2 pi r pixels' lengths crosses 4/pi as many pixels; the steep rim is a second row in places.
  EXPECT_LT(static_cast<double>(deep.edge_count()), 2.5 * 2.0 * kPi * radius);
}

TEST_F(DeepFramebuffers, PlaneHasNoEdgesHoweverItLies) {
  Scene scene;
  add(scene, test::quad_mesh(), "floor", test::laid_down(0.0F, 1000.0F));
  const Camera grazing = looking(Vec3(0, 0.05F, 0), Vec3(0, 0, -1), 0.05F);
  EXPECT_EQ(draw(scene, grazing, 128, 64).edge_count(), 0U);
}

TEST_F(DeepFramebuffers, CreasesOfABoxAreEdges) {
  Scene scene;
  add(scene, test::box_mesh(), "box");
  const Camera camera = looking(Vec3(3, 2.5F, 4), Vec3(0), 0.5F);
  const DeepFramebuffer deep = draw(scene, camera, 128, 128);
  const Vec2 crease = test::pixel_of(camera, Vec3(1, 0, 1), 128, 128);  // middle of the vertical edge in front
  const std::vector<std::uint32_t> edges = edges_of(deep);
  const std::size_t there = deep.surface().index(static_cast<int>(crease.x), static_cast<int>(crease.y));
  EXPECT_NE(edges[there], DeepFramebuffer::kNoEdge);
  EXPECT_EQ(edges[there + 6], DeepFramebuffer::kNoEdge);
}

TEST_F(DeepFramebuffers, FoldOfOneObjectInFrontOfItselfIsAnEdge) {
  Scene scene;
  Mesh two = test::quad_mesh();  // a small quad in front of a large one, parallel: same object, same normal
  const Mesh front = test::quad_mesh();
  for (std::size_t i = 0; i < 4; ++i) {
    two.positions[i] *= 4.0F;
    two.positions.push_back(front.positions[i] * 0.5F + Vec3(0, 0, 1));
    two.normals.push_back(front.normals[i]);
    two.uvs.push_back(front.uvs[i]);
  }
  two.triangles.push_back({4, 5, 6});
  two.triangles.push_back({4, 6, 7});
  add(scene, two, "fold");
  const Camera camera = looking(Vec3(0.008F, 0, 6), Vec3(0.008F, 0, 0), 0.5F);
  const DeepFramebuffer deep = draw(scene, camera, 100, 100);
  const Vec2 side = test::pixel_of(camera, Vec3(0.5F, 0, 1), 100, 100);
  ASSERT_NEAR(side.x - std::floor(side.x), 0.5F, 0.3F) << "the side passes between the pixel's samples";
  const std::vector<std::uint32_t> edges = edges_of(deep);
  EXPECT_NE(edges[deep.surface().index(static_cast<int>(side.x), 50)], DeepFramebuffer::kNoEdge);
  EXPECT_EQ(edges[deep.surface().index(50, 50)], DeepFramebuffer::kNoEdge);
}

TEST_F(DeepFramebuffers, TextureIsUpright) {
  Scene scene;
  add(scene, test::quad_mesh(), "picture");
  Image image(2, 2, 3);
  image.set_rgb(0, Vec3(1, 0, 0));  // top left
  image.set_rgb(1, Vec3(0, 1, 0));  // top right
  image.set_rgb(2, Vec3(0, 0, 1));  // bottom left
  image.set_rgb(3, Vec3(1, 1, 1));
  scene.textures.push_back({"corners", image, false, false});
  scene.materials[0].base_color_texture = 0;
  scene.materials[0].base_color = Vec3(0.5F);
  const DeepFramebuffer deep = draw(scene, looking(Vec3(0, 0, 4), Vec3(0), 0.6F), 64, 64);
  const SurfaceBuffer& surface = deep.surface();
  // In the corners the clamped texture is constant.
  EXPECT_EQ(surface.albedo[surface.index(10, 10)], Vec3(0.5F, 0, 0));
  EXPECT_EQ(surface.albedo[surface.index(53, 10)], Vec3(0, 0.5F, 0));
  EXPECT_EQ(surface.albedo[surface.index(10, 53)], Vec3(0, 0, 0.5F));
  EXPECT_EQ(surface.albedo[surface.index(53, 53)], Vec3(0.5F));
}

TEST_F(DeepFramebuffers, MetalHasNoDiffuseColourAndItsOwnReflectance) {
  Scene scene;
  add(scene, test::quad_mesh(), "metal", moved(Vec3(-1, 0, 0)));
  add(scene, test::quad_mesh(), "paint", moved(Vec3(1, 0, 0)));
  scene.materials[0].base_color = Vec3(0.9F, 0.6F, 0.3F);
  scene.materials[0].metallic = 1.0F;
  scene.materials[0].roughness = 0.25F;
  scene.materials[1].base_color = Vec3(0.2F, 0.4F, 0.8F);
  scene.materials[1].emissive = Vec3(2.0F, 0, 0);
  const DeepFramebuffer deep = draw(scene, looking(Vec3(0, 0, 4), Vec3(0)), 64, 64);
  const SurfaceBuffer& surface = deep.surface();
  const std::size_t metal = surface.index(20, 32);
  const std::size_t paint = surface.index(43, 32);
  EXPECT_EQ(surface.albedo[metal], Vec3(0.0F));
  EXPECT_EQ(surface.specular[metal], Vec3(0.9F, 0.6F, 0.3F));
  EXPECT_EQ(surface.roughness[metal], 0.25F);
  EXPECT_EQ(surface.albedo[paint], Vec3(0.2F, 0.4F, 0.8F));
  EXPECT_NEAR(surface.specular[paint].y, 0.04F, 1e-6F);
  EXPECT_EQ(surface.object[metal], 1U);
  EXPECT_EQ(surface.object[paint], 2U);
  EXPECT_EQ(surface.material[paint], 2U);
  EXPECT_EQ(surface.object_names, (std::vector<std::string>{"", "metal", "paint"}));
  EXPECT_EQ(Vec3(read(deep.emissive())[paint]), Vec3(2.0F, 0, 0));
}

TEST_F(DeepFramebuffers, NormalsFaceTheEyeFromBehindMirroredAndWoundTheOtherWay) {
  const Mesh quad = test::quad_mesh();
  Mesh wound = quad;
  for (auto& triangle : wound.triangles) std::swap(triangle[1], triangle[2]);
  const Mat4 plain(1.0F);
  const Mat4 mirrored = moved(Vec3(0), Vec3(-1, 1, 1));
  for (const Mesh& mesh : {quad, wound}) {
    for (const Mat4& placed : {plain, mirrored}) {
      for (const float side : {4.0F, -4.0F}) {
        Scene scene;
        add(scene, mesh, "quad", placed);
        const DeepFramebuffer deep = draw(scene, looking(Vec3(0, 0, side), Vec3(0)), 16, 16);
        EXPECT_NEAR(deep.surface().normal[8 * 16 + 8].z, side > 0 ? 1.0F : -1.0F, 1e-5F);
      }
    }
  }
}

TEST_F(DeepFramebuffers, NormalsStayUnitVectorsOnFlattenedObjectsAndWithoutNormals) {
  Scene scene;
  add(scene, test::quad_mesh(), "flat", moved(Vec3(-1, 0, 0), Vec3(1, 1, 0)));
  Mesh bare = test::quad_mesh();
  bare.normals.assign(4, Vec3(0.0F));
  add(scene, bare, "bare", moved(Vec3(1, 0, 0)));
  const DeepFramebuffer deep = draw(scene, looking(Vec3(0, 0, 4), Vec3(0)), 64, 64);
  EXPECT_NEAR(deep.surface().normal[deep.surface().index(20, 32)].z, 1.0F, 1e-5F);
  EXPECT_NEAR(glm::length(deep.surface().normal[deep.surface().index(43, 32)]), 1.0F, 1e-5F);
}

TEST_F(DeepFramebuffers, NormalMapTiltsTowardsItsTexture) {
  Scene scene;
  add(scene, test::quad_mesh(), "bumpy");
  Image image(1, 1, 3);
  image.set_rgb(0, Vec3(0.8F, 0.5F, 0.9F));  // (0.6, 0, 0.8): towards +u
  scene.textures.push_back({"tilt", image, true, true});
  scene.materials[0].normal_texture = 0;
  const DeepFramebuffer right = draw(scene, looking(Vec3(0, 0, 4), Vec3(0)), 16, 16);
  // Half floats hold the texture to three digits.
  EXPECT_NEAR(right.surface().normal[8 * 16 + 8].x, 0.6F, 2e-3F);
  EXPECT_NEAR(right.surface().normal[8 * 16 + 8].z, 0.8F, 2e-3F);

  scene.textures[0].image.set_rgb(0, Vec3(0.5F, 0.8F, 0.9F));  // green is up, against v (glTF)
  const DeepFramebuffer up = draw(scene, looking(Vec3(0, 0, 4), Vec3(0)), 16, 16);
  EXPECT_NEAR(up.surface().normal[8 * 16 + 8].y, 0.6F, 2e-3F);
}

TEST_F(DeepFramebuffers, AreTheSameInOneBandAndInMany) {
  Scene scene;
  add(scene, test::sphere_mesh(1.0F, 20), "ball");
  add(scene, test::box_mesh(), "box", moved(Vec3(1.5F, 0, -1)));
  const Camera camera = looking(Vec3(3, 2, 4), Vec3(0));
  const DeepFramebuffer whole = draw(scene, camera, 60, 50);
  const DeepFramebuffer bands = draw(scene, camera, 60, 50, std::size_t{60} * 440 * 7);
  EXPECT_EQ(edges_of(whole), edges_of(bands));
  for (const auto list : {&DeepFramebuffer::position, &DeepFramebuffer::normal}) {
    const std::vector<Vec4> one = read((whole.*list)());
    const std::vector<Vec4> many = read((bands.*list)());
    ASSERT_EQ(one.size(), many.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(std::bit_cast<std::uint32_t>(one[i].w), std::bit_cast<std::uint32_t>(many[i].w));
      // Interpolation starts at another corner of the target: rounding.
      EXPECT_LT(glm::length(Vec3(one[i] - many[i])), 1e-4F);
    }
  }
  EXPECT_NE(whole.id(), bands.id());
}

TEST_F(DeepFramebuffers, TooLargeAPictureIsALimit) {
  Scene scene;
  add(scene, test::quad_mesh(), "quad");
  LUM_ASSERT_OK(const MeshBuffers meshes, MeshBuffers::create(*device_, scene));
  const int wide = device_->info().max_texture_size + 1;
  const Camera camera = looking(Vec3(0, 0, 4), Vec3(0));
  EXPECT_EQ(error_of(DeepFramebuffer::create(*device_, AssetRoots::standard(), meshes, scene, camera, wide, 4)).kind,
            ErrorKind::kLimit);
}

}  // namespace
}  // namespace luminist
