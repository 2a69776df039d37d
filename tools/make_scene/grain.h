#pragma once
// make_scene/grain.h -- wood, plaster and weave: textures that tile.
#include "make_scene/painting.h"

namespace luminist {

/// Planks' wood, fibres along u; the texture repeats. `light` and `dark` are the two ends of the grain's range.
Image wood_painting(int width, int height, const Vec3& light, const Vec3& dark);
Image wood_relief(int width, int height, const Point2& extent);
Image wood_roughness(int width, int height);

/// Trowelled plaster of an uneven tint.
Image plaster_painting(int size, const Vec3& tint, double unevenness);
Image plaster_relief(int size, double extent);

/// Plain weave of threads x threads.
Image weave_relief(int size, int threads, double extent);

}  // namespace luminist
