#pragma once
// make_scene/surface_nets.h -- triangles from a signed distance field.
#include "make_scene/sdf.h"

namespace luminist {

struct FieldBox {
  Point3 lo;
  Point3 hi;
};

/// The zero set of a field inside a box, in cells of size `cell`: one vertex per cell that the surface crosses, moved
/// onto the surface along the gradient; normals are the field's. Blocks of cells that the field's value shows to be far
/// from the surface are not looked into, so the field must not climb faster than `lipschitz` (1 for true distances). No
/// uvs. cost about 15 field evaluations per vertex. source Gibson 1998, "Constrained elastic surface nets".
Mesh surface_nets(const Field& field, const FieldBox& box, double cell, double lipschitz = 1.3);

/// Puts the vertices of a mesh back on the zero set and gives them the field's normals (after a decimation).
void snap_to_field(Mesh& mesh, const Field& field, double cell);

}  // namespace luminist
