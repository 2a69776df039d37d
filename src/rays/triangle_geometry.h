#pragma once
// rays/triangle_geometry.h -- triangles for Embree. Inside this module only.
#include <embree3/rtcore.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/math.h"
#include "base/result.h"

namespace luminist {

/// Triangles in world space, not yet committed; null if memory runs out. Indices are checked by whoever made them;
/// there is at least one triangle. The caller releases it.
RTCGeometry triangle_geometry(RTCDevice device, const std::vector<Vec3>& positions,
                              const std::vector<std::array<std::uint32_t, 3>>& triangles,
                              const Mat4& world_from_object);

/// Whether Embree takes a ray with such an origin or direction: finite, and not so large that its products overflow.
/// Debian's build ends the program where one of a packet is not so, even if it is masked out.
inline bool can_trace(const Vec3& vector) {
  constexpr float kLargest = 1e18F;
  return std::abs(vector.x) < kLargest && std::abs(vector.y) < kLargest && std::abs(vector.z) < kLargest;
}

/// What to say where Embree finds no memory.
Error no_memory_for_rays();

}  // namespace luminist
