#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "raster/deep_framebuffer.h"
#include "raster/mesh_scenes.h"
#include "raster/raster_renderer.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

constexpr int kOutlinedWidth = 200;
constexpr int kOutlinedHeight = 160;
constexpr Vec3 kInk(1.0F, 0.0F, 0.0F);

/// White-grey objects in ambient light, drawn with red lines.
class OutlineTest : public testing::Test {
 protected:
  void SetUp() override {
    LUM_ASSERT_OK(device_, Device::create_headless());
    LUM_ASSERT_OK(types_, LightTypes::load(AssetRoots::standard()));
    LUM_ASSERT_OK(style_, load_style(AssetRoots::standard(), "cinematic+outline"));
  }
  Image draw(const Scene& scene, const Camera& camera, const std::vector<std::string>& settings) {
    auto renderer = RasterRenderer::create(*device_, scene, camera, *types_, *style_, AssetRoots::standard(),
                                           kOutlinedWidth, kOutlinedHeight);
    EXPECT_TRUE(renderer) << (renderer ? "" : renderer.error().message());
    ParamState state = initial_state(*types_, *style_, (*renderer)->frame());
    LUM_EXPECT_OK(set_path(state, "ambient/color=0.5,0.5,0.5"));
    LUM_EXPECT_OK(set_path(state, "style/line_color=1,0,0"));
    for (const std::string& setting : settings) LUM_EXPECT_OK(set_path(state, setting));
    surface_ = (*renderer)->surface();
    return (*renderer)->render(state).value();
  }
  /// Share of a pixel that is red, from its green: the scene's grey is grey.
  static float ink(const Image& picture, int x, int y) {
    const Vec3 c = picture.rgb(picture.index(x, y));
    return glm::clamp(c.r - c.g, 0.0F, 1.0F);
  }
  static std::string width(float pixels) {
    return "style/line_width=" + std::to_string(pixels / static_cast<float>(kOutlinedHeight));
  }

  std::optional<Device> device_;
  std::optional<LightTypes> types_;
  std::optional<Style> style_;
  SurfaceBuffer surface_;
};

TEST_F(OutlineTest, IsAsWideAsAskedInPixels) {
  Scene scene;
  test::add(scene, test::sphere_mesh(1.0F), "ball");
  const Camera camera = test::looking(Vec3(0, 0, 6), Vec3(0));
  for (const float wanted : {1.0F, 2.0F, 4.0F, 7.5F}) {
    const Image picture = draw(scene, camera, {width(wanted)});
    float left = 0.0F;
    float right = 0.0F;
    for (int x = 0; x < kOutlinedWidth; ++x)
      (x < kOutlinedWidth / 2 ? left : right) += ink(picture, x, kOutlinedHeight / 2);
    // Samples lie a quarter of a pixel apart; the hull is a polygon and stands a little behind.
    EXPECT_NEAR(left, wanted, 0.3F);
    EXPECT_NEAR(right, wanted, 0.3F);
  }
}

TEST_F(OutlineTest, InSceneUnitsGetsThinnerWithDistance) {
  Scene scene;
  test::add(scene, test::sphere_mesh(1.0F), "ball");
  const auto ink_at = [&](float distance, const char* unit) {
    const Image picture = draw(scene, test::looking(Vec3(0, 0, distance), Vec3(0)),
                               {std::string("style/line_unit=") + unit, width(8.0F)});
    float sum = 0.0F;
    for (int x = 0; x < kOutlinedWidth / 2; ++x) sum += ink(picture, x, kOutlinedHeight / 2);
    return sum;
  };
  EXPECT_NEAR(ink_at(12.0F, "scene") / ink_at(6.0F, "scene"), 0.5F, 0.08F);
  EXPECT_NEAR(ink_at(12.0F, "picture") / ink_at(6.0F, "picture"), 1.0F, 0.08F);
}

