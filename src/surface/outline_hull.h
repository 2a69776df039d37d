#pragma once
// surface/outline_hull.h -- the surface that outlines are made of: a copy of a mesh that can be inflated without
// tearing.
#include <array>
#include <cstdint>
#include <vector>

#include "scene/material.h"
#include "scene/mesh.h"

namespace luminist {

/// A mesh moved by `amount` along its directions is its silhouette's outline where it is seen from behind
/// (source: Raskar and Cohen 1999). An open border has no such side; a strip of two-sided triangles lies along it in
/// the plane of its surface, without width until it is moved.
///
/// Edges that bend are listed beside it, for creases.
struct OutlineHull {
  struct Edge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    /// Between the normals of its two triangles, radians; half of it where the shading normals are joined, because a
    /// coarse but round surface has no creases; and no more than the edges it is continued by at either end, a few
    /// edges far, so that at no threshold a crease is a crumb.
    float angle = 0.0F;
  };
  static constexpr float kFlat = 0.05F;    ///< edges that bend by less are left out
  static constexpr float kLongest = 2.0F;  ///< of a direction: spikes do not grow without bound

  std::vector<Vec3> positions;
  /// Along the normal that belongs to the place, weighted by the angles of all triangles around it whatever their
  /// shading normals, and so long that a step moves every triangle there by at least 1, up to kLongest; zero on the
  /// inner side of a strip.
  std::vector<Vec3> directions;
  std::vector<float> widths;  ///< 0 to 1, of the mesh's line_widths and the mask; 1 where it has neither
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Edge> edges;
};

/// Of a mesh as it comes: it is repaired first. mask: widths are multiplied by its red at the vertices' uvs, if the
/// mesh has any; where corners of one place differ, the least counts. cost that of repair(), O(n log n).
OutlineHull outline_hull(const Mesh& mesh, const Texture* mask = nullptr);

}  // namespace luminist
