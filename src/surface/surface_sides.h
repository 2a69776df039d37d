#pragma once
// surface/surface_sides.h -- what the triangles of a repaired surface are and what they share with their neighbours.
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/geometric.hpp>

#include "base/disjoint_sets.h"
#include "surface/repair.h"

namespace luminist {

/// Side 3 f + k of triangle f runs from its corner k to the next. Lengths in scene units, angles in radians.
struct SurfaceSides {
  static constexpr std::uint32_t kNone = 0xffffffffU;

  std::vector<std::uint32_t> across;  ///< [sides] the neighbour's side that is the same edge, or kNone
  std::vector<double> lengths;        ///< [sides]
  std::vector<double> turns;          ///< [sides] between the normals, > 0 over a ridge, < 0 in a groove, 0 at borders
  std::vector<glm::dvec3> normals;    ///< [triangles] unit
  std::vector<double> areas;          ///< [triangles]
  std::vector<std::uint32_t> piece;   ///< [triangles] number of the connected piece
  std::vector<double> piece_areas;    ///< [pieces]
};

/// cost O(n log n).
SurfaceSides sides_of(const WeldedMesh& surface);

/// The same with normals averaged over a neighbourhood of about `reach` of each surface's size (the root of its area),
/// but not over edges, and with the turns between those: bumps of a scan do not look like shape. cost O(n reach^2).
SurfaceSides smoothed(const SurfaceSides& sides, double reach);

/// Two unit vectors that complete n (unit) to a right-handed frame.
struct TangentFrame {
  glm::dvec3 t;
  glm::dvec3 b;
};
TangentFrame tangent_frame_of(const glm::dvec3& n);

/// A tangent vector at normal `from`, turned by the smallest rotation that takes that normal to `to` (both unit).
glm::dvec3 transported(const glm::dvec3& tangent, const glm::dvec3& from, const glm::dvec3& to);

}  // namespace luminist
