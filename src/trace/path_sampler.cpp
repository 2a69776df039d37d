#include "trace/path_sampler.h"

namespace luminist {
namespace {

std::uint32_t reversed(std::uint32_t x) {
  x = ((x >> 1) & 0x55555555U) | ((x & 0x55555555U) << 1);
  x = ((x >> 2) & 0x33333333U) | ((x & 0x33333333U) << 2);
  x = ((x >> 4) & 0x0F0F0F0FU) | ((x & 0x0F0F0F0FU) << 4);
  x = ((x >> 8) & 0x00FF00FFU) | ((x & 0x00FF00FFU) << 8);
  return (x >> 16) | (x << 16);
}

/// A permutation in which a bit depends on itself and on lower bits alone: products and sums carry upwards only. On
/// reversed numbers that is Owen's scrambling; the seed enters before, between and after, so that all bits depend on
/// it.
std::uint32_t carried_up(std::uint32_t x, std::uint32_t seed) {
  x += seed;
  x ^= x * ((seed << 1) & 0xFFFFFFFEU);
  x *= seed | 1U;
  x ^= x * 0x9E3779B6U;
  x += mixed(seed, 0x2545F491U);
  x ^= x * 0x85EBCA6AU;
  x *= 0xC2B2AE35U;
  x ^= x * (mixed(seed, 0x7F4A7C15U) & 0xFFFFFFFEU);
  return x;
}

/// The second dimension of Sobol's sequence, lowest bit first: bit j of the result is the sum modulo 2 of the bits i
/// for which "i over j" is odd, which are those whose place has all bits of j (Lucas).
std::uint32_t pascal(std::uint32_t index) {
  index ^= (index >> 1) & 0x55555555U;
  index ^= (index >> 2) & 0x33333333U;
  index ^= (index >> 4) & 0x0F0F0F0FU;
  index ^= (index >> 8) & 0x00FF00FFU;
  return index ^ ((index >> 16) & 0x0000FFFFU);
}

float fraction(std::uint32_t fixed) {
  return static_cast<float>(fixed >> 8) * 0x1p-24F;
}

}  // namespace

std::uint32_t mixed(std::uint32_t a, std::uint32_t b) {
  std::uint64_t x = (static_cast<std::uint64_t>(a) << 32) | b;
  x = (x ^ (x >> 31)) * 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 29)) * 0xD1B54A32D192ED03U;
  return static_cast<std::uint32_t>((x ^ (x >> 32)) >> 7);
}

std::uint32_t owen_scrambled(std::uint32_t x, std::uint32_t seed) {
  return reversed(carried_up(reversed(x), seed));
}

Vec2 PathSampler::pair(std::uint32_t dimension) const {
  const std::uint32_t seed = mixed(pixel_seed_, dimension);
  // Scrambled, the first 2^k indices are some other aligned run of 2^k: a shuffling that keeps strata.
  const std::uint32_t index = owen_scrambled(index_, mixed(seed, 1));
  // Both coordinates are the index with its bits reversed; reversing them before scrambling would undo that.
  return {fraction(reversed(carried_up(index, mixed(seed, 2)))),
          fraction(reversed(carried_up(pascal(index), mixed(seed, 3))))};
}

}  // namespace luminist
