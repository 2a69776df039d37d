#pragma once
// tests/raster/renderer_fixture.h -- a renderer of the small scene, made once per style and shared by its tests.
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "raster/raster_renderer.h"
#include "raster/small_scene.h"
#include "support/fixtures.h"

namespace luminist {

class RendererTest : public testing::Test {
 protected:
  static constexpr int kWidth = 144;
  static constexpr int kHeight = 112;

  void SetUp() override {
    LUM_ASSERT_OK(device_, Device::create_headless());
    LUM_ASSERT_OK(types_, LightTypes::load(AssetRoots::standard()));
    scene_ = small_scene();
  }
  /// A renderer of the small scene; its style may be changed before.
  void use_style(const std::string& name) {
    LUM_ASSERT_OK(style_, load_style(AssetRoots::standard(), name));
    use_style(*style_);
  }
  void use_style(const Style& style) {
    style_ = style;
    LUM_ASSERT_OK(renderer_, RasterRenderer::create(*device_, scene_, scene_.cameras[0], *types_, style,
                                                    AssetRoots::standard(), kWidth, kHeight));
    state_.emplace(small_state(*types_, style, renderer_->frame()));
  }
  /// Every pixel, as a sample set.
  [[nodiscard]] SampleSet all_pixels() const {
    SampleSet samples;
    samples.id = 77;
    for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) samples.pixels.push_back(i);
    return samples;
  }
  /// One candidate on a sample set.
  std::vector<Vec3> evaluate(const Candidate& candidate, const SampleSet& samples, const Softness& softness = {}) {
    std::vector<Vec3> colors(samples.pixels.size());
    LUM_EXPECT_OK(renderer_->evaluate({&candidate, 1}, samples, softness, colors));
    return colors;
  }
  ParamBlock& light(int i) { return state_->rig.lights[static_cast<std::size_t>(i)].params; }
  static int param(const ParamBlock& block, const char* name) { return block.schema().find(name).value(); }
  /// Every light's shadow_density := 0, so that shadows do not matter.
  void drop_shadows() {
    for (Light& l : state_->rig.lights) l.params.set(param(l.params, "shadow_density"), 0, 0.0);
  }

  std::optional<Device> device_;
  std::optional<LightTypes> types_;
  std::optional<Style> style_;
  Scene scene_;
  std::unique_ptr<RasterRenderer> renderer_;
  std::optional<ParamState> state_;
};

}  // namespace luminist
