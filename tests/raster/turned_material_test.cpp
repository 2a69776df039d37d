// Materials that are turned look like materials that were made so.
#include <algorithm>

#include "raster/renderer_fixture.h"

namespace luminist {
namespace {

class TurnedMaterialTest : public RendererTest {
 protected:
  void use(const std::string& style) {
    use_style(style);
    LUM_ASSERT_OK(const auto schema, load_material_schema(AssetRoots::standard()));
    state_->materials = material_params(scene_.materials, *schema);
  }
  Image picture() {
    auto image = renderer_->render(*state_);
    EXPECT_TRUE(image);
    return image ? *image : Image(1, 1, 3);
  }
  /// The picture of a scene whose materials are the state's, by an engine of its own.
  Image made_so() {
    Scene scene = with_materials(scene_, state_->materials);
    auto other = RasterRenderer::create(*device_, scene, scene.cameras[0], *types_, *style_, AssetRoots::standard(),
                                        kWidth, kHeight);
    EXPECT_TRUE(other);
    ParamState as_is = *state_;
    as_is.materials.clear();
    auto image = (*other)->render(as_is);
    EXPECT_TRUE(image);
    return image ? *image : Image(1, 1, 3);
  }
  static float largest_difference(const Image& a, const Image& b) {
    float most = 0.0F;
    for (std::size_t i = 0; i < a.data.size(); ++i) most = std::max(most, std::abs(a.data[i] - b.data[i]));
    return most;
  }
  void set(const std::string& assignment) { LUM_EXPECT_OK(set_path(*state_, assignment)); }
};

TEST_F(TurnedMaterialTest, DefaultsChangeNoBit) {
  for (const char* style : {"cinematic", "toon", "hatching"}) {
    use(style);
    const Image with = picture();
    state_->materials.clear();
    EXPECT_EQ(picture().data, with.data) << style;
  }
}

TEST_F(TurnedMaterialTest, OtherMaterialsChangeNoBit) {
  use("cinematic");
  const Image before = picture();
  set("materials/white/tint=0.3,0.6,0.9");
  const Image after = picture();
  int ball = 0;
  for (std::size_t i = 0; i < before.pixels(); ++i) {
    const bool inside = renderer_->surface().material[i] == 1 && before.rgb(i) == after.rgb(i);
    ball += inside ? 1 : 0;
  }
  EXPECT_GT(ball, 1500);  // of about 1,800; its edge pixels have floor in them
  EXPECT_GT(largest_difference(before, after), 0.05F);
}

TEST_F(TurnedMaterialTest, TheyLookLikeMaterialsThatWereMadeSo) {
  for (const char* style : {"cinematic", "toon", "litsphere"}) {
    use(style);
    const Image before = picture();
    set("materials/clay/tint=0.4,1.2,0.9");
    set("materials/clay/roughness=0.25");
    set("materials/clay/specular=4");
    set("materials/white/roughness=0.4");
    const Image turned = picture();
    // Single precision in two orders of operations. Styles whose edges depend on albedo may choose edge pixels anew.
    EXPECT_LT(largest_difference(turned, made_so()), 2e-4F) << style;
    EXPECT_GT(largest_difference(turned, before), 0.02F) << style;
  }
}

TEST_F(TurnedMaterialTest, EachCandidateHasItsOwn) {
  use("cinematic");
  const SampleSet samples = all_pixels();
  std::vector<ParamState> states(10, *state_);
  LUM_EXPECT_OK(set_path(states[1], "materials/clay/tint=0.2,0.9,1.1"));
  LUM_EXPECT_OK(set_path(states[4], "materials/clay/roughness=0.2"));
  LUM_EXPECT_OK(set_path(states[5], "materials/clay/roughness=0.2"));
  LUM_EXPECT_OK(set_path(states[9], "materials/white/tint=0.5,0.5,0.5"));
  std::vector<Candidate> candidates;
  for (const ParamState& state : states) candidates.push_back({&state});
  candidates[5].light = 0;
  std::vector<Vec3> colors(states.size() * samples.pixels.size());
  LUM_EXPECT_OK(renderer_->evaluate(candidates, samples, {}, colors));
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const std::vector<Vec3> alone = evaluate(candidates[k], samples);
    EXPECT_TRUE(std::equal(alone.begin(), alone.end(), colors.begin() + static_cast<std::ptrdiff_t>(k * alone.size())))
        << k;
  }
  const std::vector<Vec3> first(colors.begin(), colors.begin() + static_cast<std::ptrdiff_t>(samples.pixels.size()));
  EXPECT_NE(evaluate(candidates[1], samples), first);
  EXPECT_NE(evaluate(candidates[4], samples), first);
}

TEST_F(TurnedMaterialTest, WhatIsKeptOfStillLightsFollowsThem) {
  use("cinematic");
  const std::vector<std::uint32_t> pixels = all_pixels().pixels;
  const std::vector<int> without{0};
  std::vector<Vec3> before(pixels.size());
  std::vector<Vec3> after(pixels.size());
  LUM_EXPECT_OK(renderer_->colors_at(*state_, without, pixels, before));
  set("materials/clay/tint=0.5,0.5,0.5");
  LUM_EXPECT_OK(renderer_->colors_at(*state_, without, pixels, after));
  std::size_t pixel = 0;
  while (renderer_->surface().material[pixel] != 1 || before[pixel].x < 0.02F) ++pixel;
  EXPECT_LT(after[pixel].x, 0.8F * before[pixel].x);  // its highlight stays

  Target target;
  LUM_ASSERT_OK(target.color, renderer_->render(*state_));
  target.before = target.color;
  target.importance = Image(kWidth, kHeight, 1, 1.0F);
  const std::vector<int> moving{0};
  LUM_ASSERT_OK(const double same, renderer_->error(*state_, target, moving));
  set("materials/clay/tint=0.6,0.5,0.5");
  LUM_ASSERT_OK(const double other, renderer_->error(*state_, target, moving));
  EXPECT_LT(same, 1e-6);
  EXPECT_GT(other, 1e-3);
}

}  // namespace
}  // namespace luminist
