#include "trace/path_sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace luminist {
namespace {

TEST(PathSampler, EveryElementaryBoxOfSixtyFourSamplesHoldsOne) {
  for (std::uint32_t pixel = 0; pixel < 40; ++pixel) {
    for (int columns = 1; columns <= 64; columns *= 2) {
      const int rows = 64 / columns;
      std::set<int> boxes;
      for (std::uint32_t i = 0; i < 64; ++i) {
        const Vec2 p = PathSampler(5, pixel, i).pair(pixel % 7);
        boxes.insert(static_cast<int>(p.x * static_cast<float>(columns)) +
                     columns * static_cast<int>(p.y * static_cast<float>(rows)));
      }
      ASSERT_EQ(boxes.size(), 64U) << columns << " columns, pixel " << pixel;
    }
  }
}

/// Chi-square of 64000 points on 8 x 8 cells.
template <class F>
double chi_square(F&& point) {
  constexpr int kCells = 8;
  constexpr int kPoints = 64000;
  std::array<int, kCells * kCells> count{};
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const Vec2 p = point(i);
    ++count[static_cast<std::size_t>(p.x * kCells) + kCells * static_cast<std::size_t>(p.y * kCells)];
  }
  double chi = 0.0;
  const double wanted = static_cast<double>(kPoints) / (kCells * kCells);
  for (const int n : count) chi += (n - wanted) * (n - wanted) / wanted;
  return chi;
}

// With 63 degrees of freedom chance exceeds 103.4 once in a thousand; the numbers are fixed.
TEST(PathSampler, ASingleSampleIsUniformOverThePixels) {
  EXPECT_LT(chi_square([](std::uint32_t i) { return PathSampler(1, i, 3).pair(2); }), 103.4);
}

TEST(PathSampler, ASingleSampleIsUniformOverTheSeeds) {
  EXPECT_LT(chi_square([](std::uint32_t i) { return PathSampler(i, 50, 0).pair(2); }), 103.4);
  EXPECT_LT(chi_square([](std::uint32_t i) { return PathSampler(i, 7, 5).pair(0); }), 103.4);
}

TEST(PathSampler, NeighbouringSeedsHaveNothingInCommon) {
  const auto across = [](std::uint32_t i) {
    return Vec2(PathSampler(2 * i, 50, 0).pair(2).x, PathSampler(2 * i + 1, 50, 0).pair(2).x);
  };
  EXPECT_LT(chi_square(across), 103.4);
  const auto dimensions = [](std::uint32_t i) {
    return Vec2(PathSampler(i, 50, 1).pair(2).x, PathSampler(i, 50, 1).pair(3).y);
  };
  EXPECT_LT(chi_square(dimensions), 103.4);
}

TEST(PathSampler, DimensionsOfAPixelDoNotKnowOfEachOther) {
  double product = 0.0;
  constexpr int kPixels = 20000;
  for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
    const PathSampler sampler(1, pixel, 0);
    product += static_cast<double>((sampler.pair(0).x - 0.5F) * (sampler.pair(1).x - 0.5F));
  }
  // Of independent numbers the product has standard deviation 1/12; four of its mean.
  EXPECT_NEAR(product / kPixels, 0.0, 4.0 / 12.0 / std::sqrt(kPixels));
}

TEST(PathSampler, IntegratesASmoothFunctionFasterThanChanceWould) {
  const auto rms = [](std::uint32_t samples) {
    double square = 0.0;
    for (std::uint32_t pixel = 0; pixel < 200; ++pixel) {
      double sum = 0.0;
      for (std::uint32_t i = 0; i < samples; ++i) {
        const Vec2 p = PathSampler(2, pixel, i).pair(1);
        sum += static_cast<double>(p.x) * static_cast<double>(p.y);
      }
      square += std::pow(sum / samples - 0.25, 2.0);
    }
    return std::sqrt(square / 200);
  };
  // Chance halves the error when samples are four times as many; scrambled nets do much better on smooth functions.
  EXPECT_LT(rms(256), rms(16) / 30.0);
}

}  // namespace
}  // namespace luminist
