#include "raster/sample_visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "raster/small_scene.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

/// A row of points on the floor y = 0, from x = -2 to 2, under a square of half side 0.5 at height 1.
class SampleVisibilityTest : public testing::Test {
 protected:
  static constexpr int kPoints = 401;

  void SetUp() override {
    Scene scene;
    scene.meshes = {floor_square(6.0F, 0.0F), floor_square(0.5F, 1.0F)};
    scene.materials.emplace_back();
    for (int mesh : {0, 1}) {
      Object object;
      object.mesh = mesh;
      scene.objects.push_back(object);
    }
    LUM_ASSERT_OK(rays_, RayScene::create(scene));
    surface_.width = kPoints;
    surface_.height = 1;
    for (int i = 0; i < kPoints; ++i) {
      surface_.position.emplace_back(-2.0F + 0.01F * static_cast<float>(i), 0.0F, 0.0F);
      surface_.normal.emplace_back(0.0F, 1.0F, 0.0F);
    }
    surface_.object.assign(kPoints, 1);
    samples_.id = 1;
    samples_.pixels.resize(kPoints);
    std::iota(samples_.pixels.begin(), samples_.pixels.end(), 0U);
    lamp_.kind = ShadowKind::kSpot;
    lamp_.position = {0.0F, 2.0F, 0.0F};
    lamp_.direction = {0.0F, -1.0F, 0.0F};
    lamp_.softness = 0.002F;
    lamp_.size_px = 2048;
  }
  std::vector<float> column(SampleVisibility& visibility, const ShadowLight& light,
                            const Softness& softness = {}) const {
    const auto values = visibility.column(light, samples_, softness);
    return {values.begin(), values.end()};
  }

  std::optional<RayScene> rays_;
  SurfaceBuffer surface_;
  SampleSet samples_;
  ShadowLight lamp_;
};

TEST_F(SampleVisibilityTest, AShadowLiesWhereTheGeometrySays) {
  SampleVisibility visibility(*rays_, surface_);
  const std::vector<float> lit = column(visibility, lamp_);
  for (int i = 0; i < kPoints; ++i) {
    const float x = surface_.position[static_cast<std::size_t>(i)].x;
    // The square's edge at height 1, seen from height 2, falls on |x| = 1; the filter reaches 0.002 * sqrt(5).
    if (std::abs(std::abs(x) - 1.0F) < 0.015F) continue;
    EXPECT_EQ(lit[static_cast<std::size_t>(i)], std::abs(x) < 1.0F ? 0.0F : 1.0F) << "at x = " << x;
  }
}

TEST_F(SampleVisibilityTest, ASunsShadowIsAsLargeAsWhatCastsItAndTurnsWithIt) {
  SampleVisibility visibility(*rays_, surface_);
  ShadowLight sun{ShadowKind::kSun, Vec3(0.0F), Vec3(0.0F, -1.0F, 0.0F), 6.0F, 0.005F, 2048};
  for (const float shift : {0.0F, 0.8F}) {
    sun.direction = glm::normalize(Vec3(shift, -1.0F, 0.0F));
    const std::vector<float> lit = column(visibility, sun);
    for (int i = 0; i < kPoints; ++i) {
      const float x = surface_.position[static_cast<std::size_t>(i)].x - shift;
      if (std::abs(std::abs(x) - 0.5F) < 0.015F) continue;
      EXPECT_EQ(lit[static_cast<std::size_t>(i)], std::abs(x) < 0.5F ? 0.0F : 1.0F) << "at x = " << x;
    }
  }
}

