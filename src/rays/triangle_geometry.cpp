#include "rays/triangle_geometry.h"

#include <cstring>

namespace luminist {

RTCGeometry triangle_geometry(RTCDevice device, const std::vector<Vec3>& positions,
                              const std::vector<std::array<std::uint32_t, 3>>& triangles,
                              const Mat4& world_from_object) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), positions.size()));
  auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
  if (vertices == nullptr || indices == nullptr) {
    rtcReleaseGeometry(geometry);
    return nullptr;
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 p(world_from_object * Vec4(positions[i], 1.0F));
    vertices[3 * i] = p.x, vertices[3 * i + 1] = p.y, vertices[3 * i + 2] = p.z;
  }
  std::memcpy(indices, triangles.data(), triangles.size() * sizeof(triangles[0]));
  return geometry;
}

Error no_memory_for_rays() {
  return {ErrorKind::kLimit, "no memory for the ray index of the scene", "", "", "use a smaller scene"};
}

}  // namespace luminist
