#pragma once
// solve/random.h -- random numbers that are the same on every machine and compiler.
#include <cmath>
#include <cstdint>

#include "base/math.h"

namespace luminist {

/// SplitMix64 (Steele, Lea and Flood 2014): 64 bits of state, any seed is good.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
  }
  /// In [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// In [0, count); count > 0.
  int index(int count) { return static_cast<int>(uniform() * count); }
  /// Mean 0, deviation 1 (Box and Muller).
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * kPi * uniform());
  }
  /// Uniform on the unit sphere.
  Vec3 direction() {
    const double z = uniform(-1.0, 1.0);
    const double angle = uniform(0.0, 2.0 * kPi);
    const double ring = std::sqrt(std::max(0.0, 1.0 - z * z));
    return {static_cast<float>(ring * std::cos(angle)), static_cast<float>(ring * std::sin(angle)),
            static_cast<float>(z)};
  }

 private:
  std::uint64_t state_;
};

}  // namespace luminist
