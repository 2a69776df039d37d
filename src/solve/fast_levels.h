#pragma once
// solve/fast_levels.h -- the levels of the fast solver, and the stages in which descents pass through them.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solve/cell_problem.h"

namespace luminist {

/// kScout, kSoft and kMiddle have few cells, and shadows and light edges wider than they are; kFine, kSharp and kExact
/// share the many cells. kSharp and kExact show the true edges; the more rays, the less noise in shadows.
enum FastLevel : std::size_t { kScout, kSoft, kMiddle, kFine, kSharp, kExact, kFastLevels };

using FastLevels = std::array<Level, kFastLevels>;

/// blur: of the style's metric; a blurred metric sees means, so cells get more samples. cost O(pixels).
FastLevels fast_levels(const CellSampler& sampler, float blur, std::uint64_t seed);

/// A field on the cells of every level.
using FastFields = std::array<CellField, kFastLevels>;

/// The samples' pixels of all levels, one level after another.
std::vector<std::uint32_t> all_pixels(const FastLevels& levels);
/// Means over the cells of every level. colors [all_pixels()].
FastFields averages(const FastLevels& levels, std::span<const Vec3> colors);

/// A part of a descent: on which level, for how many iterations at most, and how many of its ends go on.
struct FastStage {
  FastLevel level = kScout;
  int iterations = 0;
  std::size_t keep = 1;
};

/// Many starts descend a little on few samples, the best of them on, and only one to the end.
inline constexpr std::array<FastStage, 4> kSearch{{{kScout, 5, 4}, {kSoft, 12, 2}, {kMiddle, 10, 1}, {kSharp, 12, 1}}};
inline constexpr std::span<const FastStage> kFromMiddle = std::span(kSearch).subspan(2);
inline constexpr std::span<const FastStage> kFromSharp = std::span(kSearch).subspan(3);

/// From where the solve begins.
inline constexpr std::array<FastStage, 3> kFirst{{{kSoft, 12, 2}, {kMiddle, 10, 2}, {kSharp, 12, 1}}};

/// From a state whose picture is known. The samples are exact there, so shadows may be wide and still end where they
/// should.
inline constexpr std::array<FastStage, 3> kPolish{{{kSoft, 12, 1}, {kFine, 12, 1}, {kExact, 12, 1}}};

}  // namespace luminist