TEST_F(OutlineTest, OfACubeWithSplitNormalsHasNoGap) {
  for (int view = 0; view < 12; ++view) {
    Scene scene;
    test::add(scene, test::box_mesh(), "cube");
    const float angle = 0.5F * static_cast<float>(view) + 0.1F;
    const Camera camera =
        test::looking(7.0F * Vec3(std::cos(angle), 0.9F * std::sin(2.0F * angle), std::sin(angle)), Vec3(0));
    const Image picture = draw(scene, camera, {width(3.0F), "style/line_crease=0"});
    for (int y = 1; y + 1 < kOutlinedHeight; ++y) {
      for (int x = 1; x + 1 < kOutlinedWidth; ++x) {
        if (surface_.object[surface_.index(x, y)] != 0) continue;
        const bool beside =
            surface_.object[surface_.index(x - 1, y)] != 0 || surface_.object[surface_.index(x + 1, y)] != 0 ||
            surface_.object[surface_.index(x, y - 1)] != 0 || surface_.object[surface_.index(x, y + 1)] != 0;
        // A pixel that the cube just misses is inked, but for the quarter that its samples may see of the cube.
        if (beside) {
          EXPECT_GE(ink(picture, x, y), 0.45F) << "view " << view << " at " << x << ", " << y;
        }
      }
    }
  }
}

TEST_F(OutlineTest, GoesAroundASheetWithOpenBorders) {
  Scene scene;
  test::add(scene, test::quad_mesh(), "sheet");
  const Camera camera = test::looking(Vec3(0, 0, 6), Vec3(0));
  const Image picture = draw(scene, camera, {width(4.0F), "style/line_crease=0"});
  float row = 0.0F;
  float column = 0.0F;
  for (int x = 0; x < kOutlinedWidth; ++x) row += ink(picture, x, kOutlinedHeight / 2);
  for (int y = 0; y < kOutlinedHeight; ++y) column += ink(picture, kOutlinedWidth / 2, y);
  EXPECT_NEAR(row, 8.0F, 0.6F) << "two borders";
  EXPECT_NEAR(column, 8.0F, 0.6F);
}

TEST_F(OutlineTest, DrawsCreasesOnlyWhereTheyAreSharpEnough) {
  Scene scene;
  test::add(scene, test::box_mesh(), "cube");
  const Camera camera = test::looking(Vec3(4, 4, 4), Vec3(0));
  const auto inside = [&](const std::vector<std::string>& settings) {
    const Image picture = draw(scene, camera, settings);
    float sum = 0.0F;
    for (int y = kOutlinedHeight / 2 - 12; y < kOutlinedHeight / 2 + 12; ++y) {
      for (int x = kOutlinedWidth / 2 - 12; x < kOutlinedWidth / 2 + 12; ++x) sum += ink(picture, x, y);
    }
    return sum;
  };
  const std::string wide = width(2.0F);
  EXPECT_EQ(inside({wide, "style/line_crease=0"}), 0.0F);
  EXPECT_EQ(inside({wide, "style/line_crease_angle=1.7"}), 0.0F) << "a cube has 1.57";
  // Three edges from the corner in the middle, at least 12 pixels long each in that square.
  EXPECT_GT(inside({wide, "style/line_inner=1"}), 3.0F * 12.0F * 2.0F * 0.8F);
}

TEST_F(OutlineTest, DrawsALineWhereObjectsMeet) {
  Scene scene;
  test::add(scene, test::sphere_mesh(1.0F), "ball");
  test::add(scene, test::quad_mesh(), "table", test::laid_down(-0.6F, 3.0F));
  const Camera camera = test::looking(Vec3(0, 3, 5), Vec3(0, -0.6F, 0));
  const Image without = draw(scene, camera, {width(3.0F), "style/line_intersection=0", "style/line_border=0"});
  const Image with = draw(scene, camera, {width(3.0F), "style/line_border=0", "style/line_inner=1"});
  // The nearest point of the circle in which the ball meets the table.
  const Vec2 at = test::pixel_of(camera, Vec3(0, -0.6F, 0.8F), kOutlinedWidth, kOutlinedHeight);
  float line = 0.0F;
  float nothing = 0.0F;
  for (int y = static_cast<int>(at.y) - 5; y <= static_cast<int>(at.y) + 5; ++y) {
    line += ink(with, static_cast<int>(at.x), y);
    nothing += ink(without, static_cast<int>(at.x), y);
  }
  EXPECT_NEAR(line, 3.0F, 0.8F);  // the width counts in pixels, and half of it falls to either side
  EXPECT_LT(nothing, 1.0F);
}

