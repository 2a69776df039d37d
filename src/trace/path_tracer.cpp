#include "trace/path_tracer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/matrix.hpp>

#include "trace/path_sampler.h"

namespace luminist {
namespace {

constexpr int kSureBounces = 1;       // surfaces before chance may end a path
constexpr float kMostLikely = 0.95F;  // that a path goes on
constexpr float kLeastLikely = 0.05F;

constexpr float kSpreadRoughness = 0.6F;  // of what is seen by way of rough surfaces, without caustics...
constexpr float kDullReflectance = 0.1F;  // ...where what reflects less at normal incidence is matte

/// What a dimension of the sampler is for; a vertex has kPerVertex of them.
enum Dimension : std::uint32_t { kPixel, kFirstVertex };
enum VertexDimension : std::uint32_t { kLobe, kDirection, kRigLight, kEmitter, kEmitterPlace, kPerVertex };

}  // namespace

void LightPaths::clear() {
  vertices.clear();
  first.assign(1, 0);
  emitted.clear();
  emitted_later.clear();
  escaped.clear();
}

struct PathTracer::Walk {
  const PathOptions& options;
  PathSampler sampler;
  LightPaths& paths;
  int surfaces = 0;      ///< met so far
  bool spread = false;   ///< one of them was rough
  bool later = false;    ///< one before the last vertex was: what arrives there comes by way of another surface
  PathVertex here = {};  ///< the last vertex, its way on chosen
  Vec3 emitted{0.0F};
  Vec3 emitted_later{0.0F};
  Vec3 escaped{0.0F};

