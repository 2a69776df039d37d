#include "trace/panel_view.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace luminist {
namespace {

RigLight panel(float side) {
  RigLight light;
  light.kind = RigLight::Kind::kArea;
  light.position = Vec3(0.3F, 2.0F, -0.2F);
  light.axis = Vec3(0.0F, -1.0F, 0.0F);
  light.right = Vec3(1.0F, 0.0F, 0.0F);
  light.up = Vec3(0.0F, 0.0F, 1.0F);
  light.half_side = 0.5F * side;
  return light;
}

/// Of a fine grid of the panel's parts, which fall into the four quarters of its area.
std::array<double, 4> covered(const RigLight& light, const Vec3& from) {
  constexpr int kGrid = 400;
  std::array<double, 4> sums{};
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const Vec2 place((static_cast<float>(i) + 0.5F) / kGrid, (static_cast<float>(j) + 0.5F) / kGrid);
      const Vec3 way = light.panel_point(place) - from;
      const double square = glm::dot(way, way);
      const double cosine = std::abs(glm::dot(way, light.axis)) / std::sqrt(square);
      sums[static_cast<std::size_t>(2 * (2 * i / kGrid) + 2 * j / kGrid)] +=
          cosine / square * light.panel_area() / (kGrid * kGrid);
    }
  }
  return sums;
}

TEST(PanelView, ChoosesPointsEvenlyOverTheSolidAngle) {
  const RigLight light = panel(1.6F);
  for (const Vec3& from : {Vec3(0.0F), Vec3(0.9F, 1.7F, 0.4F), Vec3(-3.0F, 1.0F, 2.0F), Vec3(0.3F, 1.99F, -0.2F)}) {
    const PanelView view(light, from);
    const std::array<double, 4> wanted = covered(light, from);
    const double all = wanted[0] + wanted[1] + wanted[2] + wanted[3];
    EXPECT_NEAR(view.solid_angle(), all, 2e-3 * all) << "the grid is coarse where the panel is near";
    EXPECT_NEAR(view.pdf(7.0F, 0.5F) * all, 1.0, 2e-3);
    std::array<double, 4> got{};
    constexpr int kGrid = 100;
    for (int i = 0; i < kGrid; ++i) {
      for (int j = 0; j < kGrid; ++j) {
        const Vec3 point = view.point({(static_cast<float>(i) + 0.5F) / kGrid, (static_cast<float>(j) + 0.5F) / kGrid});
        EXPECT_NEAR(point.y, light.position.y, 1e-5F);
        const Vec3 across = point - light.position;
        ASSERT_LE(std::max(std::abs(across.x), std::abs(across.z)), light.half_side + 1e-5F);
        got[static_cast<std::size_t>(2 * (across.x >= 0.0F ? 1 : 0) + (across.z >= 0.0F ? 1 : 0))] += 1.0;
      }
    }
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(got[k] / (kGrid * kGrid), wanted[k] / all, 0.015) << k;
  }
}

TEST(PanelView, TakesWhatLooksSmallEvenlyOverItsArea) {
  const RigLight light = panel(0.1F);
  const PanelView view(light, Vec3(0.0F));
  EXPECT_EQ(view.point({0.25F, 0.75F}), light.panel_point({0.25F, 0.75F}));
  EXPECT_FLOAT_EQ(view.pdf(4.0F, 0.5F), 4.0F / (0.5F * light.panel_area()));
}

}  // namespace
}  // namespace luminist
