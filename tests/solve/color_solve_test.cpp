#include "solve/color_solve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solve/random.h"

namespace luminist {
namespace {

constexpr ColorRange kFree{{true, true, true}, {0.0, 0.0, 0.0}, {4.0, 4.0, 4.0}};

/// Cells with a random picture of two lights as their target.
struct ColorProblem {
  SampleCells cells;
  CellField rest;
  CellField first;
  CellField second;
};

ColorProblem random_colors(std::uint64_t seed, int count, const Vec3& a, const Vec3& b) {
  Random random(seed);
  ColorProblem problem;
  const auto draw = [&] {
    return Vec3(static_cast<float>(random.uniform()), static_cast<float>(random.uniform()),
                static_cast<float>(random.uniform()));
  };
  for (int c = 0; c < count; ++c) {
    problem.rest.push_back(0.1F * draw());
    problem.first.push_back(draw());
    problem.second.push_back(draw());
    problem.cells.target.push_back(problem.rest.back() + a * problem.first.back() + b * problem.second.back());
    problem.cells.weight.push_back(1.0 / count);
  }
  return problem;
}

double cost_of(const ColorProblem& p, const Vec3& a, const Vec3& b, Norm norm) {
  CellField picture = p.rest;
  for (std::size_t c = 0; c < picture.size(); ++c) picture[c] += a * p.first[c] + b * p.second[c];
  return cell_cost(p.cells, picture, norm);
}

TEST(SolveColors, FindsTheColoursThatMadeThePicture) {
  const Vec3 a(1.5F, 0.3F, 0.9F);
  const Vec3 b(0.2F, 2.0F, 0.6F);
  const ColorProblem p = random_colors(1, 60, a, b);
  for (const Norm norm : {Norm::kUnsquared, Norm::kSquared}) {
    std::vector<Vec3> colors{Vec3(1.0F), Vec3(1.0F)};
    const std::vector<const CellField*> white{&p.first, &p.second};
    const std::vector<ColorRange> ranges{kFree, kFree};
    solve_colors(p.cells, p.rest, white, ranges, norm, colors);
    EXPECT_LT(glm::distance(colors[0], a), 1e-3F);  // float fields, a ridge of 1e-7
    EXPECT_LT(glm::distance(colors[1], b), 1e-3F);
  }
}

TEST(SolveColors, IsNearlyAsGoodAsTheBestOfAGridWhenNothingFits) {
  ColorProblem p = random_colors(2, 40, Vec3(1.0F), Vec3(0.5F));
  Random random(9);
  for (Vec3& target : p.cells.target) target += Vec3(static_cast<float>(random.normal()) * 0.3F);
  std::vector<Vec3> colors{Vec3(2.0F)};
  const std::vector<const CellField*> white{&p.first};
  const std::vector<ColorRange> ranges{kFree};
  solve_colors(p.cells, p.rest, white, ranges, Norm::kUnsquared, colors);
  double best = 1e9;
  for (int i = 0; i <= 40; ++i) {
    for (int j = 0; j <= 40; ++j) {
      for (int k = 0; k <= 40; ++k) {
        const Vec3 color = 0.05F * Vec3(static_cast<float>(i), static_cast<float>(j), static_cast<float>(k));
        best = std::min(best, cost_of(p, color, Vec3(0.0F), Norm::kUnsquared));
      }
    }
  }
  EXPECT_LT(cost_of(p, colors[0], Vec3(0.0F), Norm::kUnsquared), 1.01 * best);  // three reweightings
}

TEST(SolveColors, StaysInRangeAndLeavesLockedChannelsAlone) {
  const ColorProblem p = random_colors(3, 30, Vec3(5.0F, 1.0F, -1.0F), Vec3(0.0F));
  std::vector<Vec3> colors{Vec3(1.0F, 0.7F, 1.0F)};
  const std::vector<const CellField*> white{&p.first};
  const std::vector<ColorRange> ranges{{{true, false, true}, {0.0, 0.0, 0.0}, {4.0, 4.0, 4.0}}};
  solve_colors(p.cells, p.rest, white, ranges, Norm::kSquared, colors);
  EXPECT_FLOAT_EQ(colors[0].x, 4.0F);
  EXPECT_FLOAT_EQ(colors[0].y, 0.7F);
  EXPECT_FLOAT_EQ(colors[0].z, 0.0F);
}

TEST(SolveColors, NeverCostsMoreThanItsStart) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    ColorProblem p = random_colors(seed, 12, Vec3(0.5F), Vec3(1.0F));
    Random random(seed + 100);
    for (Vec3& target : p.cells.target) target += random.direction();
    const Vec3 a(static_cast<float>(random.uniform(0.0, 2.0)));
    const Vec3 b(static_cast<float>(random.uniform(0.0, 2.0)));
    std::vector<Vec3> colors{a, b};
    const std::vector<const CellField*> white{&p.first, seed % 5 == 0 ? &p.first : &p.second};  // twins too
    const std::vector<ColorRange> ranges{kFree, kFree};
    if (seed % 5 == 0) p.second = p.first;
    solve_colors(p.cells, p.rest, white, ranges, Norm::kUnsquared, colors);
    EXPECT_LE(cost_of(p, colors[0], colors[1], Norm::kUnsquared),
              cost_of(p, a, b, Norm::kUnsquared) * (1.0 + 1e-6));  // float pictures
  }
}

}  // namespace
}  // namespace luminist
