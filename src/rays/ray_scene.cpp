#include "rays/ray_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/check.h"
#include "rays/triangle_geometry.h"
#include "surface/shadow_caster.h"

namespace luminist {
namespace {

constexpr std::size_t kPacket = 16;
constexpr float kEndMargin = 1e-5F;  // fraction of a segment that belongs to its ends
constexpr float kAir = 1e-3F;        // around the bounds, of their diagonal: what touches them is not at an end

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Lets rays pass through the triangles whose front they meet.
void pass_fronts(const RTCFilterFunctionNArguments* args) {
  for (unsigned i = 0; i < args->N; ++i) {
    const float along = RTCRayN_dir_x(args->ray, args->N, i) * RTCHitN_Ng_x(args->hit, args->N, i) +
                        RTCRayN_dir_y(args->ray, args->N, i) * RTCHitN_Ng_y(args->hit, args->N, i) +
                        RTCRayN_dir_z(args->ray, args->N, i) * RTCHitN_Ng_z(args->hit, args->N, i);
    if (!(along > 0.0F)) args->valid[i] = 0;
  }
}

/// leaving: only what leaves the triangles is blocked.
bool attach(RTCDevice device, RTCScene scene, const std::vector<Vec3>& positions, const Triangles& triangles,
            const Mat4& world_from_object, bool leaving) {
  if (triangles.empty()) return true;
  RTCGeometry geometry = triangle_geometry(device, positions, triangles, world_from_object);
  if (geometry == nullptr) return false;
  if (leaving) rtcSetGeometryOccludedFilterFunction(geometry, pass_fronts);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  return true;
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
    for (const Object& object : scene.objects) {
      shadow_slack_.push_back(0.0F);
      const Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.blocking_mesh())];
      const Mat4& place = object.world_from_object;
      if (object.shadow_mesh < 0) {
        if (!attach(device_, scene_, mesh.positions, mesh.triangles, place, false)) return false;
        continue;
      }
      ShadowCaster caster = shadow_caster(mesh);
      shadow_slack_.back() = world_slack(caster, place);
      if (glm::determinant(Mat3(place)) < 0.0F) {
        for (auto& [a, b, c] : caster.closed) std::swap(b, c);
      }
      if (!attach(device_, scene_, caster.positions, caster.closed, place, true)) return false;
      if (!attach(device_, scene_, caster.positions, caster.open, place, false)) return false;
    }
    rtcCommitScene(scene_);
    RTCBounds bounds;
    rtcGetSceneBounds(scene_, &bounds);
    const Vec3 low(bounds.lower_x, bounds.lower_y, bounds.lower_z);
    const Vec3 high(bounds.upper_x, bounds.upper_y, bounds.upper_z);
    const Vec3 air(kAir * glm::length(high - low));
    low_ = low - air, high_ = high + air;
    return rtcGetDeviceError(device_) == RTC_ERROR_NONE;
  }

  [[nodiscard]] float shadow_slack(std::size_t object) const {
    return object < shadow_slack_.size() ? shadow_slack_[object] : 0.0F;
  }

  [[nodiscard]] bool blocked(const Segment& whole) const {
    const Segment segment = near_part(whole);
    const Vec3 way = segment.to - segment.from;
    if (!can_trace(segment.from) || !can_trace(way)) return false;
    RTCRay ray{};
    ray.org_x = segment.from.x, ray.org_y = segment.from.y, ray.org_z = segment.from.z;
    ray.dir_x = way.x, ray.dir_y = way.y, ray.dir_z = way.z;
    ray.tnear = kEndMargin, ray.tfar = 1.0F - kEndMargin;
    ray.mask = 0xFFFFFFFFU;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene_, &context, &ray);
    return ray.tfar < 0.0F;  // Embree's mark
  }

  /// Tests up to kPacket segments.
  void occluded(std::span<const Segment> segments, unsigned char* blocked) const {
    RTCRay16 rays;
    alignas(64) std::array<int, kPacket> valid;
    for (std::size_t i = 0; i < kPacket; ++i) {
      Segment segment = i < segments.size() ? near_part(segments[i]) : Segment{Vec3(0.0F), Vec3(0.0F)};
      const bool traced = i < segments.size() && can_trace(segment.from) && can_trace(segment.to - segment.from);
      if (!traced) segment = {Vec3(0.0F), Vec3(0.0F)};
      const Vec3 way = segment.to - segment.from;
      valid[i] = traced ? -1 : 0;
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

 private:
  /// Without what of its beginning lies outside of the bounds. It still ends where it did, and comes from the same way.
  [[nodiscard]] Segment near_part(const Segment& segment) const {
    const Vec3 back = segment.from - segment.to;
    float inside = 1.0F;  // of the way back
    for (int axis = 0; axis < 3; ++axis) {
      if (back[axis] == 0.0F) continue;
      const float wall = back[axis] > 0.0F ? high_[axis] : low_[axis];
      inside = std::min(inside, (wall - segment.to[axis]) / back[axis]);
    }
    // What is not finite, and what ends outside, stays whole.
    return inside > 0.0F && inside < 1.0F ? Segment{segment.to + inside * back, segment.to} : segment;
  }

  RTCDevice device_;
  RTCScene scene_;
  std::vector<float> shadow_slack_;  ///< [objects]
  Vec3 low_{0.0F};                   ///< bounds of all that blocks, and some air around it
  Vec3 high_{0.0F};
};

RayScene::RayScene(std::unique_ptr<RaySceneImpl> impl) : impl_(std::move(impl)) {}
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;
RayScene::~RayScene() = default;

Result<RayScene> RayScene::create(const Scene& scene) {
  auto impl = std::make_unique<RaySceneImpl>();
  if (!impl->build(scene)) return no_memory_for_rays();
  return RayScene(std::move(impl));
}

float RayScene::shadow_slack(std::size_t object) const {
  return impl_->shadow_slack(object);
}

bool RayScene::blocked(const Segment& segment) const {
  return impl_->blocked(segment);
}

void RayScene::occluded(std::span<const Segment> segments, std::span<unsigned char> blocked) const {
  LUM_CHECK(segments.size() == blocked.size(), "one answer per segment");
  for (std::size_t first = 0; first < segments.size(); first += kPacket) {
    impl_->occluded(segments.subspan(first, std::min(kPacket, segments.size() - first)), blocked.data() + first);
  }
}

}  // namespace luminist
