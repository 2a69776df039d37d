#pragma once
// make_scene/noise.h -- repeatable randomness for shapes and textures: no tables, no state but the seed.
#include <cstdint>

#include "make_scene/surface.h"

namespace luminist {

/// Gradient noise, about [-1, 1], zero at lattice points. With period > 0 the lattice wraps after so many cells in
/// every axis, so that textures tile. cost eight hashes.
double noise(const Point3& p, int period = 0);

/// Sum of octaves of noise(), each of twice the frequency and half the weight of the one before; about [-1, 1].
double fbm(const Point3& p, int octaves, int period = 0);

/// Nearest of the feature points that are scattered one per lattice cell.
struct CellSample {
  double nearest = 0.0;  ///< distance to the nearest point
  double second = 0.0;   ///< distance to the second nearest
  std::uint32_t id = 0;  ///< a random number that belongs to the nearest point
};
CellSample cells(const Point3& p, int period = 0);

/// A uniform number in [0, 1) that belongs to three integers.
double hash01(int x, int y, int z = 0);

/// A sequence of random numbers (splitmix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double next();  ///< uniform in [0, 1)
  double range(double lo, double hi) { return lo + (hi - lo) * next(); }

 private:
  std::uint64_t state_;
};

double smoothstep(double lo, double hi, double x);
double mix(double a, double b, double t);  ///< a + (b - a) t

}  // namespace luminist
