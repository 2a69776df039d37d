#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "raster/mesh_scenes.h"
#include "raster/raster_renderer.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

constexpr int kHatchedWidth = 256;
constexpr int kHatchedHeight = 256;

/// Black ink on white paper; tones are 1 - darkness without exponent or albedo.
class HatchingTest : public testing::Test {
 protected:
  void SetUp() override {
    LUM_ASSERT_OK(device_, Device::create_headless());
    LUM_ASSERT_OK(types_, LightTypes::load(AssetRoots::standard()));
    LUM_ASSERT_OK(style_, load_style(AssetRoots::standard(), "hatching"));
  }
  void look_at(const Scene& scene, const Camera& camera) {
    LUM_ASSERT_OK(renderer_, RasterRenderer::create(*device_, scene, camera, *types_, *style_, AssetRoots::standard(),
                                                    kHatchedWidth, kHatchedHeight));
    state_ = initial_state(*types_, *style_, renderer_->frame());
    for (const char* setting :
         {"style/ink=0,0,0", "style/paper=1,1,1", "style/contrast=1", "style/albedo=0", "style/size=0.004"}) {
      set(setting);
    }
  }
  void set(const std::string& setting) { LUM_EXPECT_OK(set_path(*state_, setting)); }
  void set_ambient(double level) {
    const std::string number = std::to_string(level);
    set("ambient/color=" + number + "," + number + "," + number);
  }
  /// Ink of every pixel, 0 to 1.
  std::vector<float> ink() {
    const Image picture = renderer_->render(*state_).value();
    std::vector<float> values(picture.pixels());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1.0F - picture.rgb(i).g;
    return values;
  }
  /// Of every pixel the tone that its strokes stand for.
  std::vector<float> darkness() {
    SampleSet samples;
    samples.id = 3;
    for (std::uint32_t i = 0; i < kHatchedWidth * kHatchedHeight; ++i) samples.pixels.push_back(i);
    std::vector<Vec3> colors(samples.pixels.size());
    const Candidate candidate{&*state_, Candidate::kAllLights};
    LUM_EXPECT_OK(renderer_->evaluate({&candidate, 1}, samples, {}, colors));
    std::vector<float> values;
    for (const Vec3& c : colors) values.push_back(1.0F - c.g);
    return values;
  }
  static double mean(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float v : values) sum += v;
    return sum / static_cast<double>(values.size());
  }
  static Scene wall() {
    Scene scene;
    test::add(scene, test::quad_mesh(), "wall", test::moved(Vec3(0), Vec3(20.0F)));
    return scene;
  }

  std::optional<Device> device_;
  std::optional<LightTypes> types_;
  std::optional<Style> style_;
  std::unique_ptr<RasterRenderer> renderer_;
  std::optional<ParamState> state_;
};

TEST_F(HatchingTest, MeanInkIsTheToneInEverySetAtEveryScale) {
  for (const float distance : {6.0F, 11.0F, 25.0F}) {
    look_at(wall(), test::looking(Vec3(0, 0, distance), Vec3(0)));
    for (const char* strokes : {"pencil", "ink", "stipple"}) {
      set(std::string("style/strokes=") + strokes);
      for (const double tone : {0.0, 0.08, 0.25, 0.5, 0.75, 0.95, 1.0}) {
        set_ambient(1.0 - tone);
        // What an artist is promised, and half of it again for a picture that shows no whole number of tiles.
        EXPECT_NEAR(mean(ink()), tone, 0.03) << strokes << " from " << distance;
      }
    }
  }
}

TEST_F(HatchingTest, StrokesAreAsDenseNearAsFar) {
  const auto strokes_on = [&](float distance) {
    look_at(wall(), test::looking(Vec3(0, 0, distance), Vec3(0)));
    set_ambient(0.7);
    const std::vector<float> values = ink();
    int edges = 0;
    for (std::size_t i = kHatchedWidth; i < values.size(); ++i)
      edges += (values[i] > 0.5F) != (values[i - kHatchedWidth] > 0.5F) ? 1 : 0;
    for (std::size_t i = 1; i < values.size(); ++i) edges += (values[i] > 0.5F) != (values[i - 1] > 0.5F) ? 1 : 0;
    return static_cast<double>(edges);
  };
  const double near = strokes_on(6.0F);
  // From six to twenty-four the surface shrinks to a quarter; strokes that shrank with it would be four times as dense.
  EXPECT_NEAR(strokes_on(12.0F) / near, 1.0, 0.25);
  EXPECT_NEAR(strokes_on(24.0F) / near, 1.0, 0.25);
}

