#pragma once
// surface/repair.h -- the surface of a mesh as it comes, made a manifold: what unwrapping, outlines and half edges
// need.
#include <array>
#include <cstdint>
#include <vector>

#include "scene/mesh.h"

namespace luminist {

/// The surface of a mesh, without its seams. Every side of a triangle has at most one neighbour, with the opposite
/// direction, and the triangles around a position are one fan.
struct WeldedMesh {
  std::vector<Vec3> positions;                          ///< one for each place; more where surfaces only touch
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of positions
  std::vector<std::array<std::uint32_t, 3>> corners;    ///< [triangles] the same of the mesh's vertices
};

/// What was done, in counts.
struct RepairReport {
  std::size_t welded = 0;           ///< vertices that were at the place of another: seams are no fault
  std::size_t degenerate = 0;       ///< triangles without area, dropped
  std::size_t duplicate = 0;        ///< triangles on the corners of another, dropped
  std::size_t flipped = 0;          ///< triangles turned to face as most of their component does
  std::size_t split_edges = 0;      ///< sides of more than two triangles, which now end there
  std::size_t torn_edges = 0;       ///< sides where a surface with one side only was cut
  std::size_t split_positions = 0;  ///< positions added where surfaces touched in a point or along an edge
  std::size_t components = 0;       ///< connected pieces, afterwards
  std::size_t open_edges = 0;       ///< sides without a neighbour, afterwards

  /// Nothing had to be done besides welding.
  [[nodiscard]] bool was_good() const {
    return degenerate + duplicate + flipped + split_edges + torn_edges + split_positions == 0;
  }
};

struct Repaired {
  WeldedMesh surface;
  RepairReport report;
};

/// Welds places (within a millionth of the mesh's size), drops triangles that are degenerate or there twice, turns
/// triangles as most of their component are turned, and closed components outwards unless they lie within another, and
/// splits sides of three triangles and positions of several fans. cost O(n log n), about 2 us a triangle.
Repaired repair(const Mesh& mesh);

/// The mesh with the triangles of its repaired surface, and without vertices that none of them uses. A good mesh comes
/// back as it was.
Mesh with_surface(const Mesh& mesh, const WeldedMesh& surface);

}  // namespace luminist
