#include "explore/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "solve/random.h"

namespace luminist {
namespace {

double cost_of(const std::vector<double>& costs, const std::vector<int>& pairs) {
  double sum = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) sum += costs[i * pairs.size() + static_cast<std::size_t>(pairs[i])];
  return sum;
}

TEST(Assignment, CostsAsLittleAsTheBestOfAllPermutations) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const int n = 1 + random.index(6);
    std::vector<double> costs(static_cast<std::size_t>(n * n));
    for (double& cost : costs) cost = random.index(4) == 0 ? 0.0 : random.uniform();
    std::vector<int> pairs(static_cast<std::size_t>(n));
    std::iota(pairs.begin(), pairs.end(), 0);
    double least = std::numeric_limits<double>::infinity();
    do {
      least = std::min(least, cost_of(costs, pairs));
    } while (std::next_permutation(pairs.begin(), pairs.end()));
    const std::vector<int> found = least_cost_assignment(costs, n);
    EXPECT_NEAR(cost_of(costs, found), least, 1e-12) << seed;  // exact up to rounding of the sums
    std::vector<int> sorted = found;
    std::sort(sorted.begin(), sorted.end());
    for (int i = 0; i < n; ++i) EXPECT_EQ(sorted[static_cast<std::size_t>(i)], i);
  }
}

TEST(Assignment, OfNobodyIsEmpty) {
  EXPECT_TRUE(least_cost_assignment({}, 0).empty());
}

}  // namespace
}  // namespace luminist
