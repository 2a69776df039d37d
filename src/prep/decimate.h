#pragma once
// prep/decimate.h -- fewer triangles, nearly the same shape.
#include <cstddef>

#include "scene/mesh.h"

namespace luminist {

/// Collapses edges, the cheapest by quadric error first, until at most `triangle_budget` triangles are left or no
/// collapse keeps the surface a manifold with unflipped triangles. Vertices at one place are joined first; faces that
/// are degenerate or make an edge of three faces are dropped; texture coordinates are dropped; normals are made anew,
/// smooth. cost O(n log n), about 3 us a triangle. source Garland and Heckbert 1997 (OpenMesh).
Mesh decimate(const Mesh& mesh, std::size_t triangle_budget);

/// The same down to a share, in (0,1], of the triangles; at least 4, which enclose a volume.
Mesh decimate_to(const Mesh& mesh, double share);

}  // namespace luminist
