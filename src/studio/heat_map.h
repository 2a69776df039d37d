#pragma once
// studio/heat_map.h -- numbers as colours.
#include "base/image.h"

namespace luminist {

/// A colour for t in [0,1] (clamped), linear RGB: black over violet and orange to pale yellow. Lightness grows evenly
/// (straight lines in OKLab, Ottosson 2020), so that equal steps of t look equally large, also without colour.
Vec3 heat_color(float t);

/// The first channel of an image in such colours; `white` is the value of t = 1.
Image heat_map(const Image& values, float white);

/// The same over a scale that says what the colours mean: from 0 to `white` and more. A few pixels higher.
Image heat_map_with_scale(const Image& values, float white);

/// The value below which that share (in [0,1]) of an image's first channel lies. cost O(pixels).
float quantile(const Image& values, double share);

}  // namespace luminist
