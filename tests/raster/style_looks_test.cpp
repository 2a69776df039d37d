// What the shipped styles promise, measured on pictures of which geometry tells the tones.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "raster/renderer_fixture.h"
#include "render/metric.h"

namespace luminist {
namespace {

float luminance(const Vec3& color) {
  return glm::dot(color, Vec3(0.2126F, 0.7152F, 0.0722F));  // as in shaders/lib/helpers.glsl
}

class StyleLooksTest : public RendererTest {
 protected:
  void set(const std::string& assignment) { LUM_EXPECT_OK(set_path(*state_, assignment)); }
  void use(const std::string& style, std::initializer_list<std::string> assignments) {
    use_style(style);
    set("ambient/color=0,0,0");
    for (const std::string& each : assignments) set(each);
  }
  std::vector<Vec3> colors_of_light(int light) { return evaluate({&*state_, light}, all_pixels(), softness_); }
  [[nodiscard]] bool is_surface(std::size_t pixel) const { return renderer_->surface().object[pixel] != 0; }
  [[nodiscard]] float cosine(std::size_t pixel, int light) {
    const ParamBlock& params = this->light(light);
    const Vec3 way = params.vec3(*params.schema().by_role("position")) - renderer_->surface().position[pixel];
    return glm::dot(glm::normalize(way), renderer_->surface().normal[pixel]);
  }
  [[nodiscard]] float facing_eye(std::size_t pixel) const {
    const SurfaceBuffer& surface = renderer_->surface();
    return glm::dot(glm::normalize(surface.eye - surface.position[pixel]), surface.normal[pixel]);
  }