  void add(const Vec3& radiance) {
    emitted += radiance;
    if (later) emitted_later += radiance;
  }
  [[nodiscard]] Vec2 pair(VertexDimension dimension) const {
    return sampler.pair(kFirstVertex + static_cast<std::uint32_t>(surfaces) * kPerVertex + dimension);
  }
};

Result<PathTracer> PathTracer::create(Scene scene, const Camera& camera, int width, int height) {
  PathTracer tracer;
  LUM_TRY(RayScene rays, RayScene::create(scene));
  tracer.rays_ = std::make_unique<const RayScene>(std::move(rays));
  LUM_TRY(SurfaceRays seen, SurfaceRays::create(scene));
  tracer.seen_ = std::make_unique<const SurfaceRays>(std::move(seen));
  tracer.surfaces_ = std::make_unique<SceneSurfaces>(std::move(scene));
  tracer.emitters_ = std::make_unique<const MeshEmitters>(*tracer.surfaces_);
  tracer.world_from_camera_ = camera.world_from_camera;
  tracer.near_ = camera.near_plane;
  tracer.half_extent_.y = std::tan(0.5F * camera.fov_y);
  tracer.half_extent_.x = tracer.half_extent_.y * static_cast<float>(width) / static_cast<float>(height);
  tracer.width_ = width;
  tracer.height_ = height;
  return tracer;
}

Ray PathTracer::eye_ray(const Vec2& place) const {
  const Vec3 local((2.0F * place.x / static_cast<float>(width_) - 1.0F) * half_extent_.x,
                   (1.0F - 2.0F * place.y / static_cast<float>(height_)) * half_extent_.y, -1.0F);
  const Vec3 way = Vec3(world_from_camera_ * Vec4(local, 0.0F));
  return {Vec3(world_from_camera_[3]) + near_ * way, glm::normalize(way)};
}

void PathTracer::trace(std::uint32_t pixel, std::uint32_t sample, const PathOptions& options, LightPaths& paths) const {
  Walk walk{options, PathSampler(options.seed, pixel, sample), paths};
  const auto columns = static_cast<std::uint32_t>(width_);
  const Vec2 corner(static_cast<float>(pixel % columns), static_cast<float>(pixel / columns));
  const Ray ray = eye_ray(corner + walk.sampler.pair(kPixel));
  walk.here.position = ray.origin;
  walk.here.way = ray.direction;
  walk.here.way_throughput = Vec3(1.0F);
  bool more = true;
  while (more) {
    const RayHit hit = seen_->first({walk.here.position, walk.here.way});
    walk.here.way_length = hit.distance;
    paths.vertices.push_back(walk.here);
    more = arrive(walk, hit);
  }
  paths.first.push_back(static_cast<std::uint32_t>(paths.vertices.size()));
  paths.emitted.push_back(walk.emitted);
  paths.emitted_later.push_back(walk.emitted_later);
  paths.escaped.push_back(walk.escaped);
}

bool PathTracer::arrive(Walk& walk, const RayHit& hit) const {
  const PathVertex& from = walk.here;
  if (!hit.hit()) {
    if (walk.surfaces > 0) walk.escaped += from.way_throughput;  // behind everything a picture is black
    return false;
  }
  SurfacePoint point = surfaces_->at(hit, from.way);
  if (walk.spread && !walk.options.caustics) point.roughness = std::max(point.roughness, kSpreadRoughness);
  if (largest(point.emissive) > 0.0F) {
    float weight = 1.0F;
    const float cosine = std::abs(glm::dot(point.face, from.way));
    if (from.way_pdf > 0.0F && cosine > 0.0F) {
      const float area_pdf = emitters_->area_pdf(hit.object, hit.triangle);
      weight = mis_weight(from.way_pdf, area_pdf * hit.distance * hit.distance / cosine);
    }
    walk.add(weight * from.way_throughput * point.emissive);
  }
  walk.later = walk.spread;
  if (walk.surfaces == walk.options.bounces) return false;

  PathVertex next;
  next.object = hit.object;
  next.position = point.position + surfaces_->clearance() * point.face;
  next.throughput = from.way_throughput;
  // Highlights that only rough surfaces see are spread to nothing, but those of metals are all that they reflect.
  const bool dull = walk.spread && !walk.options.caustics && largest(point.specular) < kDullReflectance;
  next.surface = Reflection::create(point, -from.way, dull ? 0.0F : walk.options.specular);
  next.scatters = next.surface.scatters();
  next.place = walk.pair(kRigLight);
  if (next.scatters && !emitters_->empty()) ask_emitters(walk, next);
  const Vec2 lobe = walk.pair(kLobe);
  const Bounce bounce = sample(next.surface, lobe.x, walk.pair(kDirection));
  ++walk.surfaces;
  // Light does not pass through a surface, whatever its shading normal says.
  const bool passes = glm::dot(bounce.direction, point.face) <= 0.0F;
  next.way = bounce.direction;
  next.way_pdf = bounce.pdf;
  walk.spread = walk.spread || bounce.pdf > 0.0F;
  next.way_throughput = next.throughput * bounce.weight;
  if (passes || !(largest(next.way_throughput) > 0.0F) || !survives(walk, next, lobe.y)) {
    next.way_length = PathVertex::kNoWay;
    walk.paths.vertices.push_back(next);
    return false;
  }
  walk.here = next;
  return true;
}

bool PathTracer::survives(const Walk& walk, PathVertex& vertex, float chance) const {
  if (walk.surfaces <= kSureBounces) return true;
  const float likely = std::clamp(largest(vertex.way_throughput), kLeastLikely, kMostLikely);
  if (chance >= likely) return false;
  vertex.way_throughput /= likely;
  return true;
}

void PathTracer::ask_emitters(Walk& walk, const PathVertex& vertex) const {
  const EmitterPoint emitter = emitters_->sample(walk.pair(kEmitter).x, walk.pair(kEmitterPlace));
  const Vec3 way = emitter.position - vertex.position;
  const float square = glm::dot(way, way);
  if (!(square > 0.0F) || !(emitter.area_pdf > 0.0F)) return;
  const Vec3 direction = way / std::sqrt(square);
  const float cosine = std::abs(glm::dot(emitter.normal, direction));
  const Scattered scattered = evaluate(vertex.surface, direction);
  if (!(cosine > 0.0F) || !(scattered.pdf > 0.0F)) return;
  if (rays_->blocked({vertex.position, emitter.position})) return;
  const float pdf = emitter.area_pdf * square / cosine;
  walk.add(vertex.throughput * scattered.value * emitter.radiance * (mis_weight(pdf, scattered.pdf) / pdf));
}

SurfaceBuffer PathTracer::surface_buffer() const {
  SurfaceBuffer buffer;
  buffer.width = width_;
  buffer.height = height_;
  buffer.eye = Vec3(world_from_camera_[3]);
  const std::size_t count = buffer.pixels();
  for (auto* colors : {&buffer.position, &buffer.normal, &buffer.albedo, &buffer.specular}) {
    colors->assign(count, Vec3(0.0F));
  }
  buffer.roughness.assign(count, 0.0F);
  buffer.object.assign(count, 0);
  buffer.material.assign(count, 0);
  buffer.object_names.emplace_back();
  for (const Object& object : surfaces_->scene().objects) buffer.object_names.push_back(object.name);
  tbb::parallel_for(0, height_, [&](int y) {
    for (int x = 0; x < width_; ++x) {
      const Ray ray = eye_ray(Vec2(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F));
      const RayHit hit = seen_->first(ray);
      if (!hit.hit()) continue;
      const SurfacePoint point = surfaces_->at(hit, ray.direction);
      const std::size_t i = buffer.index(x, y);
      buffer.position[i] = point.position;
      buffer.normal[i] = point.normal;
      buffer.albedo[i] = point.albedo;
      buffer.specular[i] = point.specular;
      buffer.roughness[i] = point.roughness;
      buffer.object[i] = 1 + hit.object;
      buffer.material[i] = 1 + static_cast<std::uint32_t>(surfaces_->scene().objects[hit.object].material);
    }
  });
  return buffer;
}

}  // namespace luminist
