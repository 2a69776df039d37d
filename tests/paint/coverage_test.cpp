#include "paint/coverage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace luminist {
namespace {

constexpr int kStrokeSide = 100;
constexpr float kDiameter = 0.2F;  // sigma is 5 pixels

double gaussian(double distance_px, double sigma_px) {
  return std::exp(-distance_px * distance_px / (2.0 * sigma_px * sigma_px));
}

float coverage_at(const Coverage& coverage, int x, int y) {
  const PixelBox& box = coverage.box;
  return x < box.x0 || y < box.y0 || x >= box.x1 || y >= box.y1 ? 0.0F : coverage.at(x, y);
}

/// The maximum over very many dabs, one by one.
double brute_force(const std::vector<StrokePoint>& points, float diameter, double x, double y) {
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    constexpr int kDabs = 20000;
    for (int k = 0; k <= kDabs; ++k) {
      const double t = static_cast<double>(k) / kDabs;
      const double px = kStrokeSide * (points[i].x + t * (points[i + 1].x - points[i].x));
      const double py = kStrokeSide * (points[i].y + t * (points[i + 1].y - points[i].y));
      const double sigma =
          kStrokeSide * diameter / 4.0 * (points[i].pressure + t * (points[i + 1].pressure - points[i].pressure));
      most = std::max(most, gaussian(std::hypot(x - px, y - py), sigma));
    }
  }
  return most;
}

TEST(Coverage, OfAClickIsAGaussianOfAQuarterDiameter) {
  const Coverage c = stroke_coverage(std::vector<StrokePoint>{{0.505F, 0.505F}}, kDiameter, kStrokeSide, kStrokeSide);
  for (const int d : {0, 1, 3, 5, 10, 19}) {
    EXPECT_NEAR(coverage_at(c, 50 + d, 50), gaussian(d, 5.0), 1e-5) << d;  // float coordinates
  }
  EXPECT_NEAR(coverage_at(c, 53, 54), gaussian(5.0, 5.0), 1e-5);
}

TEST(Coverage, AtTheBrushesCircleIsThePaintEdge) {
  const Coverage c = stroke_coverage(std::vector<StrokePoint>{{0.505F, 0.505F}}, kDiameter, kStrokeSide, kStrokeSide);
  EXPECT_NEAR(coverage_at(c, 60, 50), kPaintEdge, 1e-5);
}

TEST(Coverage, EndsAtFourSigma) {
  const Coverage c = stroke_coverage(std::vector<StrokePoint>{{0.505F, 0.505F}}, kDiameter, kStrokeSide, kStrokeSide);
  EXPECT_GT(coverage_at(c, 69, 50), 0.0F);
  EXPECT_EQ(coverage_at(c, 71, 50), 0.0F);
  EXPECT_LE(c.box.width(), 42);
}

TEST(Coverage, AlongALineDependsOnlyOnTheDistanceFromIt) {
  const Coverage c = stroke_coverage(std::vector<StrokePoint>{{0.205F, 0.405F}, {0.805F, 0.405F}}, kDiameter,
                                     kStrokeSide, kStrokeSide);
  for (int x = 20; x <= 80; ++x) {
    EXPECT_NEAR(coverage_at(c, x, 40), 1.0, 1e-6) << x;
    EXPECT_NEAR(coverage_at(c, x, 47), gaussian(7.0, 5.0), 1e-5) << x;
  }
  EXPECT_NEAR(coverage_at(c, 14, 40), gaussian(6.0, 5.0), 1e-5);  // behind the end: the distance from the end
}

TEST(Coverage, WithinOneStrokeIsTheMaximumWhereItCrossesItself) {
  const std::vector<StrokePoint> cross = {{0.2F, 0.5F}, {0.8F, 0.5F}, {0.5F, 0.2F}, {0.5F, 0.8F}};
  const Coverage c = stroke_coverage(cross, kDiameter, kStrokeSide, kStrokeSide);
  for (const auto& [x, y] : {std::pair{50, 50}, {45, 56}, {62, 58}, {30, 40}}) {
    EXPECT_NEAR(coverage_at(c, x, y), brute_force(cross, kDiameter, x + 0.5, y + 0.5), 1e-5);
  }
}

