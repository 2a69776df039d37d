// The lit sphere: which texel or which place of the painted sphere a surface shows, from geometry.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "image_io/image_io.h"
#include "raster/renderer_fixture.h"

namespace luminist {
namespace {

class LitSphere : public RendererTest {
 protected:
  void set(const std::string& assignment) { LUM_EXPECT_OK(set_path(*state_, assignment)); }
  std::vector<Vec3> colors() { return evaluate({&*state_, 0}, all_pixels()); }
  [[nodiscard]] bool is_surface(std::size_t pixel) const { return renderer_->surface().object[pixel] != 0; }
  [[nodiscard]] Vec3 normal(std::size_t pixel) const { return renderer_->surface().normal[pixel]; }
  [[nodiscard]] Vec3 to_eye(std::size_t pixel) const {
    return glm::normalize(renderer_->surface().eye - renderer_->surface().position[pixel]);
  }
  [[nodiscard]] Vec3 to_light(std::size_t pixel) const {
    const ParamBlock& key = state_->rig.lights[0].params;
    return glm::normalize(key.vec3(*key.schema().by_role("position")) - renderer_->surface().position[pixel]);
  }
  /// What the style adds for a lookup of white, without shadows: the light itself.
  std::vector<Vec3> light_alone() {
    set("style/painting=0");
    for (const char* row : {"rim", "side", "front"}) {
      for (int k = 1; k <= 4; ++k) set("style/" + std::string(row) + "_" + std::to_string(k) + "=1,1,1");
    }
    return colors();
  }
  /// The style with a picture of its own, in which every place of the sphere has its normal as colour: 0.5 + 0.5 n.
  void use_sphere_of_normals() {
    namespace fs = std::filesystem;
    constexpr int kSize = 512;
    const fs::path folder = folder_.path() / "styles" / "normals";
    LUM_ASSERT_OK(const Style shipped, load_style(AssetRoots::standard(), "litsphere"));
    fs::create_directories(folder.parent_path());
    fs::copy(shipped.folder, folder, fs::copy_options::recursive);
    Image sphere(kSize, kSize, 3);
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        Vec2 place(2.0F * (static_cast<float>(x) + 0.5F) / kSize - 1.0F,
                   1.0F - 2.0F * (static_cast<float>(y) + 0.5F) / kSize);
        place /= std::max(glm::length(place), 1.0F);
        const Vec3 n(place, std::sqrt(std::max(1.0F - glm::dot(place, place), 0.0F)));
        sphere.set_rgb(static_cast<std::size_t>(y * kSize + x), 0.5F + 0.5F * n);
      }
    }
    const fs::path picture = folder / "textures" / "sphere.png";
    LUM_ASSERT_OK(const std::string png, encode_png(sphere, Encoding::kSrgb));
    LUM_EXPECT_OK(write_file_atomic(picture, png));
    LUM_ASSERT_OK(const Style own, load_style(AssetRoots({folder_.path()}), "normals"));
    use_style(own);
    drop_shadows();
  }

  TemporaryFolder folder_;
};

TEST_F(LitSphere, ShowsTheTexelOfItsNormalOverLightAndEye) {
  use_style("litsphere");
  drop_shadows();
  const std::vector<Vec3> light = light_alone();
  set("style/steepness=1");
  const std::array<const char*, 3> rows{"rim", "side", "front"};
  const auto texel = [](int row, int k) {
    return Vec3(0.2F + 0.2F * static_cast<float>(k), 0.3F + 0.3F * static_cast<float>(row), 0.5F);
  };
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 4; ++k) {
      const Vec3 c = texel(row, k);
      set("style/" + std::string(rows[static_cast<std::size_t>(row)]) + "_" + std::to_string(k + 1) + "=" +
          std::to_string(c.x) + "," + std::to_string(c.y) + "," + std::to_string(c.z));
    }
  }
  const std::vector<Vec3> shown = colors();
  std::array<std::array<int, 4>, 3> seen{};
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (!is_surface(i) || light[i].x < 1e-3F) continue;
    const float across = 4.0F * (0.5F + 0.5F * glm::dot(normal(i), to_light(i)));
    const float front = 3.0F * std::max(glm::dot(normal(i), to_eye(i)), 0.0F);
    // Steps are at whole numbers; 0.004 wide in a texture of 1 they are 0.016 and 0.012 wide here.
    if (std::abs(across - std::round(across)) < 0.02F || std::abs(front - std::round(front)) < 0.02F) continue;
    const int k = std::min(static_cast<int>(across), 3);
    const int row = std::min(static_cast<int>(front), 2);
    ++seen[static_cast<std::size_t>(row)][static_cast<std::size_t>(k)];
    ASSERT_LT(glm::length(shown[i] / light[i] - texel(row, k)), 1e-3F) << across << ' ' << front;
  }
  for (std::size_t k = 1; k < 4; ++k) EXPECT_GT(seen[1][k], 20) << k;
  for (std::size_t row = 0; row < 3; ++row) EXPECT_GT(seen[row][2], 20) << row;
}

