#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/files.h"
#include "image_io/image_io.h"
#include "make_tam/tonal_art_map.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

class TonalArtMapTest : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    LUM_ASSERT_OK(kind_, stroke_kind(GetParam()));
    static std::map<std::string, std::pair<TonalArtMap, Image>> made;  // drawing takes seconds
    auto& [map, table] = made[kind_.name];
    if (map.levels.empty()) {
      map = make_tonal_art_map(kind_, 1);
      table = tone_table(map);
    }
    map_ = map;
    table_ = table;
  }
  /// Share of a grid of places that is inked.
  [[nodiscard]] double ink(double darkness, double lod) const {
    constexpr int kSide = 331;
    const float limit = inked_to(table_, darkness, lod);
    int inked = 0;
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        inked += map_.threshold((i + 0.3) / kSide, (j + 0.6) / kSide, lod) <= limit ? 1 : 0;
      }
    }
    return inked / static_cast<double>(kSide * kSide);
  }

  StrokeKind kind_;
  TonalArtMap map_;
  Image table_;
};

TEST_P(TonalArtMapTest, ThresholdsOfEveryLevelAreEvenlyDistributed) {
  ASSERT_EQ(map_.levels.size(), 5U);
  for (const Image& level : map_.levels) {
    for (int tone = 0; tone <= 10; ++tone) {
      const double darkness = tone / 10.0;
      const auto inked = std::ranges::count_if(level.data, [&](float t) { return t <= darkness; });
      EXPECT_NEAR(static_cast<double>(inked) / static_cast<double>(level.pixels()), darkness,
                  1.0 / static_cast<double>(level.pixels()) + 1e-6)
          << "ranks are distributed evenly, up to one texel";
    }
  }
}

TEST_P(TonalArtMapTest, MeanInkIsTheToneAtEveryLevelOfDetail) {
  for (const double lod : {0.0, 0.37, 1.0, 1.5, 2.81, 4.0}) {
    for (int tone = 0; tone <= 20; ++tone) {
      EXPECT_NEAR(ink(tone / 20.0, lod), tone / 20.0, 0.02) << "lod " << lod << ", what an artist is promised";
    }
  }
}

TEST_P(TonalArtMapTest, FinerLevelsKeepTheStrokesOfCoarserOnes) {
  // What the strokes of a coarse level ink first is inked on the finer ones before much else: at their middles.
  for (const Stroke& stroke : map_.strokes) {
    if (stroke.level < 2) continue;
    const auto order = static_cast<std::size_t>(&stroke - map_.strokes.data());
    if (order > map_.strokes.size() / 8) break;  // the lightest tones, where strokes are apart
    for (int finer = 0; finer < stroke.level; ++finer) {
      const Image& level = map_.levels[static_cast<std::size_t>(finer)];
      float least = 1.0F;  // wobble moves a stroke by a texel or two
      const int reach = static_cast<int>(std::ceil(kind_.wobble)) + 1;
      for (int dy = -reach; dy <= reach; ++dy) {
        const int x = static_cast<int>(stroke.x * level.width) & (level.width - 1);
        const int y = (static_cast<int>(stroke.y * level.height) + dy) & (level.height - 1);
        least = std::min(least, level.at(x, y, 0));
      }
      EXPECT_LT(least, 0.45F) << "stroke " << order << " of level " << stroke.level << " on level " << finer;
    }
  }
}

TEST_P(TonalArtMapTest, TheTileRepeatsWithoutASeam) {
  const auto jump = [](const Image& level, int a, int b, bool columns) {
    double sum = 0.0;
    for (int i = 0; i < level.width; ++i) {
      sum +=
          columns ? std::abs(level.at(a, i, 0) - level.at(b, i, 0)) : std::abs(level.at(i, a, 0) - level.at(i, b, 0));
    }
    return sum / level.width;
  };
  const Image& level = map_.levels.front();
  for (const bool columns : {false, true}) {
    double inside = 0.0;
    for (int i = 0; i + 1 < level.width; ++i) inside += jump(level, i, i + 1, columns) / (level.width - 1);
    // One border is a sample of many; twice the mean would be seen.
    EXPECT_LT(jump(level, level.width - 1, 0, columns), 1.6 * inside);
  }
}

TEST_P(TonalArtMapTest, ShippedFilesAreWhatTheToolMakes) {
  LUM_ASSERT_OK(const auto path, AssetRoots::standard().find("styles/hatching/textures"));
  const Image strip = map_.strip();
  for (const auto& [name, image] : {std::pair<std::string, const Image*>(kind_.name, &strip),
                                    std::pair<std::string, const Image*>(kind_.name + "_tone", &table_)}) {
    LUM_ASSERT_OK(const Image shipped, read_image((path / (name + ".png")).string(), Encoding::kLinear));
    ASSERT_TRUE(shipped.same_size(*image));
    double worst = 0.0;
    for (std::size_t i = 0; i < image->pixels(); ++i) {
      worst = std::max<double>(worst,
                               std::abs(image->data[i] - shipped.data[i * static_cast<std::size_t>(shipped.channels)]));
    }
    EXPECT_LE(worst, 0.6 / 255.0) << "rounded to 8 bits: make_tam " << kind_.name << " -o styles/hatching/textures";
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, TonalArtMapTest, testing::Values("pencil", "ink", "stipple"),
                         [](const auto& each) { return std::string(each.param); });

TEST(StrokeKinds, AreNamedWhereOneIsMissed) {
  const Error error = error_of(stroke_kind("pensil"));
  EXPECT_EQ(error.kind, ErrorKind::kUsage);
  EXPECT_NE(error.hint.find("pencil"), std::string::npos);
}

}  // namespace
}  // namespace luminist
