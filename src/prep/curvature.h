#pragma once
// prep/curvature.h -- in which direction a surface bends most, as strokes follow it around a form.
#include <vector>

#include "surface/surface_sides.h"

namespace luminist {

/// Principal curvatures of every position of a surface, > 0 where it is convex, in 1 / scene units.
struct Curvature {
  std::vector<glm::dvec3> normals;     ///< [positions] unit
  std::vector<glm::dvec3> directions;  ///< [positions] unit, tangent, sign-free: of the largest absolute curvature
  std::vector<double> largest;         ///< [positions] the curvature in that direction
  std::vector<double> other;           ///< [positions] and across it
};

/// Per-triangle tensors from differences of normals, averaged over the triangles around a position. The error of
/// directions on a torus of 2,000 triangles is below a degree in the median. cost O(n), about 1 us a triangle.
/// source Rusinkiewicz 2004; normals: Max 1999.
Curvature curvature_of(const WeldedMesh& surface, const SurfaceSides& sides);

/// A direction without sign for each position: where strokes run.
struct StrokeField {
  std::vector<glm::dvec3> normals;     ///< [positions] unit
  std::vector<glm::dvec3> directions;  ///< [positions] unit, tangent
  std::vector<double> confidence;      ///< [positions] in [0,1]: how much the neighbourhood agrees
};

/// The directions of the curvature made smooth: one that bends much more one way than the other keeps its direction,
/// flat and spherical places take over that of their neighbours, over any distance. Where nothing bends, strokes run
/// around the longest axis of the whole. Distances are measured against the size of each piece. Finite for every
/// surface. cost one sparse factorization, about 5 us a triangle.
StrokeField stroke_field(const WeldedMesh& surface, const SurfaceSides& sides);

/// The field at a triangle: a tangent vector, its length the confidence.
glm::dvec3 direction_on(const StrokeField& field, const WeldedMesh& surface, const SurfaceSides& sides,
                        std::size_t triangle);

}  // namespace luminist
