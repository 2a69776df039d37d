#include <gtest/gtest.h>

#include <numeric>

#include "prep/chart_map.h"
#include "prep/chart_packing.h"
#include "prep/nasty_meshes.h"
#include "raster/mesh_scenes.h"

namespace luminist {
namespace {

Region all_of(const WeldedMesh& surface) {
  Region region(surface.triangles.size());
  std::iota(region.begin(), region.end(), 0U);
  return region;
}

long characteristic(const Disc& disc) {
  const std::size_t edges = (3 * disc.triangles.size() + disc.border.size()) / 2;
  return static_cast<long>(disc.points.size() + disc.triangles.size()) - static_cast<long>(edges);
}

/// A grid of squares in a plane, `count` a side, each cut in two.
Disc square_disc(std::uint32_t count) {
  WeldedMesh surface;
  const auto index = [&](std::uint32_t i, std::uint32_t j) { return j * (count + 1) + i; };
  for (std::uint32_t j = 0; j <= count; ++j) {
    for (std::uint32_t i = 0; i <= count; ++i) {
      surface.positions.emplace_back(i, j, 0.0F);
      if (i == count || j == count) continue;
      surface.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      surface.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return disc_of(surface, sides_of(surface), all_of(surface)).value_or(Disc{});
}

std::vector<glm::dvec2> as_it_lies(const Disc& disc) {
  std::vector<glm::dvec2> places;
  for (const glm::dvec3& p : disc.points) places.emplace_back(p.x, p.y);
  return places;
}

TEST(Disc, OfATubeIsCutAlongItsHeight) {
  const WeldedMesh tube = repair(test::tube_mesh(0.5, 2.0, 32, 12)).surface;
  const auto disc = disc_of(tube, sides_of(tube), all_of(tube));
  ASSERT_TRUE(disc);
  EXPECT_EQ(characteristic(*disc), 1);
  EXPECT_EQ(disc->points.size(), tube.positions.size() + 13) << "the points of one straight way are there twice";
}

TEST(Disc, OfATorusWithAHoleIsCutAroundBothWays) {
  const WeldedMesh torus = repair(test::torus_mesh(1.0, 0.4, 24, 12)).surface;
  Region region = all_of(torus);
  EXPECT_FALSE(disc_of(torus, sides_of(torus), region)) << "a closed surface has no border to cut from";
  region.erase(region.begin());
  const auto disc = disc_of(torus, sides_of(torus), region);
  ASSERT_TRUE(disc);
  EXPECT_EQ(characteristic(*disc), 1);
  EXPECT_LE(disc->border.size(), 3U + 2U * (24U + 12U)) << "no longer than a way around each";
}

TEST(Disc, OfAFlatSquareNeedsNoCut) {
  const Disc disc = square_disc(4);
  EXPECT_EQ(disc.points.size(), 25U);
  EXPECT_EQ(disc.border.size(), 16U);
}

TEST(ChartMap, EveryMethodIsTrueOnWhatItCanDo) {
  const Disc disc = square_disc(6);
  const auto conformal = map_disc(disc, ChartMethod::kLscm);
  ASSERT_TRUE(conformal);
  EXPECT_NEAR(distortion_of(disc, *conformal).angle, 1.0, 1e-6) << "a flat surface has a conformal map";
  for (const ChartMethod round : {ChartMethod::kMeanValue, ChartMethod::kTutte}) {
    const auto places = map_disc(disc, round);
    ASSERT_TRUE(places) << name_of(round);
    EXPECT_EQ(distortion_of(disc, *places).flipped, 0U) << name_of(round);
    const double first = glm::length((*places)[disc.border[0]] - glm::dvec2(0.5));
    for (const std::uint32_t point : disc.border) {
      EXPECT_NEAR(glm::length((*places)[point] - glm::dvec2(0.5)), first, 1e-6) << "the border is a circle";
    }
  }
}

TEST(ChartMap, AsRigidAsPossibleUndoesABend) {
  const Disc disc = square_disc(6);
  std::vector<glm::dvec2> places = as_it_lies(disc);
  for (glm::dvec2& p : places) p.x += 0.05 * p.y * p.y;
  const double before = distortion_of(disc, places).stretch;
  const auto after = as_rigid_as_possible(disc, places);
  ASSERT_TRUE(after);
  EXPECT_GT(before, 1.02);
  EXPECT_LT(distortion_of(disc, *after).stretch, 1.0 + 0.1 * (before - 1.0)) << "ten steps leave less than a tenth";
}

TEST(ChartMap, TurnedTrianglesLieConformallyWhereTheTurnsAreHarmonic) {
  constexpr double kTurn = 0.8;  // radians over the square: exp(0.8 i z) has this angle, and scales from 1 to 0.45
  constexpr std::uint32_t kSide = 16;
  const Disc disc = square_disc(kSide);
  const std::vector<glm::dvec2> flat = as_it_lies(disc);
  std::vector<double> turns;
  for (const auto& [a, b, c] : disc.triangles)
    turns.push_back(kTurn / kSide * (flat[a].x + flat[b].x + flat[c].x) / 3.0);
  const auto places = with_triangles_turned(disc, flat, turns);
  ASSERT_TRUE(places);
  const Distortion distortion = distortion_of(disc, *places);
  EXPECT_EQ(distortion.flipped, 0U);
  EXPECT_LT(distortion.angle, 1.06);
  EXPECT_GT(distortion.area, 1.2) << "there is no rigid answer";
  for (std::size_t f = 0; f < turns.size(); ++f) {
    const auto& [a, b, c] = disc.triangles[f];
    const glm::dmat2 from(flat[b] - flat[a], flat[c] - flat[a]);
    const glm::dmat2 to((*places)[b] - (*places)[a], (*places)[c] - (*places)[a]);
    const glm::dvec2 along = to * glm::inverse(from) * glm::dvec2(1.0, 0.0);
    EXPECT_NEAR(std::atan2(along.y, along.x), turns[f], 0.1)
        << "scales need room: eight steps leave an eighth of the whole turn";
  }
}

TEST(ChartMap, FactorsOfAStretchAndAMirrorImageAreKnown) {
  const std::array<glm::dvec3, 3> triangle{glm::dvec3(0, 0, 1), glm::dvec3(2, 0, 1), glm::dvec3(1, 3, 1)};
  const LinearFactors stretched = factors_of(triangle, {glm::dvec2(0, 0), glm::dvec2(6, 0), glm::dvec2(3, 1.5)});
  EXPECT_NEAR(stretched.largest, 3.0, 1e-12);
  EXPECT_NEAR(stretched.least, 0.5, 1e-12);
  const LinearFactors mirrored = factors_of(triangle, {glm::dvec2(0, 0), glm::dvec2(-2, 0), glm::dvec2(-1, 3)});
  EXPECT_NEAR(mirrored.largest, 1.0, 1e-12);
  EXPECT_NEAR(mirrored.least, -1.0, 1e-12);
}

TEST(ChartMap, MendsAFlippedTriangleInPlace) {
  const Disc disc = square_disc(6);
  std::vector<glm::dvec2> places = as_it_lies(disc);
  const std::size_t middle = 24;  // of 7 x 7
  places[middle] += glm::dvec2(1.5, 0.2);
  ASSERT_GT(distortion_of(disc, places).flipped, 0U);
  EXPECT_TRUE(mend(disc, places));
  EXPECT_EQ(distortion_of(disc, places).flipped, 0U);
  for (const std::uint32_t point : disc.border) {
    EXPECT_EQ(places[point], glm::dvec2(disc.points[point])) << "what was good stays";
  }
}

TEST(ChartMap, BordersThatCrossAreFoundAndThoseThatTouchAreNot) {
  EXPECT_TRUE(crossing_sides({{0, 0}, {2, 0}, {2, 1}, {0, 1}}).empty());
  EXPECT_EQ(crossing_sides({{0, 0}, {2, 1}, {2, 0}, {0, 1}}).size(), 2U) << "a bow tie";
  // A ring that was cut open: the two sides of the cut lie on each other.
  EXPECT_TRUE(crossing_sides({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}}).empty());
}

TEST(ChartPacking, KeepsBoxesApartAndTheSquareFull) {
  std::vector<std::vector<glm::dvec2>> borders;
  std::vector<double> areas;
  for (int i = 1; i <= 40; ++i) {
    const double x = 1.0 + i % 7, y = 1.0 + i % 5;
    borders.push_back({{0, 0}, {x, 0}, {x, y}, {0, y}});
    areas.push_back(x * y);
  }
  const ChartPacking packing = pack(borders, areas);
  std::vector<std::array<glm::dvec2, 2>> boxes;
  for (std::size_t i = 0; i < borders.size(); ++i) {
    glm::dvec2 lo(2.0), hi(-1.0);
    for (const glm::dvec2& p : borders[i])
      lo = glm::min(lo, packing.place(i, p)), hi = glm::max(hi, packing.place(i, p));
    EXPECT_TRUE(lo.x > 0.0 && lo.y > 0.0 && hi.x < 1.0 && hi.y < 1.0);
    for (const auto& [other_lo, other_hi] : boxes) {
      EXPECT_TRUE(lo.x > other_hi.x || hi.x < other_lo.x || lo.y > other_hi.y || hi.y < other_lo.y);
    }
    boxes.push_back({lo, hi});
  }
  EXPECT_GT(packing.utilization, 0.75) << "rectangles of like sizes waste little";
}

TEST(ChartPacking, OfNothingIsEmpty) {
  EXPECT_TRUE(pack({}, {}).charts.empty());
}

}  // namespace
}  // namespace luminist
