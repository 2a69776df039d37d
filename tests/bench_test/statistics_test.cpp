#include "bench/bench_statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace luminist {
namespace {

TEST(BenchStatistics, TheMedianIsTheMiddleOrTheMeanOfTheTwoInTheMiddle) {
  EXPECT_DOUBLE_EQ(median(std::vector<double>{5.0, 1.0, 3.0}), 3.0);
  EXPECT_DOUBLE_EQ(median(std::vector<double>{4.0, 1.0, 3.0, 100.0}), 3.5);
  EXPECT_DOUBLE_EQ(median(std::vector<double>{}), 0.0);
}

TEST(BenchStatistics, ABoundAboveTheMiddleLeavesTheMedianExact) {
  const Bounded middle = median(std::vector<Bounded>{{1.0, false}, {2.0, false}, {9.0, true}});
  EXPECT_DOUBLE_EQ(middle.value, 2.0);
  EXPECT_FALSE(middle.at_least);
}

TEST(BenchStatistics, ABoundUpToTheMiddleMakesTheMedianABound) {
  EXPECT_TRUE(median(std::vector<Bounded>{{1.0, true}, {2.0, false}, {9.0, false}}).at_least);
  EXPECT_TRUE(median(std::vector<Bounded>{{1.0, false}, {2.0, true}, {9.0, false}}).at_least);
  EXPECT_TRUE(median(std::vector<Bounded>{{1.0, false}, {2.0, true}}).at_least);
}

TEST(BenchStatistics, TheExponentOfAPowerLawIsFound) {
  const std::array<double, 4> x{1.0, 10.0, 100.0, 1000.0};
  std::array<double, 4> y{};
  for (std::size_t i = 0; i < x.size(); ++i) y[i] = 7.0 * std::pow(x[i], 1.5);
  EXPECT_NEAR(exponent(x, y), 1.5, 1e-12);  // exact up to rounding
}

TEST(BenchStatistics, OnePointHasNoExponent) {
  const std::array<double, 2> same{3.0, 3.0};
  const std::array<double, 2> y{1.0, 2.0};
  EXPECT_DOUBLE_EQ(exponent(same, y), 0.0);
}

}  // namespace
}  // namespace luminist
