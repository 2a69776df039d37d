#pragma once
// make_scene/vessel.h -- bowls, and other turned things.
#include "base/image.h"
#include "make_scene/surface.h"

namespace luminist {

/// Stands on y = 0: 0.19 wide, 0.072 high, a turned foot and a rounded lip.
Mesh bowl_mesh();
/// How high the inside is at a distance from the axis, for what lies in it.
double bowl_floor(double distance);
/// A celadon glaze that breaks to brown at the lip and pools below, rows as bowl_mesh()'s v.
Image bowl_painting(int width, int height);

}  // namespace luminist
