#pragma once
// make_scene/painting.h -- textures painted by functions of (u, v).
#include <functional>

#include "base/image.h"
#include "make_scene/surface.h"

namespace luminist {

using ColorField = std::function<Vec3(double u, double v)>;  ///< linear RGB
using HeightField = std::function<double(double u, double v)>;

/// A colour texture of width x height, each pixel the mean of 2 x 2 samples.
Image paint_color(int width, int height, const ColorField& color);

/// A tangent-space normal map of a height field that repeats; `extent` is the size that [0,1]^2 has on the surface, in
/// the unit of the heights. Green points towards smaller v, as glTF has it.
Image paint_normals(int width, int height, const HeightField& field, const Point2& extent);

/// A metallic-roughness texture: green is the roughness, blue the metalness.
Image paint_roughness(int width, int height, const HeightField& roughness, double metallic = 0.0);

/// Linear RGB of an sRGB colour 0xRRGGBB, as picked from a swatch.
Vec3 swatch(unsigned rgb);

Vec3 mix(const Vec3& a, const Vec3& b, double t);

}  // namespace luminist
