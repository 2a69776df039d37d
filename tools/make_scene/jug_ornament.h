#pragma once
// make_scene/jug_ornament.h -- the painter's motifs on the jug: bands, a frieze of flowers, leaves on the shoulder.
#include "make_scene/painting.h"

namespace luminist {

/// Colour of the jug's outside at an angle and height, where its radius is given (lengths in metres).
Vec3 ornament_color(double angle, double height, double radius);

/// The cream tin glaze, by any two coordinates in metres.
Vec3 ornament_glaze(const Point2& place);

Vec3 ornament_cobalt();

}  // namespace luminist
