#include "raster/raster_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <random>

#include "raster/renderer_fixture.h"
#include "render/metric.h"

namespace luminist {
namespace {

using RasterRendererTest = RendererTest;

double mean_of(const Image& image) {
  double sum = 0.0;
  for (const float v : image.data) sum += static_cast<double>(v);
  return sum / static_cast<double>(image.data.size());
}

float largest_difference(const Image& a, const Image& b) {
  float largest = 0.0F;
  for (std::size_t i = 0; i < a.data.size(); ++i) largest = std::max(largest, std::abs(a.data[i] - b.data[i]));
  return largest;
}

TEST_F(RasterRendererTest, APictureIsLitAndFiniteAndRepeatsItsBits) {
  use_style("cinematic");
  LUM_ASSERT_OK(const Image first, renderer_->render(*state_));
  EXPECT_EQ(first.width, kWidth);
  EXPECT_EQ(first.height, kHeight);
  EXPECT_EQ(first.channels, 3);
  for (const float v : first.data) ASSERT_TRUE(std::isfinite(v) && v >= 0.0F);
  EXPECT_GT(mean_of(first), 0.05);
  ParamState other = *state_;
  other.rig.lights[0].params.set_vec3(0, Vec3(1.0F, 5.0F, 1.0F));
  LUM_ASSERT_OK(const Image between, renderer_->render(other));
  EXPECT_NE(between.data, first.data);
  LUM_ASSERT_OK(const Image again, renderer_->render(*state_));
  EXPECT_EQ(again.data, first.data) << "what was rendered in between leaves no trace";
}

TEST_F(RasterRendererTest, MutedLightsAddNothingAndShadowsOnlyTakeLight) {
  use_style("cinematic");
  LUM_ASSERT_OK(const Image all, renderer_->render(*state_));
  LUM_ASSERT_OK(const Image free, renderer_->render(*state_, {.shadows = false}));
  for (std::size_t i = 0; i < all.data.size(); ++i) ASSERT_LE(all.data[i], free.data[i] + 1e-6F);
  EXPECT_LT(mean_of(all), 0.98 * mean_of(free));
  ParamState muted = *state_;
  muted.rig.lights[1].muted = true;
  ParamState removed = *state_;
  removed.rig.lights.pop_back();
  LUM_ASSERT_OK(const Image a, renderer_->render(muted));
  LUM_ASSERT_OK(const Image b, renderer_->render(removed));
  EXPECT_EQ(a.data, b.data);
  muted.rig.lights[0].muted = true;
  LUM_ASSERT_OK(const Image dim, renderer_->render(muted));
  EXPECT_GT(mean_of(dim), 0.0) << "the ambient light is left";
  EXPECT_LT(mean_of(dim), 0.2 * mean_of(all));
}

TEST_F(RasterRendererTest, ASharedShadowLightGivesItsShadowsToAll) {
  use_style("cinematic");
  state_->rig.shadow_light = "key";
  LUM_ASSERT_OK(const Image shared, renderer_->render(*state_));
  // The fill light, moved: with the key's shadows its own place moves no shadow.
  state_->rig.lights[0].params.set_vec3(*light(0).schema().by_role("color"), Vec3(0.0F));
  const SampleSet samples = all_pixels();
  const std::vector<Vec3> fill = evaluate({&*state_, 1}, samples);
  state_->rig.shadow_light.clear();
  const std::vector<Vec3> own = evaluate({&*state_, 1}, samples);
  int differ = 0;
  for (std::size_t i = 0; i < fill.size(); ++i) differ += glm::length(fill[i] - own[i]) > 1e-3F ? 1 : 0;
  EXPECT_GT(differ, kWidth * kHeight / 100);
  EXPECT_GT(mean_of(shared), 0.0);
}

TEST_F(RasterRendererTest, AnErrorOfMovingLightsIsThatOfTheWholePicture) {
  for (const char* style : {"cinematic", "toon"}) {
    use_style(style);
    Target target;
    LUM_ASSERT_OK(target.color, renderer_->render(*state_));
    target.importance = Image(kWidth, kHeight, 1, 1.0F);
    const std::array<int, 1> moving{1};
    for (int step = 0; step < 3; ++step) {
      light(1).set_vec3(*light(1).schema().by_role("position"), Vec3(0.5F * static_cast<float>(step), 2.0F, 1.0F));
      if (step == 2) light(0).set_vec3(*light(0).schema().by_role("color"), Vec3(0.3F));  // one that should stand still
      const double shades = renderer_->work().shades;
      LUM_ASSERT_OK(const double whole, renderer_->error(*state_, target));
      const double whole_shades = renderer_->work().shades - shades;
      LUM_ASSERT_OK(const double quick, renderer_->error(*state_, target, moving));
      EXPECT_NEAR(quick, whole, 1e-6) << style << ", step " << step;  // another order of sums
      const double quick_shades = renderer_->work().shades - shades - whole_shades;
      if (step == 1) {
        EXPECT_LT(quick_shades, whole_shades) << "what stands still is kept";
      }
      LUM_ASSERT_OK(const Image whole_picture, renderer_->render(*state_));
      LUM_ASSERT_OK(const Image quick_picture, renderer_->render(*state_, {.moving = moving}));
      EXPECT_LT(largest_difference(whole_picture, quick_picture), 1e-4F) << style << ", step " << step;
    }
  }
}

TEST_F(RasterRendererTest, ColoursAtPixelsAreThePicturesAlsoWithoutALight) {
  use_style("cinematic");
  const SampleSet samples = all_pixels();
  std::vector<Vec3> colors(samples.pixels.size());
  ParamState muted = *state_;
  muted.rig.lights[0].muted = true;
  const std::array<int, 1> without{0};
  for (const ParamState* wanted : {&*state_, &muted}) {
    LUM_ASSERT_OK(const Image picture, renderer_->render(*wanted));
    LUM_ASSERT_OK(const Image other, renderer_->render(wanted == &muted ? *state_ : muted));
    const std::span<const int> left_out = wanted == &muted ? std::span<const int>(without) : std::span<const int>();
    LUM_EXPECT_OK(renderer_->colors_at(*state_, left_out, samples.pixels, colors));
    for (std::size_t i = 0; i < colors.size(); ++i) {
      ASSERT_LT(glm::length(colors[i] - picture.rgb(samples.pixels[i])), 1e-5F);  // another order of sums
    }
  }
}

TEST_F(RasterRendererTest, WhatStandsStillIsMadeAnewWhenTheShadowsItUsesTurn) {
  use_style("cinematic");
  state_->rig.shadow_light = "key";
  const SampleSet samples = all_pixels();
  std::vector<Vec3> colors(samples.pixels.size());
  const std::array<int, 1> without{0};
  LUM_EXPECT_OK(renderer_->colors_at(*state_, without, samples.pixels, colors));
  const std::vector<Vec3> before = colors;
  // The key turns away: its map sees nothing of the scene, and what no map sees is lit.
  light(0).set_vec3(*light(0).schema().by_role("direction"), -light(0).vec3(*light(0).schema().by_role("direction")));
  LUM_EXPECT_OK(renderer_->colors_at(*state_, without, samples.pixels, colors));
  int differ = 0;
  for (std::size_t i = 0; i < colors.size(); ++i) differ += glm::length(colors[i] - before[i]) > 1e-3F ? 1 : 0;
  EXPECT_GT(differ, kWidth * kHeight / 100);
}

TEST_F(RasterRendererTest, ABatchOfCandidatesIsThePictureWithoutShadows) {
  for (const char* style : {"cinematic", "toon"}) {
    use_style(style);
    drop_shadows();
    LUM_ASSERT_OK(const Image picture, renderer_->render(*state_, {.shadows = false}));
    const std::vector<Vec3> samples = evaluate({&*state_, Candidate::kAllLights}, all_pixels());
    int edge = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      // The same program on the same entries: equal but for pixels that are antialiased.
      if (picture.rgb(i) != samples[i]) ++edge;
    }
    EXPECT_LT(edge, kWidth * kHeight / 8) << style;
    EXPECT_GT(edge, 0) << "the silhouette is antialiased";
  }
}

TEST_F(RasterRendererTest, RaysAndShadowMapsSeeTheSameShadows) {
  use_style("cinematic");
  LUM_ASSERT_OK(const Image picture, renderer_->render(*state_));
  Softness softness;
  softness.shadow_rays = 16;
  const std::vector<Vec3> samples = evaluate({&*state_, Candidate::kAllLights}, all_pixels(), softness);
  double difference = 0.0;
  double bias = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3 d = samples[i] - picture.rgb(i);
    difference += static_cast<double>(glm::length(d)) / static_cast<double>(samples.size());
    bias += static_cast<double>(d.x + d.y + d.z) / static_cast<double>(3 * samples.size());
  }
  // Antialiased silhouettes and the noise of 16 rays in penumbrae differ by about 1 %; as many are brighter as darker.
  EXPECT_LT(difference, 0.02 * mean_of(picture));
  EXPECT_LT(std::abs(bias), 0.001 * mean_of(picture));
}

