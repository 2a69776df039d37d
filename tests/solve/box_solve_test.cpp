#include "solve/box_solve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "solve/random.h"

namespace luminist {
namespace {

struct BoxProblem {
  std::size_t n = 0;
  std::vector<double> a, b, low, high, x;

  [[nodiscard]] double value(std::span<const double> at) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) sum += at[i] * a[i * n + j] * at[j];
      sum -= 2.0 * b[i] * at[i];
    }
    return sum;
  }
  [[nodiscard]] double slope(std::span<const double> at, std::size_t i) const {
    double sum = -b[i];
    for (std::size_t j = 0; j < n; ++j) sum += a[i * n + j] * at[j];
    return sum;
  }
};

/// A = J'J of a random J with columns of very different lengths, two of them nearly the same.
BoxProblem random_box(std::size_t n, Random& random) {
  BoxProblem p{n, std::vector<double>(n * n, 0.0), std::vector<double>(n), {}, {}, {}};
  std::vector<std::vector<double>> rows(2 * n, std::vector<double>(n));
  for (auto& row : rows) {
    for (std::size_t i = 0; i < n; ++i) row[i] = random.normal() * std::pow(10.0, static_cast<double>(i % 4));
    if (n > 1) row[1] = row[0] * 10.0 + 0.01 * random.normal();
  }
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < n; ++i) {
      p.b[i] += random.normal() * row[i];
      for (std::size_t j = 0; j < n; ++j) p.a[i * n + j] += row[i] * row[j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    p.low.push_back(-random.uniform(0.0, 0.2));
    p.high.push_back(random.uniform(0.0, 0.2));
    p.x.push_back(0.0);
  }
  return p;
}

TEST(SolveBox, EndsWhereNoCoordinateWantsToMoveInsideItsBounds) {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    const BoxProblem p = random_box(1 + static_cast<std::size_t>(round % 12), random);
    std::vector<double> x = p.x;
    solve_box(p.a, p.b, p.low, p.high, x);
    EXPECT_LE(p.value(x), p.value(p.x));
    for (std::size_t i = 0; i < p.n; ++i) {
      ASSERT_GE(x[i], p.low[i]);
      ASSERT_LE(x[i], p.high[i]);
      const double slope = p.slope(x, i) / std::sqrt(p.a[i * p.n + i]);
      const double scale = 1e-6 * (1.0 + std::abs(p.b[i]) / std::sqrt(p.a[i * p.n + i]));  // rounding of the factors
      if (x[i] > p.low[i]) {
        EXPECT_LT(slope, scale) << "round " << round << ", coordinate " << i;
      }
      if (x[i] < p.high[i]) {
        EXPECT_GT(slope, -scale) << "round " << round << ", coordinate " << i;
      }
    }
  }
}

TEST(SolveBox, LeavesABoundThatALongStepHadMet) {
  // Without bounds x0 goes far; held at its bound it pulls x1 the other way, and then wants back itself.
  const std::vector<double> a{1.0, 0.95, 0.95, 1.0};
  const std::vector<double> b{0.2, -0.5};
  const std::vector<double> low{-1.0, -0.1};
  const std::vector<double> high{1.0, 1.0};
  std::vector<double> x{0.0, 0.0};
  solve_box(a, b, low, high, x);
  EXPECT_NEAR(x[1], -0.1, 1e-12);
  EXPECT_NEAR(x[0], 0.2 + 0.95 * 0.1, 1e-9) << "the least along x0 with x1 held";
}

TEST(SolveBox, LeavesWhatNothingDependsOn) {
  const std::vector<double> a{2.0, 0.0, 0.0, 0.0};
  const std::vector<double> b{1.0, 0.0};
  const std::vector<double> low{0.0, 0.0};
  const std::vector<double> high{1.0, 1.0};
  std::vector<double> x{0.0, 0.7};
  solve_box(a, b, low, high, x);
  EXPECT_DOUBLE_EQ(x[0], 0.5);
  EXPECT_DOUBLE_EQ(x[1], 0.7);
}

TEST(SolveBox, NothingToSolveIsSolved) {
  const std::vector<double> none;
  std::vector<double> x;
  solve_box(none, none, none, none, x);
  EXPECT_TRUE(x.empty());
}

TEST(SolveBox, StartsOutsideTheBoundsComeIn) {
  const std::vector<double> a{1.0};
  const std::vector<double> b{-3.0};
  const std::vector<double> low{0.0};
  const std::vector<double> high{1.0};
  std::vector<double> x{5.0};
  solve_box(a, b, low, high, x);
  EXPECT_DOUBLE_EQ(x[0], 0.0);
}

}  // namespace
}  // namespace luminist
