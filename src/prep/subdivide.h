#pragma once
// prep/subdivide.h -- smooth surfaces from coarse cages.
#include <array>
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "scene/mesh.h"

namespace luminist {

/// A coarse control mesh of triangles and quads. A triangle repeats its last corner. Front faces wind
/// counter-clockwise.
struct Cage {
  std::vector<Vec3> positions;
  std::vector<std::array<std::uint32_t, 4>> faces;
};

/// The cage after `levels` steps of Catmull and Clark, as triangles with smooth normals and no texture coordinates.
/// Borders stay sharp curves. errors kBadContent for a corner that does not exist or a face that would make an edge of
/// three faces, by its number; kLimit above 20 M triangles. cost O(faces 4^levels).
/// source Catmull and Clark 1978 (OpenMesh).
Result<Mesh> subdivide(const Cage& cage, int levels);

/// A triangle mesh after `levels` steps of Loop's scheme, vertices at one place joined first; texture coordinates are
/// dropped. errors as subdivide(). source Loop 1987 (OpenMesh).
Result<Mesh> subdivide_loop(const Mesh& mesh, int levels);

}  // namespace luminist
