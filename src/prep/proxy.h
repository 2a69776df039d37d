#pragma once
// prep/proxy.h -- simple copies of a mesh that stand in for it where light meets it: one casts its shadow, one lends it
// its normals. The shape that is seen stays what it is.
#include <cstddef>

#include "scene/mesh.h"

namespace luminist {

/// Casts the shadow of a mesh.
struct ShadowProxy {
  Mesh mesh;
  float moved = 0.0F;       ///< the farthest that a vertex was moved inwards, in the mesh's units
  float sticks_out = 0.0F;  ///< how far the proxy still reaches out of the mesh, in the mesh's units
};

/// decimate() down to `share` (in (0,1]) of the triangles, at least 4; then moved into the mesh or onto it where it
/// spans hollows, each vertex as little as its triangles need and at most a twentieth of the mesh's radius.
/// The mesh is repaired. cost that of decimate(), and about 10 us for each triangle of the proxy.
ShadowProxy make_shadow_proxy(const Mesh& mesh, double share);

/// decimate() down to `share` (in (0,1]) of the triangles, at least 4; then smoothed without shrinking and subdivided,
/// so that it has no facets. The mesh is repaired. source of smoothing: Taubin 1995; of subdivision: Loop 1987.
Mesh make_shading_proxy(const Mesh& mesh, double share);

/// What lend_normals() did.
struct LentNormals {
  std::size_t triangles = 0;  ///< of the decimated proxy
  std::size_t kept = 0;       ///< vertices that kept their normals: no part of the proxy that faces their way is near
  double mean_turn = 0.0;     ///< between the normals before and after, radians, mean of the vertices
  double worst_turn = 0.0;
};

/// Gives the vertices of a mesh the normals of make_shading_proxy() at the nearest place that faces their way, so that
/// thin parts keep their two sides. The surface stays what it is, but triangles that are large beside those of the
/// proxy are split (new vertices come behind the old ones), so that normals can bend within them. Where a normal would
/// face the back of a triangle, it is turned back towards what it was. cost that of decimate(), and about 3 us a
/// vertex.
LentNormals lend_normals(Mesh& mesh, double share);

}  // namespace luminist