TEST_F(LitSphere, ShowsThePlaceOfThePaintedSphereThatItsNormalTurnsTo) {
  use_sphere_of_normals();
  light_alone();
  const Vec3 painted_from = glm::normalize(Vec3(-0.5F, 0.6F, 0.62F));
  for (const Vec3 position : {Vec3(3, 4, 3), Vec3(-4, 2, 2.5F), Vec3(0.5F, 5, -1), Vec3(0, 2.5F, 7)}) {
    state_->rig.lights[0] = aimed_light(*types_, "key", renderer_->frame(), position, Vec3(0, -0.3F, 0), Vec3(1));
    drop_shadows();
    set("style/painting=0");
    const std::vector<Vec3> white = colors();
    set("style/painting=1");
    const std::vector<Vec3> shown = colors();
    int compared = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
      if (!is_surface(i) || white[i].x < 1e-3F) continue;
      const Vec3 place = 2.0F * (shown[i] / white[i]) - 1.0F;
      if (place.z < 0.3F) continue;  // towards the rim a texel is many degrees
      ++compared;
      // A turn keeps the angle to the light. 8 bits of sRGB are 0.009 of a normal, texels as much; sums of three.
      ASSERT_NEAR(glm::dot(place, painted_from), glm::dot(normal(i), to_light(i)), 0.03F) << position.x;
    }
    EXPECT_GT(compared, 300) << position.x;
  }
}

TEST_F(LitSphere, IsThePictureItselfWhereTheLightStandsAsItWasPainted) {
  use_sphere_of_normals();
  const std::vector<Vec3> white = light_alone();
  set("style/painting=1");
  int compared = 0;
  for (std::size_t i = 0; i < white.size(); i += 7) {
    if (!is_surface(i) || white[i].x < 1e-3F) continue;
    // The light's place in the frame of this pixel's ray becomes the place that the sphere was painted from.
    const Vec3 view = to_eye(i);
    const Vec3 right = glm::normalize(glm::cross(Vec3(0.0F, 1.0F, 0.0F), view));
    const Vec3 up = glm::cross(view, right);
    const auto in_frame = [&](const Vec3& v) { return Vec3(glm::dot(v, right), glm::dot(v, up), glm::dot(v, view)); };
    const Vec3 l = in_frame(to_light(i));
    state_->style.set_vec3(param(state_->style, "painted_from"), l);
    SampleSet one{1000 + i, {static_cast<std::uint32_t>(i)}};
    const Vec3 shown = evaluate({&*state_, 0}, one).front() / white[i];
    const Vec3 n = in_frame(normal(i));
    if (n.z < 0.2F) continue;
    ++compared;
    ASSERT_LT(glm::length(2.0F * shown - 1.0F - n), 0.03F) << "8 bits, and texels of 1/256 of the radius";
  }
  EXPECT_GT(compared, 300);
}

TEST_F(LitSphere, CastShadowsTakeTheColourOfWhatFacesAway) {
  use_style("litsphere");
  const std::vector<Vec3> light = light_alone();
  for (const char* row : {"rim", "side", "front"}) set("style/" + std::string(row) + "_1=0,0,0");
  const std::vector<Vec3> shadowed = colors();
  set("style/shadow=0");
  const std::vector<Vec3> unshadowed = colors();
  int dark = 0;
  for (std::size_t i = 0; i < light.size(); ++i) {
    if (!is_surface(i) || light[i].x < 1e-3F) continue;
    if (glm::dot(normal(i), to_light(i)) < 0.3F) continue;
    ASSERT_NEAR(unshadowed[i].x / light[i].x, 1.0F, 1e-3F);
    dark += shadowed[i].x < 0.01F * light[i].x ? 1 : 0;
  }
  EXPECT_GT(dark, 100);
}

}  // namespace
}  // namespace luminist
