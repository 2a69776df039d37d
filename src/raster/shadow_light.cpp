#include "raster/shadow_light.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace luminist {
namespace {

constexpr float kLeastExtent = 0.05F;  // 3 degrees
constexpr float kMostExtent = 4.0F;    // 76 degrees
constexpr float kLeastSoftness = 1e-4F;
constexpr float kMostSoftness = 0.5F;
constexpr float kSunMargin = 1.05F;    // of the scene's radius: the filter of what lies at its rim stays in the map
constexpr float kSunDistance = 64.0F;  // of what a sun's map covers: beyond all backdrops
constexpr int kLeastSize = 256;
constexpr int kMostSize = 2048;
constexpr float kLeastRadius = 2.0F;  // of the filter, in texels

/// The steepest receiver that the filter follows (cosine); steeper ones are nearly black anyway.
constexpr float kLeastCosine = 0.1F;
/// Taps outside the filter's core (its share of the radius) are pulled towards the light by this multiple of how far
/// they lie from it, so that the other wall of a corner does not darken it: the filter narrows, as it would under a
/// real lamp, for what is nearer to the receiver than the filter is wide.
constexpr float kPull = 3.0F;
constexpr float kMostPull = 0.15F;  // of the distance to the light
/// The cosine over which an object's own shadow sets in where it turns away from the light.
constexpr float kOwnShadowEdge = 0.05F;

/// Half the side of a square map that covers the light's shape whichever way it is turned: a superellipse of degree 4
/// with half axes w, h reaches (w^4 + h^4)^(1/4) from its centre.
float extent_of(const ParamBlock& params) {
  const std::optional<int> shape = params.schema().by_role("shape");
  if (!shape) return kMostExtent;
  const int components = params.schema()[*shape].components();
  const auto number = [&](int component) {
    return component < components ? static_cast<float>(params.get(*shape, component)) : 0.0F;
  };
  const float edge = std::max(number(2), 0.0F);
  const float w = std::max(number(0), 0.0F) + edge;
  const float h = components > 1 ? std::max(number(1), 0.0F) + edge : w;
  const float reach = std::sqrt(std::hypot(w * w, h * h));
  if (!std::isfinite(reach)) return kMostExtent;
  // Steps of the square root of two: a small change of the shape keeps the map and all that was looked up in it.
  const float stepped = std::exp2(0.5F * std::ceil(2.0F * std::log2(std::max(reach, kLeastExtent))));
  return std::clamp(stepped, kLeastExtent, kMostExtent);
}

/// Six views of a right angle each, a little wider, so that the filter (to first order 2.1 softnesses at a corner) and
/// two texels of at most half a softness do not leave the view.
float cube_extent(float softness) {
  return std::min(1.0F + 4.0F * softness, kMostExtent);
}

float softness_of(const ParamBlock& params) {
  const std::optional<int> size = params.schema().by_role("size");
  const float softness = size ? params.scalar(*size) : ShadowLight{}.softness;
  return std::isfinite(softness) ? std::clamp(softness, kLeastSoftness, kMostSoftness) : ShadowLight{}.softness;
}

/// Chooses the map's size for the filter, and widens the filter if the largest map is too coarse for it.
void fit_size(ShadowLight& light) {
  const float texels = std::ceil(kLeastRadius * 2.0F * light.extent / light.softness);
  const auto wanted = static_cast<unsigned>(std::clamp(texels, 1.0F, static_cast<float>(kMostSize)));
  light.size_px = std::clamp(static_cast<int>(std::bit_ceil(wanted)), kLeastSize, kMostSize);
  light.softness = std::max(light.softness, kLeastRadius * light.texel());
}

/// shadow_tap() of parallel rays: the disc is as large at every distance.
Vec3 parallel_tap(const ShadowLight& light, const Vec3& receiver, const Vec3& normal, const Vec2& disc) {
  Vec3 right;
  Vec3 up;
  tangent_frame(light.direction, right, up);
  const Vec3 across = light.softness * (disc.x * right + disc.y * up);
  const float slope = glm::dot(across, normal) / std::max(-glm::dot(light.direction, normal), kLeastCosine);
  const float pull = kPull * light.softness * glm::length(disc);
  return receiver + across - (pull + std::max(-slope, 0.0F)) * light.direction;
}

}  // namespace

