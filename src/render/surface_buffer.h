#pragma once
// render/surface_buffer.h -- what is visible at the centre of each pixel, on the CPU: brushes, the starting
// configuration and the sampling of a solve read it.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/math.h"

namespace luminist {

/// Arrays of width x height, row 0 on top. Where object is 0 nothing is visible and the other entries are zero.
struct SurfaceBuffer {
  int width = 0;
  int height = 0;
  Vec3 eye{0.0F};                         ///< camera position, world
  std::vector<Vec3> position;             ///< world
  std::vector<Vec3> normal;               ///< unit, shading normal, faces the eye
  std::vector<Vec3> albedo;               ///< diffuse reflectance, linear
  std::vector<Vec3> specular;             ///< reflectance at normal incidence
  std::vector<float> roughness;           ///< GGX alpha = roughness^2
  std::vector<std::uint32_t> object;      ///< 1 + index of the scene's object
  std::vector<std::uint32_t> material;    ///< 1 + index of the scene's material
  std::vector<std::string> object_names;  ///< [object id]; entry 0 is ""

  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

}  // namespace luminist
