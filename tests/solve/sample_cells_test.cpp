#include "solve/sample_cells.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "solve/fake_renderer.h"

namespace luminist {
namespace {

class SampleCellsTest : public testing::Test {
 protected:
  SampleCellsTest() : renderer_(96, 96) {
    const ParamState empty = renderer_.empty_state();
    target_ = renderer_.target_of(empty, empty);
  }
  FakeRenderer renderer_;
  Target target_;
};

TEST_F(SampleCellsTest, AreAsManyAsAskedAndTheirWeightsAreAllOfTheImportance) {
  const SampleCells cells = CellSampler(renderer_.surface(), target_).cut(144, 4, 1);
  EXPECT_EQ(cells.size(), 144);
  EXPECT_EQ(cells.samples.pixels.size(), 144U * 4U);
  EXPECT_NEAR(std::accumulate(cells.weight.begin(), cells.weight.end(), 0.0), 1.0, 1e-9);  // rounding of sums
  const std::set<std::uint32_t> distinct(cells.samples.pixels.begin(), cells.samples.pixels.end());
  EXPECT_EQ(distinct.size(), cells.samples.pixels.size());
}

TEST_F(SampleCellsTest, ASmallPaintedPlaceGetsAFairShareOfThem) {
  for (float& importance : target_.importance.data) importance = 0.1F;
  for (int y = 40; y < 45; ++y) {
    for (int x = 50; x < 55; ++x) {
      const std::size_t pixel = target_.color.index(x, y);
      target_.importance.data[pixel] = 1.0F;
      target_.color.set_rgb(pixel, Vec3(0.9F));
    }
  }
  const SampleCells cells = CellSampler(renderer_.surface(), target_).cut(144, 1, 1);
  int inside = 0;
  for (const std::uint32_t pixel : cells.samples.pixels) {
    const int x = static_cast<int>(pixel % 96);
    const int y = static_cast<int>(pixel / 96);
    inside += x >= 40 && x < 65 && y >= 30 && y < 55 && target_.importance.data[pixel] == 1.0F ? 1 : 0;
  }
  EXPECT_GE(inside, 20);  // of 25 pixels, 0.3 % of the picture: half of the cells are meant for what paint changes
}

TEST_F(SampleCellsTest, AvoidEdgesWhereThereAreOtherPixels) {
  const std::vector<bool> edge = edge_pixels(renderer_.surface());
  const SampleCells cells = CellSampler(renderer_.surface(), target_).cut(100, 4, 1);
  for (const std::uint32_t pixel : cells.samples.pixels) EXPECT_FALSE(edge[pixel]) << pixel;
  EXPECT_GT(std::count(edge.begin(), edge.end(), true), 100);  // the spheres have silhouettes
}

TEST_F(SampleCellsTest, HaveTheMeanOfTheTargetOverTheirOwnPixels) {
  for (std::size_t i = 0; i < target_.color.pixels(); ++i) {
    target_.color.set_rgb(i, Vec3(static_cast<float>(i), 1.0F, 0.0F));
  }
  const SampleCells cells = CellSampler(renderer_.surface(), target_).cut(50, 3, 1);
  std::vector<Vec3> values;
  for (const std::uint32_t pixel : cells.samples.pixels) values.push_back(target_.color.rgb(pixel));
  EXPECT_EQ(cells.average(values), cells.target);
}

TEST_F(SampleCellsTest, AreTheSameForTheSameSeedAndNamedByTheirPixels) {
  const CellSampler sampler(renderer_.surface(), target_);
  const SampleCells one = sampler.cut(64, 2, 5);
  const SampleCells same = sampler.cut(64, 2, 5);
  const SampleCells other = sampler.cut(64, 2, 6);
  EXPECT_EQ(one.samples.pixels, same.samples.pixels);
  EXPECT_EQ(one.samples.id, same.samples.id);
  EXPECT_NE(one.samples.id, other.samples.id);
}

TEST_F(SampleCellsTest, LeaveOutWhatDoesNotCount) {
  for (std::size_t i = 0; i < target_.importance.data.size(); ++i)
    target_.importance.data[i] = i % 2 == 0 ? 0.0F : 1.0F;
  const SampleCells cells = CellSampler(renderer_.surface(), target_).cut(64, 4, 1);
  for (const std::uint32_t pixel : cells.samples.pixels) EXPECT_EQ(pixel % 2, 1U);
  for (float& importance : target_.importance.data) importance = 0.0F;
  EXPECT_TRUE(CellSampler(renderer_.surface(), target_).nothing_counts());
  EXPECT_EQ(CellSampler(renderer_.surface(), target_).cut(64, 4, 1).size(), 0);
}

/// Paint on a part of the picture, as a stroke leaves it.
PixelBox paint(Target& target, const PixelBox& box) {
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const std::size_t pixel = target.color.index(x, y);
      target.importance.data[pixel] = 1.0F;
      target.color.set_rgb(pixel, target.before.rgb(pixel) + Vec3(0.3F));
    }
  }
  return box;
}

TEST_F(SampleCellsTest, AfterAnUpdateAreThoseOfASamplerMadeAnew) {
  for (float& importance : target_.importance.data) importance = 0.1F;
  CellSampler sampler(renderer_.surface(), target_);
  for (const PixelBox& box : {PixelBox{10, 20, 40, 35}, PixelBox{0, 60, 96, 96}, PixelBox{50, 0, 60, 96}}) {
    sampler.update(paint(target_, box));
    const SampleCells updated = sampler.cut(144, 2, 3);
    const SampleCells fresh = CellSampler(renderer_.surface(), target_).cut(144, 2, 3);
    EXPECT_EQ(updated.samples.pixels, fresh.samples.pixels);
    EXPECT_EQ(updated.target, fresh.target);
    EXPECT_EQ(updated.weight, fresh.weight);
  }
}

TEST_F(SampleCellsTest, RefreshedTheyKeepTheirSamplesAndKnowTheNewTarget) {
  for (float& importance : target_.importance.data) importance = 0.1F;
  CellSampler sampler(renderer_.surface(), target_);
  SampleCells cells = sampler.cut(144, 2, 3);
  EXPECT_NEAR(sampler.refresh(cells), 0.0, 1e-9);  // rounding of sums
  const std::vector<std::uint32_t> pixels = cells.samples.pixels;
  sampler.update(paint(target_, {30, 30, 34, 34}));
  const double little = sampler.refresh(cells);
  sampler.update(paint(target_, {30, 30, 80, 60}));
  const double much = sampler.refresh(cells);
  EXPECT_EQ(cells.samples.pixels, pixels);
  std::vector<Vec3> values;
  for (const std::uint32_t pixel : pixels) values.push_back(target_.color.rgb(pixel));
  EXPECT_EQ(cells.average(values), cells.target);
  EXPECT_NEAR(std::accumulate(cells.weight.begin(), cells.weight.end(), 0.0), 1.0, 1e-9);
  EXPECT_GT(little, 0.0);
  EXPECT_GT(much, 0.15);  // half of the mass is what paint changes, and that lies in a sixth of the picture
  EXPECT_LE(much, 1.0);
}

}  // namespace
}  // namespace luminist
