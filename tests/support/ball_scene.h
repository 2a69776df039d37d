#pragma once
// tests/support/ball_scene.h -- a ball on a floor, as an OBJ file with materials.
#include <cmath>
#include <sstream>
#include <string>

namespace luminist {

inline std::string ball_material() {
  return "newmtl clay\nKd 0.7 0.6 0.5\nnewmtl board\nKd 0.5 0.5 0.5\n";
}

/// A ball of radius 1 around (0, 1, 0), 24 x 12 facets, on a floor of 6 x 6; objects "ball" and "floor".
inline std::string ball_obj() {
  constexpr int kAround = 24;
  constexpr int kDown = 12;
  constexpr double kHalfTurn = 3.14159265358979323846;
  std::ostringstream obj;
  obj << "mtllib ball.mtl\no ball\nusemtl clay\n";
  for (int i = 0; i <= kDown; ++i) {
    for (int j = 0; j < kAround; ++j) {
      const double down = kHalfTurn * i / kDown;
      const double around = 2.0 * kHalfTurn * j / kAround;
      obj << "v " << std::sin(down) * std::cos(around) << ' ' << 1.0 + std::cos(down) << ' '
          << std::sin(down) * std::sin(around) << '\n';
    }
  }
  for (int i = 0; i < kDown; ++i) {
    for (int j = 0; j < kAround; ++j) {
      const int a = i * kAround + j + 1;
      const int b = i * kAround + (j + 1) % kAround + 1;
      obj << "f " << a << ' ' << b << ' ' << b + kAround << ' ' << a + kAround << '\n';
    }
  }
  obj << "o floor\nusemtl board\nv -3 0 -3\nv -3 0 3\nv 3 0 3\nv 3 0 -3\nf -4 -3 -2 -1\n";
  return obj.str();
}

}  // namespace luminist
