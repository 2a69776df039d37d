#include "scene/gltf_triangles.h"

#include <tiny_gltf.h>

namespace luminist {

std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<std::uint32_t>& corners, int mode) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const std::size_t step = mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
  for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
      triangles.push_back({corners[0], corners[i + 1], corners[i + 2]});
    } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1) {
      triangles.push_back({corners[i + 1], corners[i], corners[i + 2]});
    } else {
      triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    }
  }
  return triangles;
}

void append(const Mesh& mesh, Mesh& to) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  const bool normals = to.normals.size() == to.positions.size() && mesh.normals.size() == mesh.positions.size();
  to.positions.insert(to.positions.end(), mesh.positions.begin(), mesh.positions.end());
  to.normals.insert(to.normals.end(), mesh.normals.begin(), mesh.normals.end());
  if (!normals) to.normals.clear();
  // An index that points to nothing must not point into the other mesh now.
  constexpr std::uint32_t kNothing = 0xffffffffU;
  for (const auto& t : mesh.triangles) {
    std::array<std::uint32_t, 3> moved;
    for (std::size_t k = 0; k < 3; ++k) moved[k] = t[k] < mesh.positions.size() ? first + t[k] : kNothing;
    to.triangles.push_back(moved);
  }
}

}  // namespace luminist
