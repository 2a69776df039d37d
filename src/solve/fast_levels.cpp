#include "solve/fast_levels.h"

namespace luminist {

namespace {

/// How a level is cut.
struct Cut {
  int cells = 0;
  int per_cell = 1;
};

constexpr std::array<Cut, kFastLevels> kCuts{{{160, 1}, {144, 4}, {256, 4}, {320, 1}, {2304, 1}, {8192, 1}}};
// Noise makes every distance larger, and that of a picture with more noise by more: a cell's mean has less of it.
constexpr std::array<Cut, kFastLevels> kCutsOfEstimates{{{48, 8}, {64, 8}, {96, 8}, {48, 8}, {288, 8}, {600, 8}}};

}  // namespace

FastLevels fast_levels(const CellSampler& sampler, std::uint64_t seed, bool estimates) {
  const auto cut = [&](FastLevel level, std::uint64_t offset) {
    const Cut& wanted = (estimates ? kCutsOfEstimates : kCuts)[level];
    return sampler.cut(wanted.cells, wanted.per_cell, seed + offset);
  };
  FastLevels levels;
  levels[kScout] = {cut(kScout, 0), {0.08F, 0.10F, 0.3F, 1}, 0.015, 0.006, 12};
  levels[kSoft] = {cut(kSoft, 1), {0.08F, 0.10F, 0.3F, 2}, 0.015, 0.006, 12};
  levels[kMiddle] = {cut(kMiddle, 2), {0.03F, 0.04F, 0.1F, 2}, 0.008, 0.005, 10};
  levels[kNear] = {cut(kNear, 4), {0.0F, 0.0F, 0.0F, estimates ? 2 : 4}, 0.004, 0.003, 12};
  levels[kSharp] = {cut(kSharp, 3), {0.0F, 0.0F, 0.0F, 8}, 0.004, 0.003, 12};
  levels[kExact] = {cut(kExact, 5), {0.0F, 0.0F, 0.0F, 4}, 0.004, 0.003, 12};
  return levels;
}

std::vector<std::uint32_t> all_pixels(const FastLevels& levels) {
  std::vector<std::uint32_t> pixels;
  for (const Level& level : levels) {
    pixels.insert(pixels.end(), level.cells.samples.pixels.begin(), level.cells.samples.pixels.end());
  }
  return pixels;
}

FastFields averages(const FastLevels& levels, std::span<const Vec3> colors) {
  FastFields fields;
  std::size_t first = 0;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const SampleCells& cells = levels[level].cells;
    fields[level] = cells.average(colors.subspan(first, cells.samples.pixels.size()));
    first += cells.samples.pixels.size();
  }
  return fields;
}

}  // namespace luminist