TEST_F(SampleVisibilityTest, AWideFilterBlursTheEdgeAndKeepsItsPlace) {
  SampleVisibility visibility(*rays_, surface_);
  Softness softness;
  softness.shadow_angle = 0.2F;
  const std::vector<float> lit = column(visibility, lamp_, softness);
  const auto mean = [&](float from, float to) {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < kPoints; ++i) {
      const float x = surface_.position[static_cast<std::size_t>(i)].x;
      if (x < from || x > to) continue;
      sum += static_cast<double>(lit[static_cast<std::size_t>(i)]);
      ++count;
    }
    return sum / count;
  };
  // 41 samples of 4 stratified rays: the mean of a half-covered disc is good to about 0.02.
  EXPECT_NEAR(mean(0.8F, 1.2F), 0.5, 0.06);
  EXPECT_GT(mean(0.7F, 0.9F), 0.02);
  EXPECT_LT(mean(1.1F, 1.3F), 0.98);
  EXPECT_EQ(mean(-0.3F, 0.3F), 0.0);
  EXPECT_EQ(mean(1.7F, 2.0F), 1.0);
}

TEST_F(SampleVisibilityTest, OnlyANewPlaceOrAnotherFilterCostsRays) {
  SampleVisibility visibility(*rays_, surface_);
  const std::vector<float> first = column(visibility, lamp_);
  EXPECT_EQ(visibility.queries(), 4.0 * kPoints);
  ShadowLight turned = lamp_;
  turned.direction = glm::normalize(Vec3(0.3F, -1.0F, 0.1F));
  EXPECT_EQ(column(visibility, turned), first);
  EXPECT_EQ(visibility.queries(), 4.0 * kPoints);
  ShadowLight moved = lamp_;
  moved.position.x = 0.1F;
  EXPECT_NE(column(visibility, moved), first);
  EXPECT_EQ(visibility.queries(), 8.0 * kPoints);
  Softness softness;
  softness.shadow_rays = 1;
  column(visibility, lamp_, softness);
  EXPECT_EQ(visibility.queries(), 9.0 * kPoints);
}

TEST_F(SampleVisibilityTest, ForgetsTheColumnThatWasUsedLongestAgo) {
  SampleVisibility visibility(*rays_, surface_, 2 * kPoints);
  ShadowLight second = lamp_;
  second.position.x = 0.2F;
  ShadowLight third = lamp_;
  third.position.x = 0.4F;
  column(visibility, lamp_);
  column(visibility, second);
  column(visibility, lamp_);
  column(visibility, third);
  visibility.trim();
  const double before = visibility.queries();
  column(visibility, lamp_);
  column(visibility, third);
  EXPECT_EQ(visibility.queries(), before);
  column(visibility, second);
  EXPECT_GT(visibility.queries(), before);
}

TEST_F(SampleVisibilityTest, TheBackgroundAndLightsWithoutShadowsAreLit) {
  std::fill(surface_.object.begin(), surface_.object.end(), 0U);
  SampleVisibility visibility(*rays_, surface_);
  const std::vector<float> all(kPoints, 1.0F);
  EXPECT_EQ(column(visibility, lamp_), all);
  ShadowLight none = lamp_;
  none.kind = ShadowKind::kNone;
  EXPECT_EQ(column(visibility, none), all);
  EXPECT_EQ(visibility.queries(), 0.0);
}

TEST(SampleDisc, CoversTheDiscEvenlyWithEveryShortRun) {
  for (std::uint32_t start : {0U, 17U, 1000U}) {
    std::array<int, 8> wedge{};
    Vec2 mean(0.0F);
    for (std::uint32_t i = start; i < start + 16; ++i) {
      for (int j = 0; j < 4; ++j) {
        const Vec2 p = sample_disc(i, j, 4);
        EXPECT_LE(glm::length(p), 1.0F);
        mean += p / 64.0F;
        const double turn = std::atan2(static_cast<double>(p.y), static_cast<double>(p.x)) / kPi + 1.0;
        ++wedge[std::min<std::size_t>(7, static_cast<std::size_t>(4.0 * turn))];
      }
    }
    EXPECT_LT(glm::length(mean), 0.05F) << "64 random points would miss the centre by 0.09";
    for (const int hits : wedge) EXPECT_NEAR(hits, 8, 2);
  }
}

}  // namespace
}  // namespace luminist
