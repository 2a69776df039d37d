#pragma once
// make_scene/jug.h -- a glazed earthenware jug with painted ornament.
#include "base/image.h"
#include "make_scene/surface.h"

namespace luminist {

/// Stands on y = 0, 0.31 high; the spout points to +X, the handle to -X. One mesh, one texture for body and handle.
Mesh jug_mesh();

/// Cobalt, ochre and green on cream: a frieze of flowers between bands, by the jug's own angle and height.
Image jug_painting(int width, int height);

}  // namespace luminist
