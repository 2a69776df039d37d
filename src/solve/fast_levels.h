#pragma once
// solve/fast_levels.h -- the levels of the fast solver, and the stages in which descents pass through them.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solve/cell_problem.h"

namespace luminist {

/// kScout, kSoft and kMiddle have few cells, and shadows and light edges wider than they are: they lead from far away.
/// Near the target they mislead, because wide shadows are not those of the target; the others have true edges. kNear
/// has few cells, kSharp many, and kExact so many that what differs from the picture is no chance of the sample.
enum FastLevel : std::size_t { kScout, kSoft, kMiddle, kNear, kSharp, kExact, kFastLevels };

using FastLevels = std::array<Level, kFastLevels>;

/// Under a blurred metric samples are as few: what it blurs gives way to its mean where samples are shaded, and the
/// target's are blurred. estimates: samples have noise; then there are fewer cells, of more samples. cost O(pixels).
FastLevels fast_levels(const CellSampler& sampler, std::uint64_t seed, bool estimates = false);

/// A field on the cells of every level.
using FastFields = std::array<CellField, kFastLevels>;

/// The samples' pixels of all levels, one level after another.
std::vector<std::uint32_t> all_pixels(const FastLevels& levels);
/// Means over the cells of every level. colors [all_pixels()].
FastFields averages(const FastLevels& levels, std::span<const Vec3> colors);

/// A part of a descent: on which level, for how many batches of slopes at most, how many of its ends go on, and whether
/// the light that was varied turns alone (and all colours).
struct FastStage {
  FastLevel level = kScout;
  int iterations = 0;
  std::size_t keep = 1;
  bool alone = false;
};

/// Many starts descend a little on few samples, the best of them on, and only one to the end.
inline constexpr std::array<FastStage, 5> kFarSearch{
    {{kScout, 3, 8, true}, {kSoft, 4, 2, true}, {kMiddle, 5, 1}, {kNear, 5, 1}, {kSharp, 6, 1}}};
/// Where few parameters turn, true edges on few samples would stop a descent in the ripples of thin shadows.
inline constexpr std::array<FastStage, 4> kFarSearchOfFew{
    {{kScout, 3, 8, true}, {kSoft, 4, 2, true}, {kMiddle, 5, 1}, {kSharp, 6, 1}}};
inline constexpr std::array<FastStage, 3> kNearSearch{{{kNear, 3, 4, true}, {kNear, 5, 1}, {kSharp, 6, 1}}};
inline constexpr std::span<const FastStage> kFromSharp = std::span(kNearSearch).subspan(2);

/// From where the solve begins.
inline constexpr std::array<FastStage, 4> kFirst{{{kSoft, 6, 2}, {kMiddle, 5, 2}, {kNear, 5, 1}, {kSharp, 6, 1}}};
inline constexpr std::array<FastStage, 3> kFirstOfFew{{{kSoft, 6, 2}, {kMiddle, 5, 2}, {kSharp, 6, 1}}};

/// From a state whose picture is known and at which the samples are exact.
inline constexpr std::array<FastStage, 1> kPolish{{{kExact, 8, 1}}};

}  // namespace luminist
