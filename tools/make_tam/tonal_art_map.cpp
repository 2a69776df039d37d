#include "make_tam/tonal_art_map.h"

#include <algorithm>
#include <cmath>

#include "make_tam/hash.h"
#include "make_tam/tile_level.h"

namespace luminist {
namespace {

constexpr int kTones = 64;
constexpr double kDarkest = 0.93;  // what is left between strokes then closes by itself

/// Draws strokes at random; every number has a place in one sequence.
class StrokePen {
 public:
  StrokePen(const StrokeKind& kind, std::uint64_t seed) : kind_(&kind), seed_(seed) {}

  /// The best of some candidates for a level that has `tone` of ink.
  Stroke best(const std::vector<TileLevel>& levels, int level, double tone) {
    const TileLevel& here = levels[static_cast<std::size_t>(level)];
    const bool crosses = tone > kind_->crossing_from && next() < 0.8;
    Stroke best;
    double least = 0.0;
    for (int i = 0; i < kind_->candidates; ++i) {
      Stroke stroke = candidate(here.size(), crosses);
      stroke.level = level;
      // Of equally empty places the longer stroke is the better one.
      const double crowding = here.crowding(stroke) - 0.02 * stroke.length;
      if (i > 0 && crowding >= least) continue;
      least = crowding;
      best = stroke;
    }
    return best;
  }

 private:
  double next() { return unit_hash(seed_, count_++); }
  double bell() { return next() + next() + next() - 1.5; }  // deviation 0.5

  Stroke candidate(int size, bool crosses) {
    Stroke stroke;
    stroke.x = next();
    stroke.y = next();
    const double texels = kind_->shortest + (kind_->longest - kind_->shortest) * next();
    stroke.length = std::min(texels / size, kind_->longest_share * (0.6 + 0.4 * next()));
    stroke.crosses = crosses;
    stroke.angle = (crosses ? kind_->crossing_angle : 0.0) + 2.0 * kind_->turn * bell();
    stroke.seed = count_;
    return stroke;
  }

  const StrokeKind* kind_;
  std::uint64_t seed_;
  std::uint64_t count_ = 0;
};

float texel(const Image& level, int x, int y) {
  const int mask = level.width - 1;
  return level.at(x & mask, y & mask, 0);
}

float bilinear(const Image& level, double u, double v) {
  const double x = u * level.width - 0.5;
  const double y = v * level.height - 0.5;
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const auto a = static_cast<float>(x - i);
  const auto b = static_cast<float>(y - j);
  return std::lerp(std::lerp(texel(level, i, j), texel(level, i + 1, j), a),
                   std::lerp(texel(level, i, j + 1), texel(level, i + 1, j + 1), a), b);
}

}  // namespace

TonalArtMap make_tonal_art_map(const StrokeKind& kind, std::uint64_t seed) {
  std::vector<TileLevel> levels;
  for (int level = 0; level < TonalArtMap::kLevels; ++level) levels.emplace_back(kind, TonalArtMap::kSize >> level);
  TonalArtMap map;
  StrokePen pen(kind, seed);
  for (int step = 1; step <= kTones; ++step) {
    const double tone = kDarkest * step / kTones;
    for (int level = TonalArtMap::kLevels - 1; level >= 0; --level) {
      TileLevel& here = levels[static_cast<std::size_t>(level)];
      while (here.ink() < tone) {
        const Stroke stroke = pen.best(levels, level, here.ink());
        for (int finer = level; finer >= 0; --finer) levels[static_cast<std::size_t>(finer)].draw(stroke);
        map.strokes.push_back(stroke);
      }
    }
  }
  for (const TileLevel& level : levels) map.levels.push_back(level.thresholds());
  return map;
}

Image TonalArtMap::strip() const {
  int rows = 0;
  for (const Image& level : levels) rows += level.height;
  Image strip(kSize, rows, 1, 1.0F);
  int row = 0;
  for (const Image& level : levels) {
    for (int y = 0; y < level.height; ++y) {
      for (int x = 0; x < level.width; ++x) strip.at(x, row + y, 0) = std::max(level.at(x, y, 0), 1.0F / 255.0F);
    }
    row += level.height;
  }
  return strip;
}

float TonalArtMap::threshold(double u, double v, double lod) const {
  const int finer = std::clamp(static_cast<int>(lod), 0, kLevels - 1);
  const int coarser = std::min(finer + 1, kLevels - 1);
  const float share = std::clamp(static_cast<float>(lod - finer), 0.0F, 1.0F);
  return std::lerp(bilinear(levels[static_cast<std::size_t>(finer)], u, v),
                   bilinear(levels[static_cast<std::size_t>(coarser)], u, v), share);
}

Image tone_table(const TonalArtMap& map) {
  constexpr int kRows = 8 * (TonalArtMap::kLevels - 1) + 1;
  constexpr int kColumns = 256;
  constexpr int kSide = 700;  // no multiple of the tile's texels, so that all places between them count
  Image table(kColumns, kRows, 1);
  std::vector<float> thresholds(static_cast<std::size_t>(kSide) * kSide);
  for (int row = 0; row < kRows; ++row) {
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        thresholds[static_cast<std::size_t>(j * kSide + i)] =
            map.threshold((i + 0.5) / kSide, (j + 0.5) / kSide, row / 8.0);
      }
    }
    std::ranges::sort(thresholds);
    for (int x = 0; x < kColumns; ++x) {
      const double place = x / 255.0 * static_cast<double>(thresholds.size() - 1);
      table.at(x, row, 0) = x == 0 ? 0.0F : thresholds[static_cast<std::size_t>(place)];
    }
  }
  return table;
}

float inked_to(const Image& table, double darkness, double lod) {
  const double x = std::clamp(darkness * 255.0, 0.0, 255.0);
  const double y = std::clamp(lod * 8.0, 0.0, table.height - 1.0);
  const int i = std::min(static_cast<int>(x), table.width - 2);
  const int j = std::min(static_cast<int>(y), table.height - 2);
  const auto a = static_cast<float>(x - i);
  const auto b = static_cast<float>(y - j);
  return std::lerp(std::lerp(table.at(i, j, 0), table.at(i + 1, j, 0), a),
                   std::lerp(table.at(i, j + 1, 0), table.at(i + 1, j + 1, 0), a), b);
}

Image contact_sheet(const TonalArtMap& map, const Image& table) {
  constexpr int kCell = 200;
  constexpr int kTonesShown = 8;
  constexpr int kSub = 2;  // samples across a pixel
  const std::vector<double> lods{0.0, 0.5, 1.0, 2.0};
  Image sheet(kCell * kTonesShown, kCell * static_cast<int>(lods.size()), 1);
  for (int y = 0; y < sheet.height; ++y) {
    const double lod = lods[static_cast<std::size_t>(y / kCell)];
    const double texels = TonalArtMap::kSize / std::exp2(lod);
    for (int x = 0; x < sheet.width; ++x) {
      const double darkness = static_cast<double>(x + 0.5) / sheet.width;
      const float limit = inked_to(table, darkness, lod);
      float ink = 0.0F;
      for (int s = 0; s < kSub * kSub; ++s) {
        const double u = (x + (s % kSub + 0.5) / kSub) / texels;
        const double v = (y + (s / kSub + 0.5) / kSub) / texels;
        const bool inked = map.threshold(u - std::floor(u), v - std::floor(v), lod) <= limit;
        ink += inked ? 1.0F / (kSub * kSub) : 0.0F;
      }
      sheet.at(x, y, 0) = 1.0F - ink;
    }
  }
  return sheet;
}

}  // namespace luminist
