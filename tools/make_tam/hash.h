#pragma once
// make_tam/hash.h -- numbers that look random and belong to a place, the same on every machine.
#include <cstdint>

namespace luminist {

/// In [0, 1). source: the finalizer of SplitMix64 (Steele, Lea and Flood 2014).
inline double unit_hash(std::uint64_t a, std::uint64_t b) {
  std::uint64_t z = a * 0x9E3779B97F4A7C15ULL + (b + 1) * 0xD1B54A32D192ED03ULL;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  z ^= z >> 31U;
  return static_cast<double>(z >> 11U) * 0x1.0p-53;
}

}  // namespace luminist