  Softness softness_;
};

TEST_F(StyleLooksTest, ToonCutsTheCosineIntoAsManyTonesAsAsked) {
  const std::array<float, 4> thresholds{0.1F, 0.4F, 0.65F, 0.9F};
  for (int bands = 1; bands <= 4; ++bands) {
    use("toon", {"style/bright=1,1,1", "style/dark=1,1,1", "style/shadow=1,1,1"});
    drop_shadows();
    const std::vector<Vec3> full = colors_of_light(0);
    for (const char* each :
         {"style/dark=0,0,0", "style/threshold=0.1", "style/threshold_2=0.4", "style/threshold_3=0.65",
          "style/threshold_4=0.9", "style/feather=0", "style/feather_2=0", "style/feather_3=0", "style/feather_4=0"}) {
      set(each);
    }
    set("style/bands=" + std::to_string(bands));
    const std::vector<Vec3> banded = colors_of_light(0);
    std::array<int, 5> seen{};
    for (std::size_t i = 0; i < full.size(); ++i) {
      if (!is_surface(i) || full[i].x < 1e-3F) continue;
      const float c = cosine(i, 0);
      int passed = 0;
      bool at_edge = false;
      for (int k = 0; k < bands; ++k) {
        passed += c > thresholds[static_cast<std::size_t>(k)] ? 1 : 0;
        at_edge = at_edge || std::abs(c - thresholds[static_cast<std::size_t>(k)]) < 1e-3F;
      }
      if (at_edge) continue;
      ++seen[static_cast<std::size_t>(passed)];
      ASSERT_NEAR(banded[i].x / full[i].x, static_cast<float>(passed) / static_cast<float>(bands), 1e-3F) << c;
    }
    for (int k = 0; k <= bands; ++k) EXPECT_GT(seen[static_cast<std::size_t>(k)], 20) << bands << " bands";
  }
}

TEST_F(StyleLooksTest, ToonGivesCastShadowsAColourOfTheirOwn) {
  use("toon", {"style/bright=1,1,1", "style/dark=1,1,1", "style/shadow=1,1,1"});
  const std::vector<Vec3> full = colors_of_light(0);
  set("style/shadow=0.25,0.5,0.75");
  const std::vector<Vec3> shadowed = colors_of_light(0);
  set("style/shadow=0,0,0");
  const std::vector<Vec3> black = colors_of_light(0);
  int in_shadow = 0;
  for (std::size_t i = 0; i < full.size(); ++i) {
    if (!is_surface(i) || full[i].x < 1e-3F) continue;
    const Vec3 share = black[i] / full[i];  // what no shadow takes
    const Vec3 wanted = share + (1.0F - share) * Vec3(0.25F, 0.5F, 0.75F);
    ASSERT_LT(glm::length(shadowed[i] / full[i] - wanted), 1e-3F);
    if (share.x < 1e-3F) {
      ++in_shadow;
      ASSERT_GT(cosine(i, 0), 0.2F) << "what faces away is dark, not in a cast shadow";
    }
  }
  EXPECT_GT(in_shadow, 100);
}

TEST_F(StyleLooksTest, InToonTheStrongestLightMayWin) {
  use("toon", {});
  const std::vector<Vec3> key = colors_of_light(0);
  const std::vector<Vec3> fill = colors_of_light(1);
  const std::vector<Vec3> sum = colors_of_light(Candidate::kAllLights);
  set("style/combine=strongest");
  const std::vector<Vec3> strongest = colors_of_light(Candidate::kAllLights);
  std::array<int, 2> wins{};
  for (std::size_t i = 0; i < key.size(); ++i) {
    ASSERT_LT(glm::length(sum[i] - key[i] - fill[i]), 1e-5F);
    const float lead = luminance(key[i]) - luminance(fill[i]);
    if (std::abs(lead) < 0.04F * luminance(sum[i]) + 1e-5F) continue;
    ++wins[lead > 0.0F ? 0 : 1];
    ASSERT_LT(glm::length(strongest[i] - (lead > 0.0F ? key[i] : fill[i])), 1e-5F);
  }
  EXPECT_GT(wins[0], 1000);
  EXPECT_GT(wins[1], 100);
}

TEST_F(StyleLooksTest, ToonDrawsRimsAtSilhouettesAndHighlightsWhereTheyMirror) {
  use("toon", {});
  drop_shadows();
  const std::vector<Vec3> plain = colors_of_light(0);
  set("style/rim=1,1,1");
  set("style/rim_width=0.3");
  const std::vector<Vec3> rimmed = colors_of_light(0);
  set("style/rim=0,0,0");
  set("style/highlight=1,1,1");
  set("style/highlight_size=0.2");
  const std::vector<Vec3> shiny = colors_of_light(0);
  int rims = 0;
  int highlights = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    if (!is_surface(i)) continue;
    const bool edge = facing_eye(i) < 0.3F + 0.03F && cosine(i, 0) > -0.03F;
    const bool has_rim = glm::length(rimmed[i] - plain[i]) > 1e-5F;
    ASSERT_TRUE(edge || !has_rim);
    rims += has_rim ? 1 : 0;
    const SurfaceBuffer& surface = renderer_->surface();
    const ParamBlock& params = light(0);
    const Vec3 to_light = glm::normalize(params.vec3(*params.schema().by_role("position")) - surface.position[i]);
    const Vec3 halfway = glm::normalize(to_light + glm::normalize(surface.eye - surface.position[i]));
    const bool mirrors = glm::length(glm::cross(surface.normal[i], halfway)) < 0.2F + 0.03F;
    const bool has_highlight = glm::length(shiny[i] - plain[i]) > 1e-5F;
    ASSERT_TRUE(mirrors || !has_highlight);
    highlights += has_highlight ? 1 : 0;
  }
  EXPECT_GT(rims, 20);
  EXPECT_GT(highlights, 20);
}

TEST_F(StyleLooksTest, ARampOfOneColourIsThatColourAndTexelsAreFoundInOrder) {
  use("ramp", {});
  drop_shadows();
  for (int k = 1; k <= 6; ++k) set("style/texel_" + std::to_string(k) + "=1,1,1");
  const std::vector<Vec3> full = colors_of_light(0);
  set("style/steepness=1");
  for (int k = 1; k <= 6; ++k) {
    const std::string tone = std::to_string(0.2 * (k - 1));
    set("style/texel_" + std::to_string(k) + "=" + tone + "," + tone + "," + tone);
  }
  const std::vector<Vec3> ramped = colors_of_light(0);
  std::array<int, 6> seen{};
  for (std::size_t i = 0; i < full.size(); ++i) {
    if (!is_surface(i) || full[i].x < 1e-3F) continue;
    const float x = 6.0F * (0.5F + 0.5F * cosine(i, 0));
    if (std::abs(x - std::round(x)) < 0.03F) continue;
    const int texel = std::min(static_cast<int>(x), 5);
    ++seen[static_cast<std::size_t>(texel)];
    ASSERT_NEAR(ramped[i].x / full[i].x, 0.2F * static_cast<float>(texel), 1e-3F) << x;
  }
  EXPECT_GE(std::ranges::count_if(seen, [](int n) { return n > 10; }), 5);
}

TEST_F(StyleLooksTest, GoochGoesFromCoolToWarm) {
  use("gooch",
      {"style/cool=0,0,1", "style/warm=1,0,0", "style/cool_albedo=0", "style/warm_albedo=0", "style/highlight=0"});
  drop_shadows();
  const std::vector<Vec3> colors = colors_of_light(0);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const float sum = colors[i].x + colors[i].z;
    if (!is_surface(i) || sum < 1e-3F) continue;
    const ParamBlock& params = light(0);
    const Vec3 color = params.vec3(*params.schema().by_role("color"));
    const float red = colors[i].x / color.x;
    const float blue = colors[i].z / color.z;
    ASSERT_NEAR(red / (red + blue), 0.5F + 0.5F * cosine(i, 0), 1e-3F);
  }
}