TEST_F(RasterRendererTest, TermsOfLightsAddUpToTheWhole) {
  for (const char* style : {"cinematic", "toon"}) {
    use_style(style);
    const SampleSet samples = all_pixels();
    std::vector<Candidate> candidates{{&*state_, Candidate::kAllLights}, {&*state_, Candidate::kNoLights}};
    for (int i = 0; i < 2; ++i) candidates.push_back({&*state_, i});
    std::vector<Vec3> out(candidates.size() * samples.pixels.size());
    LUM_EXPECT_OK(renderer_->evaluate(candidates, samples, {}, out));
    const std::size_t n = samples.pixels.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 sum = out[n + i] + out[2 * n + i] + out[3 * n + i];
      // Three roundings of numbers about 1.
      ASSERT_LT(glm::length(sum - out[i]), 1e-6F + 1e-6F * glm::length(out[i])) << style << " pixel " << i;
    }
  }
}

TEST_F(RasterRendererTest, ATermIsLinearInTheLightsColour) {
  for (const char* style : {"cinematic", "toon"}) {
    use_style(style);
    const SampleSet samples = all_pixels();
    const std::vector<Vec3> one = evaluate({&*state_, 0}, samples);
    const int color = *light(0).schema().by_role("color");
    light(0).set_vec3(color, 3.0F * light(0).vec3(color));
    const std::vector<Vec3> three = evaluate({&*state_, 0}, samples);
    for (std::size_t i = 0; i < one.size(); ++i) {
      ASSERT_LT(glm::length(three[i] - 3.0F * one[i]), 1e-6F + 2e-6F * glm::length(three[i])) << style;
    }
  }
}

