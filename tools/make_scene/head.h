#pragma once
// make_scene/head.h -- a sculpted human head as signed distance fields. Lengths in centimetres; the origin lies between
// the eyes' centres and the skull's middle, Y up, the face looks along +Z; the head is 23 high.
#include "make_scene/sdf.h"

namespace luminist {

/// Skull, face, ears. cost about 1.5 us.
double head_distance(const Point3& p);

/// Waved hair, swept back from the brow into a knot. cost about 0.5 us.
double hair_distance(const Point3& p);

}  // namespace luminist
