#include "rays/surface_rays.h"

#include <embree3/rtcore.h>

#include <utility>

#include "rays/triangle_geometry.h"

namespace luminist {
namespace {

/// A query among the triangles of one object, or of all.
struct Query {
  RTCIntersectContext context;  ///< first: Embree hands a pointer to it to the filter
  int only = SurfaceRays::kAnyObject;
};

/// Lets rays pass through the objects that are not asked for.
void pass_others(const RTCFilterFunctionNArguments* args) {
  const int only = reinterpret_cast<const Query*>(args->context)->only;
  if (only == SurfaceRays::kAnyObject) return;
  for (unsigned i = 0; i < args->N; ++i) {
    if (RTCHitN_geomID(args->hit, args->N, i) != static_cast<unsigned>(only)) args->valid[i] = 0;
  }
}

}  // namespace

class SurfaceRaysImpl {
 public:
  SurfaceRaysImpl() : device_(rtcNewDevice(nullptr)), scene_(device_ != nullptr ? rtcNewScene(device_) : nullptr) {}
  SurfaceRaysImpl(const SurfaceRaysImpl&) = delete;
  SurfaceRaysImpl& operator=(const SurfaceRaysImpl&) = delete;
  ~SurfaceRaysImpl() {
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
      RTCGeometry geometry = triangle_geometry(device_, mesh.positions, mesh.triangles, object.world_from_object);
      if (geometry == nullptr) return false;
      rtcSetGeometryIntersectFilterFunction(geometry, pass_others);
      rtcCommitGeometry(geometry);
      rtcAttachGeometryByID(scene_, geometry, static_cast<unsigned>(i));
      rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene_);
    return rtcGetDeviceError(device_) == RTC_ERROR_NONE;
  }

  [[nodiscard]] RayHit first(const Ray& ray, int only) const {
    if (!can_trace(ray.origin) || !can_trace(ray.direction)) return {};
    RTCRayHit query{};
    query.ray.org_x = ray.origin.x, query.ray.org_y = ray.origin.y, query.ray.org_z = ray.origin.z;
    query.ray.dir_x = ray.direction.x, query.ray.dir_y = ray.direction.y, query.ray.dir_z = ray.direction.z;
    query.ray.tnear = ray.least, query.ray.tfar = ray.most;
    query.ray.mask = 0xFFFFFFFFU;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    Query asked;
    rtcInitIntersectContext(&asked.context);
    asked.only = only;
    rtcIntersect1(scene_, &asked.context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {query.ray.tfar, query.hit.geomID, query.hit.primID, query.hit.u, query.hit.v};
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

SurfaceRays::SurfaceRays(std::unique_ptr<SurfaceRaysImpl> impl) : impl_(std::move(impl)) {}
SurfaceRays::SurfaceRays(SurfaceRays&&) noexcept = default;
SurfaceRays& SurfaceRays::operator=(SurfaceRays&&) noexcept = default;
SurfaceRays::~SurfaceRays() = default;

Result<SurfaceRays> SurfaceRays::create(const Scene& scene) {
  auto impl = std::make_unique<SurfaceRaysImpl>();
  if (!impl->build(scene)) return no_memory_for_rays();
  return SurfaceRays(std::move(impl));
}

RayHit SurfaceRays::first(const Ray& ray, int only) const {
  return impl_->first(ray, only);
}

}  // namespace luminist