TEST_F(RasterRendererTest, ABatchMayHaveMoreLightsThanTheDeviceTakesAtOnceAndARigMayNot) {
  use_style("cinematic");
  drop_shadows();
  const std::size_t block = state_->rig.lights[0].params.bytes().size();
  const std::size_t capacity = static_cast<std::size_t>(device_->info().max_uniform_block_bytes) / block;
  SampleSet samples;
  samples.id = 3;
  samples.pixels = {kWidth * (kHeight / 2) + kWidth / 2, kWidth * (kHeight - 5) + kWidth / 2};
  const std::vector<Vec3> one = evaluate({&*state_, 0}, samples);
  ASSERT_GT(one[0].x, 0.01F);
  std::vector<ParamState> states(capacity + 10, *state_);
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < states.size(); ++k) {
    ParamBlock& params = states[k].rig.lights[0].params;
    const int color = *params.schema().by_role("color");
    params.set_vec3(color, static_cast<float>(k) * params.vec3(color));
    candidates.push_back({&states[k], 0});
  }
  std::vector<Vec3> out(candidates.size() * samples.pixels.size());
  LUM_EXPECT_OK(renderer_->evaluate(candidates, samples, {}, out));
  for (std::size_t k = 0; k < states.size(); ++k) {
    const Vec3 wanted = static_cast<float>(k) * one[0];
    ASSERT_LT(glm::length(out[2 * k] - wanted), 1e-6F + 2e-6F * glm::length(wanted)) << "candidate " << k;
  }

  ParamState crowd = *state_;
  crowd.rig.lights.resize(capacity + 1, crowd.rig.lights[0]);
  const Candidate all{&crowd, Candidate::kAllLights};
  EXPECT_EQ(error_of(renderer_->evaluate({&all, 1}, samples, {}, std::span(out).first(2))).kind, ErrorKind::kLimit);
  EXPECT_EQ(error_of(renderer_->render(crowd, {.shadows = false})).kind, ErrorKind::kLimit);
}

TEST_F(RasterRendererTest, TheErrorIsThatOfTheReference) {
  use_style("cinematic");
  Target target;
  LUM_ASSERT_OK(const Image picture, renderer_->render(*state_));
  target.color = picture;
  target.before = picture;
  target.importance = Image(kWidth, kHeight, 1);
  target.stroke.assign(picture.pixels(), 0);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  for (float& v : target.importance.data) v = unit(random);
  EXPECT_EQ(renderer_->error(*state_, target).value(), 0.0);
  for (float& v : target.color.data) v += 0.3F * unit(random);
  const double reference = picture_error(picture, target, {});
  EXPECT_NEAR(renderer_->error(*state_, target).value(), reference, 1e-5 * reference);
  Style blurred = *style_;
  blurred.metric.blur = 0.02F;
  use_style(blurred);
  const double soft = picture_error(picture, target, blurred.metric);
  EXPECT_NEAR(renderer_->error(*state_, target).value(), soft, 1e-5 * soft);
  EXPECT_LT(soft, reference) << "the blur averages noise";
}

