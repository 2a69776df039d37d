#include "solve/fast_levels.h"

namespace luminist {

FastLevels fast_levels(const CellSampler& sampler, std::uint64_t seed) {
  FastLevels levels;
  levels[kScout] = {sampler.cut(160, 1, seed), {0.08F, 0.10F, 0.3F, 1}, 0.015, 0.006, 12};
  levels[kSoft] = {sampler.cut(144, 4, seed + 1), {0.08F, 0.10F, 0.3F, 2}, 0.015, 0.006, 12};
  levels[kMiddle] = {sampler.cut(256, 4, seed + 2), {0.03F, 0.04F, 0.1F, 2}, 0.008, 0.005, 10};
  levels[kNear] = {sampler.cut(320, 1, seed + 4), {0.0F, 0.0F, 0.0F, 4}, 0.004, 0.003, 12};
  levels[kSharp] = {sampler.cut(2304, 1, seed + 3), {0.0F, 0.0F, 0.0F, 8}, 0.004, 0.003, 12};
  levels[kExact] = {sampler.cut(8192, 1, seed + 5), {0.0F, 0.0F, 0.0F, 4}, 0.004, 0.003, 12};
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