TEST_F(HatchingTest, WhatIsInkedStaysInkedWhereItGetsDarker) {
  Scene scene;
  test::add(scene, test::sphere_mesh(1.0F), "ball");
  look_at(scene, test::looking(Vec3(0, 1, 4), Vec3(0)));
  std::vector<float> before(static_cast<std::size_t>(kHatchedWidth) * kHatchedHeight, 0.0F);
  for (const double light : {0.9, 0.7, 0.5, 0.3, 0.1}) {
    set_ambient(light);
    const std::vector<float> now = ink();
    for (std::size_t i = 0; i < now.size(); ++i) ASSERT_GE(now[i], before[i] - 1e-4F);  // rounding of a threshold
    before = now;
  }
}

TEST_F(HatchingTest, ATurningLightMovesNoMoreInkThanTone) {
  Scene scene;
  test::add(scene, test::sphere_mesh(1.0F), "ball");
  test::add(scene, test::quad_mesh(), "floor", test::laid_down(-1.0F, 4.0F));
  look_at(scene, test::looking(Vec3(0, 2, 6), Vec3(0)));
  LightRig& rig = state_->rig;
  rig.lights.push_back(make_light(*types_, "cinematic", "key", renderer_->frame()).value());
  set("lights/key/barn=1,1,0.2");
  double inked = 0.0;
  double toned = 0.0;
  std::vector<float> last_ink;
  std::vector<float> last_tone;
  for (int step = 0; step < 12; ++step) {
    const double angle = 0.1 * step;
    const Vec3 from(5.0 * std::sin(angle), 4.0, 5.0 * std::cos(angle));
    set("lights/key/position=" + std::to_string(from.x) + "," + std::to_string(from.y) + "," + std::to_string(from.z));
    set("lights/key/direction=" + std::to_string(-from.x) + "," + std::to_string(-from.y) + "," +
        std::to_string(-from.z));
    const std::vector<float> now = ink();
    const std::vector<float> tone = darkness();
    for (std::size_t i = 0; i < now.size() && step > 0; ++i) {
      inked += std::abs(now[i] - last_ink[i]);
      toned += std::abs(tone[i] - last_tone[i]);
    }
    last_ink = now;
    last_tone = tone;
  }
  ASSERT_GT(toned, 1000.0);
  // A threshold is crossed once for each change of tone by one: ink that flickered would move more. The tone of a
  // sample has the rays' shadows, that of the picture the maps'.
  EXPECT_LT(inked, 1.25 * toned);
}

TEST_F(HatchingTest, GoesAroundWhatBends) {
  // Strokes along the way of the largest curvature: around a cylinder, so that ink changes faster along its axis.
  Mesh tube;
  constexpr int kSides = 64;
  for (int row = 0; row <= 40; ++row) {
    for (int i = 0; i < kSides; ++i) {
      const double a = 2.0 * kPi * i / kSides;
      tube.positions.emplace_back(std::cos(a), row * 0.1 - 2.0, std::sin(a));
      tube.normals.emplace_back(std::cos(a), 0.0, std::sin(a));
    }
  }
  for (std::uint32_t row = 0; row < 40; ++row) {
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const std::uint32_t a = row * kSides + i;
      const std::uint32_t b = row * kSides + (i + 1) % kSides;
      tube.triangles.push_back({a, a + kSides, b + kSides});
      tube.triangles.push_back({a, b + kSides, b});
    }
  }
  Scene scene;
  test::add(scene, std::move(tube), "tube");
  look_at(scene, test::looking(Vec3(0, 0, 5), Vec3(0)));
  set_ambient(0.7);
  const std::vector<float> values = ink();
  double along = 0.0;
  double around = 0.0;
  for (int y = 100; y < 156; ++y) {
    for (int x = 100; x < 156; ++x) {
      const auto i = static_cast<std::size_t>(y * kHatchedWidth + x);
      along += std::abs(values[i] - values[i + kHatchedWidth]);
      around += std::abs(values[i] - values[i + 1]);
    }
  }
  EXPECT_GT(along, 2.0 * around);
}

}  // namespace
}  // namespace luminist
