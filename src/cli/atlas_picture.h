#pragma once
// cli/atlas_picture.h -- a drawing of an unwrapped mesh.
#include "base/image.h"
#include "prep/unwrap.h"

namespace luminist {

/// The atlas, size_px square, v = 0 on top: triangles white where they keep their area, towards red where the plane is
/// larger than the surface and towards blue where it is smaller (full colour at twice and half), faint edges, dark
/// borders of charts, and ticks along the strokes. cost O(triangles + pixels).
Image draw_atlas(const Unwrapped& unwrapped, int size_px);

}  // namespace luminist