class HalftoneTest : public StyleLooksTest {
 protected:
  /// A floor that fills the picture, under ambient light alone: one tone everywhere.
  void use_flat_tone(float tone) {
    scene_.objects.erase(scene_.objects.begin());
    scene_.cameras = {camera_towards({0.0F, 4.0F, 0.01F}, {0.0F, -1.1F, 0.0F})};
    use("halftone", {"style/albedo=0", "style/contrast=1", "style/ink=0,0,0", "style/paper=1,1,1"});
    state_->rig.lights.clear();
    const std::string text = std::to_string(tone);
    set("ambient/color=" + text + "," + text + "," + text);
  }
};

TEST_F(HalftoneTest, TheMeanInkIsTheToneWithinTwoHundredths) {
  for (const float tone : {0.05F, 0.2F, 0.4F, 0.5F, 0.6F, 0.8F, 0.95F}) {
    scene_ = small_scene();
    use_flat_tone(tone);
    for (const char* frequency : {"style/frequency=12", "style/frequency=20"}) {
      set(frequency);
      LUM_ASSERT_OK(const Image picture, renderer_->render(*state_));
      double sum = 0.0;
      float least = 1.0F;
      float most = 0.0F;
      for (std::size_t i = 0; i < picture.pixels(); ++i) {
        sum += static_cast<double>(picture.rgb(i).x);
        least = std::min(least, picture.rgb(i).x);
        most = std::max(most, picture.rgb(i).x);
      }
      EXPECT_NEAR(sum / static_cast<double>(picture.pixels()), tone, 0.02) << frequency;
      EXPECT_GT(most - least, 0.5F) << "it is drawn in dots";
    }
  }
}

TEST_F(HalftoneTest, SamplesSeeTheMeanToneAndColoursAtPixelsTheBlurredPicture) {
  use_flat_tone(0.3F);
  const SampleSet samples = all_pixels();
  for (const Vec3& color : evaluate({&*state_, Candidate::kAllLights}, samples)) ASSERT_NEAR(color.x, 0.3F, 1e-4F);
  LUM_ASSERT_OK(const Image picture, renderer_->render(*state_));
  const Image compared = as_compared(picture, renderer_->style().metric);
  std::vector<Vec3> colors(samples.pixels.size());
  LUM_EXPECT_OK(renderer_->colors_at(*state_, {}, samples.pixels, colors));
  for (std::size_t i = 0; i < colors.size(); ++i) ASSERT_EQ(colors[i], compared.rgb(i));
}

TEST_F(HalftoneTest, TheDotsLieOnThePictureAndNotOnTheScene) {
  use_flat_tone(0.3F);
  set("style/frequency=14");
  LUM_ASSERT_OK(const Image near, renderer_->render(*state_));
  scene_.cameras = {camera_towards({0.3F, 2.5F, 0.01F}, {0.3F, -1.1F, 0.0F})};
  LUM_ASSERT_OK(renderer_, RasterRenderer::create(*device_, scene_, scene_.cameras[0], *types_, *style_,
                                                  AssetRoots::standard(), kWidth, kHeight));
  LUM_ASSERT_OK(const Image far, renderer_->render(*state_));
  double difference = 0.0;
  for (std::size_t i = 0; i < near.pixels(); ++i) difference += std::abs(near.rgb(i).x - far.rgb(i).x);
  EXPECT_LT(difference / static_cast<double>(near.pixels()), 1e-3);
}

}  // namespace
}  // namespace luminist
