#pragma once
// scene/polygon.h -- polygons into triangles.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/math.h"

namespace luminist {

/// Cuts a polygon given by its corners' positions (in order, not necessarily convex or flat) into corners.size() - 2
/// triangles of corner numbers with the same winding; a quad is cut along its shorter inner diagonal, larger ones by
/// clipping ears in the plane of the area vector. Fewer than 3 corners give none.
/// cost O(n^2) up to 1,024 corners, a fan beyond.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners);

}  // namespace luminist