TEST(Coverage, EqualsInfinitelyDenseDabsOfChangingPressure) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> in(0.0F, 1.0F);
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<StrokePoint> line = {{in(random), in(random), in(random)}, {in(random), in(random), in(random)}};
    const Coverage c = stroke_coverage(line, 0.5F, kStrokeSide, kStrokeSide);
    for (int k = 0; k < 20; ++k) {
      const int x = static_cast<int>(in(random)*kStrokeSide);
      const int y = static_cast<int>(in(random)*kStrokeSide);
      const double wanted = brute_force(line, 0.5F, x + 0.5, y + 0.5);
      // 20,000 dabs miss the best one by little; the tail of 3e-4 is cut.
      EXPECT_NEAR(coverage_at(c, x, y), wanted, 4e-4) << trial;
    }
  }
}

TEST(Coverage, VanishesWherePressureDoes) {
  const Coverage c = stroke_coverage(std::vector<StrokePoint>{{0.2F, 0.505F, 0.0F}, {0.8F, 0.505F, 1.0F}}, kDiameter,
                                     kStrokeSide, kStrokeSide);
  EXPECT_EQ(coverage_at(c, 15, 50), 0.0F);
  EXPECT_GT(coverage_at(c, 40, 53), coverage_at(c, 30, 53));
  EXPECT_NEAR(coverage_at(c, 50, 50), 1.0, 1e-5);
}

TEST(Coverage, DoesNotChangeWhenAPointIsRepeated) {
  const std::vector<StrokePoint> once = {{0.2F, 0.3F}, {0.7F, 0.6F}};
  const std::vector<StrokePoint> twice = {{0.2F, 0.3F}, {0.2F, 0.3F}, {0.7F, 0.6F}, {0.7F, 0.6F}};
  const Coverage a = stroke_coverage(once, kDiameter, kStrokeSide, kStrokeSide);
  const Coverage b = stroke_coverage(twice, kDiameter, kStrokeSide, kStrokeSide);
  ASSERT_EQ(a.values.size(), b.values.size());
  for (std::size_t i = 0; i < a.values.size(); ++i) ASSERT_NEAR(a.values[i], b.values[i], 1e-6F);  // rounding
}

TEST(Coverage, OfAPenThatIsLiftedOnAPixelsCentreIsThatOfTheDabsBefore) {
  // At the tip sigma vanishes with the distance: their ratio stays what it is at the other end.
  const StrokePoint down{0.305F, 0.505F, 1.0F};
  const StrokePoint up{0.405F, 0.505F, 0.0F};
  for (const auto& stroke : {std::vector{down, up}, std::vector{up, down}}) {
    const Coverage c = stroke_coverage(stroke, kDiameter, kStrokeSide, kStrokeSide);
    EXPECT_NEAR(coverage_at(c, 40, 50), std::exp(-2.0), 1e-5);  // 10 pixels from sigma 5
  }
  EXPECT_EQ(coverage_at(stroke_coverage(std::vector{up}, kDiameter, kStrokeSide, kStrokeSide), 40, 50), 0.0F);
}

TEST(Coverage, IsLimitedToTheStrokesBox) {
  const Coverage c = stroke_coverage(std::vector<StrokePoint>{{0.5F, 0.5F}}, 0.02F, 1024, 1024);
  EXPECT_LE(c.values.size(), 44U * 44U);
  EXPECT_GE(c.box.x0, 512 - 22);
  EXPECT_LE(c.box.x1, 512 + 22);
}

TEST(Coverage, OfAStrokeBesideThePictureIsEmpty) {
  const Coverage c =
      stroke_coverage(std::vector<StrokePoint>{{-3.0F, 0.5F}, {-2.0F, 0.5F}}, kDiameter, kStrokeSide, kStrokeSide);
  EXPECT_TRUE(c.box.empty());
  EXPECT_TRUE(c.values.empty());
}

TEST(Coverage, ReachesIntoThePictureFromOutside) {
  const Coverage c = stroke_coverage(std::vector<StrokePoint>{{-0.05F, 0.505F}}, kDiameter, kStrokeSide, kStrokeSide);
  EXPECT_NEAR(coverage_at(c, 0, 50), gaussian(5.5, 5.0), 1e-5);
}

}  // namespace
}  // namespace luminist
