#include "rays/ray_scene.h"

#include <embree3/rtcore.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

#include "base/check.h"

namespace luminist {
namespace {

constexpr std::size_t kPacket = 16;
constexpr float kEndMargin = 1e-5F;  // fraction of a segment that belongs to its ends

Error out_of_memory() {
  return {ErrorKind::kLimit, "no memory for the ray index of the scene", "", "", "use a smaller scene"};
}

/// The triangles of one object in world space. Indices are checked by whoever made the mesh.
bool attach_object(RTCDevice device, RTCScene scene, unsigned id, const Mesh& mesh, const Mat4& world_from_object) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), mesh.positions.size()));
  auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles.size()));
  const bool complete = vertices != nullptr && indices != nullptr;
  if (complete) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const Vec3 p(world_from_object * Vec4(mesh.positions[i], 1.0F));
      vertices[3 * i] = p.x, vertices[3 * i + 1] = p.y, vertices[3 * i + 2] = p.z;
    }
    std::memcpy(indices, mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
  }
  rtcReleaseGeometry(geometry);
  return complete;
}

}  // namespace

class RaySceneImpl {
 public:
  RaySceneImpl() : device_(rtcNewDevice(nullptr)), scene_(device_ != nullptr ? rtcNewScene(device_) : nullptr) {}
  RaySceneImpl(const RaySceneImpl&) = delete;
  RaySceneImpl& operator=(const RaySceneImpl&) = delete;
  ~RaySceneImpl() {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    if (device_ != nullptr) rtcReleaseDevice(device_);
  }

  bool build(const Scene& scene) {
    if (scene_ == nullptr) return false;
    // Robust: rays do not slip through the edges that triangles share.
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const Object& object = scene.objects[i];
      const Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
      if (mesh.triangles.empty()) continue;
      if (!attach_object(device_, scene_, static_cast<unsigned>(i), mesh, object.world_from_object)) return false;
    }
    rtcCommitScene(scene_);
    return rtcGetDeviceError(device_) == RTC_ERROR_NONE;
  }

  /// Tests up to kPacket segments.
  void occluded(std::span<const Segment> segments, unsigned char* blocked) const {
    RTCRay16 rays;
    alignas(64) std::array<int, kPacket> valid;
    for (std::size_t i = 0; i < kPacket; ++i) {
      const Segment segment = i < segments.size() ? segments[i] : Segment{Vec3(0.0F), Vec3(0.0F)};
      const Vec3 way = segment.to - segment.from;
      valid[i] = i < segments.size() && is_finite(segment.from) && is_finite(way) ? -1 : 0;
      rays.org_x[i] = segment.from.x, rays.org_y[i] = segment.from.y, rays.org_z[i] = segment.from.z;
      rays.dir_x[i] = way.x, rays.dir_y[i] = way.y, rays.dir_z[i] = way.z;
      rays.tnear[i] = kEndMargin, rays.tfar[i] = 1.0F - kEndMargin;
      rays.time[i] = 0.0F, rays.mask[i] = 0xFFFFFFFFU, rays.id[i] = 0, rays.flags[i] = 0;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded16(valid.data(), scene_, &context, &rays);
    // Embree marks a blocked ray with tfar = -inf.
    for (std::size_t i = 0; i < segments.size(); ++i) blocked[i] = valid[i] != 0 && rays.tfar[i] < 0.0F ? 1 : 0;
  }

  [[nodiscard]] RayHit closest(const Ray& ray) const {
    if (!is_finite(ray.origin) || !is_finite(ray.direction)) return {};
    RTCRayHit query{};
    query.ray.org_x = ray.origin.x, query.ray.org_y = ray.origin.y, query.ray.org_z = ray.origin.z;
    query.ray.dir_x = ray.direction.x, query.ray.dir_y = ray.direction.y, query.ray.dir_z = ray.direction.z;
    query.ray.tfar = std::numeric_limits<float>::infinity();
    query.ray.mask = 0xFFFFFFFFU;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {query.ray.tfar, query.hit.geomID, query.hit.primID, query.hit.u, query.hit.v};
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

RayScene::RayScene(std::unique_ptr<RaySceneImpl> impl) : impl_(std::move(impl)) {}
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;
RayScene::~RayScene() = default;

Result<RayScene> RayScene::create(const Scene& scene) {
  auto impl = std::make_unique<RaySceneImpl>();
  if (!impl->build(scene)) return out_of_memory();
  return RayScene(std::move(impl));
}

RayHit RayScene::closest(const Ray& ray) const {
  return impl_->closest(ray);
}

void RayScene::occluded(std::span<const Segment> segments, std::span<unsigned char> blocked) const {
  LUM_CHECK(segments.size() == blocked.size(), "one answer per segment");
  for (std::size_t first = 0; first < segments.size(); first += kPacket) {
    impl_->occluded(segments.subspan(first, std::min(kPacket, segments.size() - first)), blocked.data() + first);
  }
}

}  // namespace luminist
