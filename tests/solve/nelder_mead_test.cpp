#include "solve/nelder_mead.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace luminist {
namespace {

template <class F>
int run(NelderMead& simplex, F&& f, int limit) {
  int evaluations = 0;
  while (!simplex.done() && evaluations < limit) {
    simplex.tell(f(simplex.point()));
    ++evaluations;
  }
  return evaluations;
}

double rosenbrock(const std::vector<double>& x) {
  return 100.0 * std::pow(x[1] - x[0] * x[0], 2.0) + std::pow(1.0 - x[0], 2.0);
}

double bowl(const std::vector<double>& x) {
  double sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += (1.0 + static_cast<double>(k)) * std::pow(x[k] - 0.3, 2.0);
  return sum;
}

TEST(NelderMead, FindsTheMinimumOfRosenbrocksValley) {
  NelderMead simplex({-1.2, 1.0}, {.size = 0.1, .tolerance = 1e-9, .restarts = 2});
  run(simplex, rosenbrock, 2000);
  EXPECT_TRUE(simplex.done());
  EXPECT_NEAR(simplex.best()[0], 1.0, 1e-4);  // f is 1e-9 or less there: sqrt of that along the valley
  EXPECT_NEAR(simplex.best()[1], 1.0, 2e-4);
}

TEST(NelderMead, FindsTheMinimumOfABowlInEightDimensions) {
  NelderMead simplex(std::vector<double>(8, 0.8), {.size = 0.1, .tolerance = 1e-9, .restarts = 3});
  run(simplex, bowl, 6000);
  EXPECT_LT(simplex.best_value(), 1e-6);
}

TEST(NelderMead, BeginsWithTheStartAndOneStepAlongEachAxis) {
  NelderMead simplex({0.5, 0.95}, {.size = 0.2});
  EXPECT_EQ(simplex.point(), (std::vector<double>{0.5, 0.95}));
  simplex.tell(1.0);
  EXPECT_EQ(simplex.point(), (std::vector<double>{0.7, 0.95}));
  simplex.tell(2.0);
  EXPECT_EQ(simplex.point(), (std::vector<double>{0.5, 0.75}));  // the other way: 1.15 is outside the cube
}

TEST(NelderMead, ReflectsTheWorstVertexThroughTheOppositeFaceThenGoesTwiceAsFar) {
  NelderMead simplex({0.0, 0.0}, {.size = 1.0});
  simplex.tell(1.0);
  simplex.tell(5.0);  // (1, 0) is the worst
  simplex.tell(2.0);  // (0, 1)
  EXPECT_EQ(simplex.point(), (std::vector<double>{-1.0, 1.0}));
  simplex.tell(0.5);  // the best so far
  EXPECT_EQ(simplex.point(), (std::vector<double>{-2.0, 1.5}));
}

TEST(NelderMead, ContractsThenShrinksTowardsTheBestWhenNothingHelps) {
  NelderMead simplex({0.0, 0.0}, {.size = 1.0});
  simplex.tell(1.0);
  simplex.tell(5.0);
  simplex.tell(2.0);
  simplex.tell(9.0);  // the reflection is worse still
  EXPECT_EQ(simplex.point(), (std::vector<double>{0.5, 0.25}));
  simplex.tell(8.0);
  EXPECT_EQ(simplex.point(), (std::vector<double>{0.5, 0.0}));
  simplex.tell(3.0);
  EXPECT_EQ(simplex.point(), (std::vector<double>{0.0, 0.5}));
}

TEST(NelderMead, RestartsFromTheMinimumWithItsFirstSizeForEver) {
  NelderMead simplex({0.9, 0.9}, {.size = 0.1, .tolerance = 1e-3, .restarts = -1});
  EXPECT_EQ(run(simplex, bowl, 3000), 3000);
  EXPECT_FALSE(simplex.done());
  EXPECT_GT(simplex.restarts(), 3);
}

TEST(NelderMead, ARestartMayBeChartedAnew) {
  NelderMead simplex({0.9}, {.size = 0.1, .tolerance = 1e-3, .restarts = -1});
  while (!simplex.restarted()) simplex.tell(bowl(simplex.point()));
  simplex.recentre({0.5});
  EXPECT_EQ(simplex.point(), (std::vector<double>{0.5}));
}

TEST(NelderMead, SurvivesValuesThatAreNotFinite) {
  NelderMead simplex({0.53, 0.5}, {.size = 0.2, .tolerance = 1e-6, .restarts = 0});
  run(
      simplex, [](const std::vector<double>& x) { return x[0] > 0.6 ? std::nan("") : bowl(x); }, 1000);
  EXPECT_LT(simplex.best_value(), 1e-4);
  NelderMead hopeless({0.5}, {.restarts = -1});
  run(
      hopeless, [](const std::vector<double>&) { return std::numeric_limits<double>::infinity(); }, 100);
  EXPECT_TRUE(hopeless.done());
}

}  // namespace
}  // namespace luminist
