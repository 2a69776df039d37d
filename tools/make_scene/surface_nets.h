#pragma once
// make_scene/surface_nets.h -- triangles from a signed distance field.
#include "make_scene/sdf.h"

namespace luminist {

struct FieldBox {
  Point3 lo;
  Point3 hi;
};

/// The zero set of a field inside a box, in cells of size `cell`: one vertex per cell that the surface crosses, near
/// the surface; snap_to_field() puts it there. Positions and triangles only. Blocks of cells that the field's value
/// shows to be far from the surface are not looked into, so the field must not climb faster than `lipschitz` (1 for
/// true distances). cost about 9 field evaluations per vertex. source Gibson 1998, "Constrained elastic surface nets".
Mesh surface_nets(const Field& field, const FieldBox& box, double cell, double lipschitz = 1.3);

/// Puts the vertices of a mesh on the zero set, along the gradient, and gives them the field's normals. cost 20 field
/// evaluations per vertex: decimate first.
void snap_to_field(Mesh& mesh, const Field& field, double cell);

}  // namespace luminist
