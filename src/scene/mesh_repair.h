#pragma once
// scene/mesh_repair.h -- what load_scene() does to every mesh before anybody else sees it.
#include <string>

#include "base/diagnostics.h"
#include "scene/mesh.h"

namespace luminist {

/// Finite, and small enough that squares and products of three of them stay finite in float.
inline bool is_usable(const Vec3& p) {
  constexpr float kLargest = 1e12F;
  return is_finite(p) && std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kLargest;
}

/// Drops the faces that have an index outside the positions or a corner that is not usable, with a warning for each
/// kind that counts them and names the first; then the vertices that no face uses. A uv that is not finite becomes 0.
/// where: the file; field: the part of it that messages name.
void drop_faulty_faces(Mesh& mesh, const std::string& where, const std::string& field, Diagnostics& diagnostics);

/// Makes normals valid: computes missing ones, normalizes, replaces those that are zero or not finite by the smooth
/// normal of their place, and turns all of them if most of the surface has its normals on its back. returns whether all
/// were turned.
bool repair_normals(Mesh& mesh, const std::string& where, const std::string& field, Diagnostics& diagnostics);

/// Turns the winding of a closed surface that is inside out (negative volume), and its normals with it.
/// Returns whether it did.
bool turn_outside(Mesh& mesh);

/// The mesh reflected in x = 0, still with its front faces counter-clockwise: what an object with a reflecting matrix
/// becomes when the reflection is taken out of the matrix.
Mesh mirrored(const Mesh& mesh);

}  // namespace luminist