TEST_F(OutlineTest, OfSomethingSmallIsAsWideInEveryDirection) {
  Scene scene;
  test::add(scene, test::quad_mesh(), "wall", test::moved(Vec3(0), Vec3(4.0F)));
  test::add(scene, test::sphere_mesh(0.06F, 24), "nail");
  const Camera camera = test::looking(Vec3(0, 0, 6), Vec3(0));
  const Image picture = draw(scene, camera,
                             {"style/line_width=0.05", "style/line_inner=2", "style/line_border=0",
                              "style/line_silhouette=0", "style/line_crease=0"});
  // The nail is two pixels in radius, and the line reaches eight farther.
  for (int y = -8; y <= 8; ++y) {
    for (int x = -8; x <= 8; ++x) {
      const double far = std::hypot(x + 0.5, y + 0.5);
      if (far > 4.0 && far < 8.0) {
        EXPECT_GT(ink(picture, kOutlinedWidth / 2 + x, kOutlinedHeight / 2 + y), 0.9F) << x << ", " << y;
      }
    }
  }
}

TEST_F(OutlineTest, IsMaskedByATextureOfTheMaterial) {
  // The left half of the sphere has u = 0, the right half u = 1; the mask is black there and white here.
  Mesh sphere = test::sphere_mesh(1.0F);
  for (const Vec3& p : sphere.positions) sphere.uvs.emplace_back(p.x < 0.0F ? 0.0F : 1.0F, 0.5F);
  Scene scene;
  test::add(scene, sphere, "ball");
  const Camera camera = test::looking(Vec3(0, 0, 6), Vec3(0));
  const Image whole = draw(scene, camera, {width(4.0F)});
  scene.textures.push_back({"mask", Image(2, 1, 3), false, false});
  scene.textures[0].image.set_rgb(1, Vec3(1.0F));
  scene.materials[0].line_width_texture = 0;
  const Image masked = draw(scene, camera, {width(4.0F)});
  float left = 0.0F;
  for (int y = 0; y < kOutlinedHeight; ++y) {
    for (int x = 0; x < kOutlinedWidth; ++x) {
      // In the triangles between the halves, two pixels wide, the width grows.
      if (x < kOutlinedWidth / 2 - 4) left += ink(masked, x, y);
      if (x > kOutlinedWidth / 2 + 4) {
        ASSERT_EQ(masked.rgb(masked.index(x, y)), whole.rgb(whole.index(x, y))) << x << ' ' << y;
      }
    }
  }
  EXPECT_EQ(left, 0.0F);
  float across = 0.0F;
  for (int x = 0; x < kOutlinedWidth; ++x) across += ink(masked, x, kOutlinedHeight / 2);
  EXPECT_NEAR(across, 4.0F, 0.3F) << "samples lie a quarter of a pixel apart";
}

TEST_F(OutlineTest, OfNoWidthIsThePictureWithoutIt) {
  Scene scene;
  test::add(scene, test::box_mesh(), "cube");
  const Camera camera = test::looking(Vec3(4, 3, 4), Vec3(0));
  const Image none = draw(scene, camera, {"style/line_width=0"});
  LUM_ASSERT_OK(style_, load_style(AssetRoots::standard(), "cinematic"));
  auto renderer = RasterRenderer::create(*device_, scene, camera, *types_, *style_, AssetRoots::standard(),
                                         kOutlinedWidth, kOutlinedHeight);
  ParamState state = initial_state(*types_, *style_, (*renderer)->frame());
  LUM_EXPECT_OK(set_path(state, "ambient/color=0.5,0.5,0.5"));
  EXPECT_EQ(none.data, (*renderer)->render(state).value().data);
}