ShadowLight shadow_light(const Light& light, const LightTypes& types, const SceneFrame& scene) {
  const LightType* type = types.find(light.type);
  const std::optional<int> position = light.params.schema().by_role("position");
  if (type == nullptr || type->shadow == ShadowKind::kNone) return {};
  if (type->shadow != ShadowKind::kSun && !position) return {};

  ShadowLight shadow;
  shadow.kind = type->shadow;
  shadow.position = shadow.parallel() ? scene.center : light.params.vec3(*position);
  shadow.softness = softness_of(light.params);
  if (shadow.kind != ShadowKind::kCube) {
    const std::optional<int> direction = light.params.schema().by_role("direction");
    if (direction) shadow.direction = glm::normalize(light.params.vec3(*direction));
  }
  if (shadow.parallel()) {
    shadow.softness *= scene.radius;
    shadow.extent = kSunMargin * scene.radius;
  } else if (shadow.kind == ShadowKind::kSpot) {
    shadow.extent = extent_of(light.params);
  } else {
    shadow.extent = cube_extent(shadow.softness);
  }
  if (!is_finite(shadow.position) || !is_finite(shadow.direction)) return {};
  fit_size(shadow);
  return shadow;
}

std::vector<ShadowLight> shadow_lights(const LightRig& rig, const LightTypes& types, const SceneFrame& scene) {
  const Light* shared = rig.shadow_light.empty() ? nullptr : rig.find(rig.shadow_light);
  std::vector<ShadowLight> shadows;
  for (const Light& light : rig.lights) {
    shadows.push_back(shadow_light(shared != nullptr ? *shared : light, types, scene));
  }
  return shadows;
}

float receiver_offset(const ShadowLight& light, float distance, float cosine) {
  // Within the 2 x 2 texels that a comparison reads, a plane's depth changes by up to sqrt(2) texels times its slope,
  // and seen off the map's axis by 3/4 of a texel even when it faces the light.
  const float sine = std::sqrt(std::max(0.0F, 1.0F - cosine * cosine));
  return distance * light.texel() * (0.75F + 0.75F * sine);
}

Vec3 way_to_light(const ShadowLight& light, const Vec3& position) {
  if (light.parallel()) return -light.direction;
  const Vec3 way = light.position - position;
  const float distance = glm::length(way);
  return distance > 0.0F ? way / distance : Vec3(0.0F);
}

Vec3 ray_origin(const ShadowLight& light, const Vec3& tap) {
  return light.parallel() ? tap - kSunDistance * light.extent * light.direction : light.position;
}

Vec3 shadow_receiver(const ShadowLight& light, const Vec3& position, const Vec3& normal, float slack) {
  const float distance = light.parallel() ? 1.0F : glm::length(light.position - position);
  const float cosine = distance > 0.0F ? glm::dot(way_to_light(light, position), normal) : 1.0F;
  return position + normal * (receiver_offset(light, distance, cosine) + slack);
}

Vec3 shadow_tap(const ShadowLight& light, const Vec3& receiver, const Vec3& normal, const Vec2& disc) {
  if (light.parallel()) return parallel_tap(light, receiver, normal, disc);
  const Vec3 way = receiver - light.position;
  const float distance = glm::length(way);
  if (!(distance > 0.0F)) return receiver;
  const Vec3 axis = way / distance;
  Vec3 right;
  Vec3 up;
  tangent_frame(axis, right, up);
  const Vec3 across = light.softness * (disc.x * right + disc.y * up);
  const float slope = glm::dot(across, normal) / std::max(-glm::dot(axis, normal), kLeastCosine);
  const float pull = std::min(kPull * light.softness * glm::length(disc), kMostPull);
  const float reach = distance * (1.0F - pull) / (1.0F + std::max(-slope, 0.0F));
  return light.position + reach * (axis + across);
}

float share_before_own_shadow(float cosine) {
  return std::clamp(1.0F + cosine / kOwnShadowEdge, 0.0F, 1.0F);
}

bool shadow_covers(const ShadowLight& light, const Vec3& receiver) {
  if (light.kind == ShadowKind::kNone || light.kind == ShadowKind::kCube) return light.kind == ShadowKind::kCube;
  const Vec3 way = receiver - light.position;
  const float depth = light.parallel() ? 1.0F : glm::dot(way, light.direction);
  Vec3 right;
  Vec3 up;
  tangent_frame(light.direction, right, up);
  const float reach = depth * light.extent;
  return depth > 0.0F && std::abs(glm::dot(way, right)) <= reach && std::abs(glm::dot(way, up)) <= reach;
}

Vec2 vogel_disc(int i, int n) {
  const float golden_angle = kPiF * (3.0F - std::sqrt(5.0F));
  const float radius = std::sqrt((static_cast<float>(i) + 0.5F) / static_cast<float>(n));
  const float angle = static_cast<float>(i) * golden_angle;
  return radius * Vec2(std::cos(angle), std::sin(angle));
}

}  // namespace luminist