TEST_F(RasterRendererTest, CountsTheWorkOfPicturesAndSamples) {
  use_style("cinematic");
  const double pixels = kWidth * kHeight;
  const WorkCount before = renderer_->work();
  LUM_EXPECT_OK(renderer_->render(*state_));
  EXPECT_EQ(renderer_->work().shades - before.shades, 2.0 * pixels);
  EXPECT_EQ(renderer_->work().shadow_queries - before.shadow_queries, 2.0 * pixels);
  EXPECT_EQ(renderer_->work().pictures - before.pictures, 1.0);

  SampleSet samples;
  samples.id = 5;
  const SurfaceBuffer& surface = renderer_->surface();
  for (std::uint32_t i = 0; samples.pixels.size() < 100; ++i) {
    if (surface.object[i * 31] != 0) samples.pixels.push_back(i * 31);
  }
  Softness softness;
  softness.shadow_rays = 3;
  const WorkCount start = renderer_->work();
  evaluate({&*state_, Candidate::kAllLights}, samples, softness);
  EXPECT_EQ(renderer_->work().shades - start.shades, 200.0);
  EXPECT_EQ(renderer_->work().shadow_queries - start.shadow_queries, 600.0);
  light(0).set_vec3(*light(0).schema().by_role("color"), Vec3(0.5F));
  const WorkCount second = renderer_->work();
  evaluate({&*state_, 0}, samples, softness);
  EXPECT_EQ(renderer_->work().shades - second.shades, 100.0);
  EXPECT_EQ(renderer_->work().shadow_queries - second.shadow_queries, 0.0) << "another colour keeps the visibility";
}

TEST_F(RasterRendererTest, SurvivesAnyParameterValues) {
  for (const char* style : {"cinematic", "toon"}) {
    use_style(style);
    state_->rig.lights.push_back(make_light(*types_, "point", "bulb", renderer_->frame()).value());
    const SampleSet samples = all_pixels();
    std::mt19937 random(11);
    const float values[] = {0.0F, -1.0F, 1.0F, -0.3F, 1e-6F, -1e6F, 1e6F, 17.0F};
    for (int round = 0; round < 24; ++round) {
      ParamState hostile = *state_;
      for (ParamBlock* block : hostile.blocks()) {
        for (int p = 0; p < block->schema().size(); ++p) {
          const ParamSpec& spec = block->schema()[p];
          if (spec.type == ParamType::kChoice || random() % 3 == 0) continue;
          for (int c = 0; c < spec.components(); ++c) block->set(p, c, values[random() % std::size(values)]);
        }
      }
      for (const Vec3& color : evaluate({&hostile, Candidate::kAllLights}, samples)) ASSERT_TRUE(is_finite(color));
      LUM_EXPECT_OK(renderer_->render(hostile));
    }
  }
}

TEST_F(RasterRendererTest, AStyleWithoutNumbersIsNamedAndAFewBadPixelsBecomeBlack) {
  TemporaryFolder folder;
  LUM_ASSERT_OK(Style style, load_style(AssetRoots::standard(), "cinematic"));
  style.glsl_path = folder.file("bad.glsl");
  std::ofstream(style.glsl_path) << "vec3 shade(Surface s) { return vec3(sqrt(-abs(s.albedo.x) - 1.0)); }\n";
  use_style(style);
  const Error error = error_of(renderer_->render(*state_));
  EXPECT_EQ(error.kind, ErrorKind::kStyle);
  EXPECT_EQ(error.where, style.glsl_path);
  std::ofstream(style.glsl_path) << "vec3 shade(Surface s) {\n"
                                    "  return abs(s.position.x) < 0.002 ? vec3(sqrt(s.normal.y - 9.0)) : vec3(1.0);\n"
                                    "}\n";
  use_style(style);
  LUM_ASSERT_OK(const Image picture, renderer_->render(*state_));
  for (const float v : picture.data) ASSERT_TRUE(std::isfinite(v));
}

TEST_F(RasterRendererTest, AMistakeInAStyleIsReportedAtItsLine) {
  TemporaryFolder folder;
  LUM_ASSERT_OK(Style style, load_style(AssetRoots::standard(), "cinematic"));
  style.glsl_path = folder.file("broken.glsl");
  std::ofstream(style.glsl_path) << "vec3 shade(Surface s) {\n  return s.albedo * undeclared;\n}\n";
  const Error error = error_of(RasterRenderer::create(*device_, scene_, scene_.cameras[0], *types_, style,
                                                      AssetRoots::standard(), kWidth, kHeight));
  EXPECT_EQ(error.kind, ErrorKind::kStyle);
  EXPECT_TRUE(error.where.starts_with(style.glsl_path + ":2")) << error.message();
}

TEST_F(RasterRendererTest, RefusesAnEmptyPicture) {
  LUM_ASSERT_OK(const Style style, load_style(AssetRoots::standard(), "cinematic"));
  EXPECT_EQ(error_of(RasterRenderer::create(*device_, scene_, scene_.cameras[0], *types_, style, AssetRoots::standard(),
                                            0, 10))
                .kind,
            ErrorKind::kUsage);
}

}  // namespace
}  // namespace luminist
