#pragma once
// trace/path_sampler.h -- the numbers in [0,1) that choose a path: even over the samples of a pixel, without pattern
// over pixels, the same every time.
#include <cstdint>

#include "base/math.h"

namespace luminist {

/// A well mixed number: equal only for equal arguments, as far as 32 bits allow.
std::uint32_t mixed(std::uint32_t a, std::uint32_t b);

/// Reorders [0, 2^32) so that intervals of a length 2^-k stay intervals of that length (Owen 1995): points that were
/// stratified are so still, and each of them is uniform over the seeds.
std::uint32_t owen_scrambled(std::uint32_t x, std::uint32_t seed);

/// Sample `index` of a pixel. Two numbers for each of any number of dimensions: a (0,2)-sequence in base 2 (the first
/// two dimensions of Sobol 1967), scrambled and shuffled anew for every pixel and dimension, so that any 2^k first
/// samples are stratified in each pair and pairs do not know of each other.
class PathSampler {
 public:
  PathSampler(std::uint32_t seed, std::uint32_t pixel, std::uint32_t index)
      : pixel_seed_(mixed(seed, pixel)), index_(index) {}

  [[nodiscard]] Vec2 pair(std::uint32_t dimension) const;

 private:
  std::uint32_t pixel_seed_;
  std::uint32_t index_;
};

}  // namespace luminist