TEST_F(OutlineTest, FollowsItsWidthAndSamplesSeeTheSameLines) {
  Scene scene;
  test::add(scene, test::sphere_mesh(1.0F), "ball");
  auto made = RasterRenderer::create(*device_, scene, test::looking(Vec3(0, 0, 5), Vec3(0)), *types_, *style_,
                                     AssetRoots::standard(), kOutlinedWidth, kOutlinedHeight);
  ASSERT_TRUE(made);
  RasterRenderer& renderer = **made;
  ParamState state = initial_state(*types_, *style_, renderer.frame());
  const SurfaceBuffer& surface = renderer.surface();
  SampleSet samples;
  samples.id = 5;
  for (std::uint32_t i = 0; i < surface.pixels(); ++i) samples.pixels.push_back(i);
  std::size_t inked[2] = {0, 0};
  for (int wide = 0; wide < 2; ++wide) {
    LUM_EXPECT_OK(set_path(state, width(wide == 0 ? 2.0F : 6.0F)));
    LUM_EXPECT_OK(set_path(state, "style/line_color=1,0,0"));
    ASSERT_TRUE(renderer.render(state));
    std::vector<Vec3> colors(samples.pixels.size());
    const Candidate candidate{&state, Candidate::kAllLights};
    LUM_EXPECT_OK(renderer.evaluate({&candidate, 1}, samples, {}, colors));
    for (const Vec3& c : colors) inked[wide] += c == kInk ? 1 : 0;
  }
  EXPECT_GT(inked[0], 100U);
  EXPECT_NEAR(static_cast<double>(inked[1]) / static_cast<double>(inked[0]), 3.0, 0.4);
}

TEST_F(OutlineTest, IsTheSameWherePicturesAreDrawnInBands) {
  Scene scene;
  test::add(scene, test::sphere_mesh(1.0F), "ball");
  test::add(scene, test::quad_mesh(), "table", test::laid_down(-0.6F, 3.0F));
  const Camera camera = test::looking(Vec3(0, 3, 5), Vec3(0, -0.6F, 0));
  LUM_ASSERT_OK(const MeshBuffers meshes, MeshBuffers::create(*device_, scene));
  LUM_ASSERT_OK(const OutlineBuffers outlines, OutlineBuffers::create(*device_, scene));
  LineSpec spec;
  spec.width = 0.04F;
  spec.silhouette = spec.crease = spec.intersection = spec.border = true;
  DeepExtras extras;
  extras.lines = DeepLines{&outlines, spec, scene.frame()};
  std::vector<std::vector<Vec4>> normals;
  for (const std::size_t band_bytes :
       {std::size_t{1} << 29U, std::size_t{kOutlinedWidth} * 2000 * 7}) {  // seven rows at most
    LUM_ASSERT_OK(const DeepFramebuffer deep,
                  DeepFramebuffer::create(*device_, AssetRoots::standard(), meshes, scene, camera, kOutlinedWidth,
                                          kOutlinedHeight, extras, band_bytes));
    normals.emplace_back(deep.sample_count());
    deep.normal().read(0, std::span<Vec4>(normals.back()));
  }
  ASSERT_EQ(normals[0].size(), normals[1].size());
  for (std::size_t i = 0; i < normals[0].size(); ++i) {
    // The material and the kind of line in bits; directions are interpolated from another corner of the viewport.
    ASSERT_EQ(std::bit_cast<std::uint32_t>(normals[0][i].w), std::bit_cast<std::uint32_t>(normals[1][i].w)) << i;
    ASSERT_LT(glm::distance(Vec3(normals[0][i]), Vec3(normals[1][i])), 1e-3F) << i;
  }
}

}  // namespace
}  // namespace luminist
