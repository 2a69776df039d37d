#include "trace/rig_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "rig/light_links.h"

namespace luminist {
namespace {

constexpr float kTiny = 1e-6F;
constexpr float kPanelLift = 1e-3F;    // of the scene's radius: a panel on a ceiling is before the ceiling
constexpr float kLeastSide = 2e-3F;    // of the scene's radius
constexpr float kSunDistance = 2e3F;   // of the scene's radius
constexpr float kMostSoftness = 0.5F;  // as in the raster engine

float saturate(float x) {
  return std::clamp(x, 0.0F, 1.0F);
}

Vec3 safe_normalize(const Vec3& v, const Vec3& fallback) {
  const float square = glm::dot(v, v);
  return square > 1e-24F && square < 1e24F ? v / std::sqrt(square) : fallback;
}

float smooth(float t) {
  return t * t * (3.0F - 2.0F * t);
}

float ramp_up(float start, float width, float x) {
  return smooth(saturate((x - start) / std::max(width, kTiny)));
}

float quartic_norm(const Vec2& v) {
  const float x2 = v.x * v.x;
  const float y2 = v.y * v.y;
  return std::sqrt(std::sqrt(x2 * x2 + y2 * y2));
}

float superellipse(const Vec2& point, const Vec3& barn, float least_edge) {
  const Vec2 inner = glm::max(Vec2(barn), Vec2(1e-4F));
  const float edge = std::max(std::max(barn.z, least_edge), 1e-4F);
  const Vec2 outer = glm::max(Vec2(barn) + edge, inner * 1.0001F);
  const float n_inner = std::min(quartic_norm(point / inner), 1e6F);
  const float n_outer = quartic_norm(point / outer);
  if (n_inner <= 1.0F) return 1.0F;
  if (!(n_outer < 1.0F)) return 0.0F;
  return 1.0F - ramp_up(0.0F, 1.0F, n_outer * (n_inner - 1.0F) / std::max(n_inner - n_outer, kTiny));
}

float distance_falloff(float r, float reference, float exponent) {
  const float ratio = std::min(r / std::max(std::abs(reference), kTiny), 1e6F);
  return std::exp2(std::clamp(0.5F * exponent * std::log2(2.0F / (1.0F + ratio * ratio)), -40.0F, 40.0F));
}

/// Values by the names in the light's manifest.
class Values {
 public:
  explicit Values(const ParamBlock& block) : block_(&block) {}
  [[nodiscard]] float number(const char* name, float fallback) const {
    const auto param = block_->schema().find(name);
    return param ? block_->scalar(*param) : fallback;
  }
  [[nodiscard]] Vec2 pair(const char* name) const {
    const auto param = block_->schema().find(name);
    return param ? block_->vec2(*param) : Vec2(0.0F);
  }
  [[nodiscard]] Vec3 triple(const char* name, const Vec3& fallback) const {
    const auto param = block_->schema().find(name);
    return param ? block_->vec3(*param) : fallback;
  }

 private:
  const ParamBlock* block_;
};

/// Where a light shines from. A sun does from so far away that its rays cross the scene within a thousandth of a radian
/// of each other.
Vec3 place_of(const Light& light, const SceneFrame& frame) {
  const Values values(light.params);
  if (light.type != "sun") return values.triple("position", Vec3(0.0F));
  const Vec3 down(0.0F, -1.0F, 0.0F);
  return frame.center - kSunDistance * frame.radius * safe_normalize(values.triple("direction", down), down);
}

std::optional<RigLight::Kind> kind_of(const std::string& type) {
  if (type == "cinematic") return RigLight::Kind::kCinematic;
  if (type == "point") return RigLight::Kind::kPoint;
  if (type == "area") return RigLight::Kind::kArea;
  if (type == "sun") return RigLight::Kind::kSun;
  return std::nullopt;
}

}  // namespace

void light_frame(const Vec3& axis, Vec3& right, Vec3& up) {
  const float steepness = 1.0F - (axis.x * axis.x + axis.z * axis.z);
  const float bias = 0.1F * smooth(saturate((steepness - 0.96F) / 0.04F));
  const Vec3 across = Vec3(-axis.z, 0.0F, axis.x) + bias * (Vec3(1.0F, 0.0F, 0.0F) - axis.x * axis);
  right = safe_normalize(across, Vec3(1.0F, 0.0F, 0.0F));
  up = glm::cross(right, axis);
}

Result<RigLight> rig_light(const LightRig& rig, int index, const Softness& softness, const SceneFrame& frame,
                           std::span<const std::string> objects) {
  const Light& source = rig.lights[static_cast<std::size_t>(index)];
  const std::optional<RigLight::Kind> kind = kind_of(source.type);
  if (!kind) {
    return Error{ErrorKind::kStyle, fmt::format("the path tracer has no light of the type \"{}\"", source.type), "",
                 source.name, "it has cinematic, point, area and sun"};
  }
  const Values values(source.params);
  RigLight light;
  light.kind = *kind;
  light.color = values.triple("color", Vec3(1.0F)) * values.number("intensity", 1.0F);
  light.position = place_of(source, frame);
  light.axis = safe_normalize(values.triple("direction", light.axis), light.axis);
  light_frame(light.axis, light.right, light.up);
  light.near_cutoff = values.pair("near_cutoff");
  light.far_cutoff = values.pair("far_cutoff");
  light.falloff_exponent = values.number("falloff_exponent", 2.0F);
  light.falloff_distance = values.number("falloff_distance", 1.0F);
  light.barn = values.triple("barn", Vec3(0.0F));
  light.edge_softness = softness.light_edge;
  light.shadow_density = values.number("shadow_density", 1.0F);
  const float wanted = values.number("shadow_softness", 0.0F);
  light.shadow_softness = std::clamp(std::max(wanted, softness.shadow_angle), 0.0F, kMostSoftness);
  light.shadow_position = light.position;
  if (const Light* shared = rig.shadow_light.empty() ? nullptr : rig.find(rig.shadow_light); shared != nullptr) {
    light.shadow_position = place_of(*shared, frame);
  }
  if (light.kind == RigLight::Kind::kArea) {
    const float side = std::max(std::abs(values.number("size", 1.0F)), kLeastSide * frame.radius);
    light.half_side = 0.5F * side;
    light.position += kPanelLift * frame.radius * light.axis;
  }
  if (!source.objects.empty()) {
    for (const std::string& object : objects) light.unlit.push_back(lights_object(source, object) ? 0 : 1);
  }
  return light;
}

float point_strength(const RigLight& light, const Vec3& position) {
  if (light.kind == RigLight::Kind::kSun) return 1.0F;
  const Vec3 to_light = light.position - position;
  const float r = glm::length(to_light);
  float shape = 0.0F;
  if (light.kind == RigLight::Kind::kPoint) {
    shape = 1.0F - ramp_up(light.far_cutoff.x, light.far_cutoff.y, r);
  } else {
    const Vec3 direction = safe_normalize(to_light, -light.axis);
    const float ahead = -glm::dot(direction, light.axis);
    if (ahead > 1e-4F) {
      const Vec2 tangent = Vec2(-glm::dot(direction, light.right), -glm::dot(direction, light.up)) / ahead;
      shape = superellipse(tangent, light.barn, light.edge_softness);
      shape *= ramp_up(light.near_cutoff.x, light.near_cutoff.y, r);
      shape *= 1.0F - ramp_up(light.far_cutoff.x, light.far_cutoff.y, r);
    }
  }
  return shape * distance_falloff(r, light.falloff_distance, light.falloff_exponent);
}

float RigLight::panel_radiance() const {
  // A white diffuser that faces a far panel at the falloff distance d shows L A / (pi d^2) = 1.
  return static_cast<float>(kPi) * falloff_distance * falloff_distance / std::max(panel_area(), 1e-30F);
}

Vec3 RigLight::panel_point(const Vec2& place) const {
  return position + half_side * ((2.0F * place.x - 1.0F) * right + (2.0F * place.y - 1.0F) * up);
}

float RigLight::meet_panel(const Vec3& origin, const Vec3& direction) const {
  constexpr float kMiss = std::numeric_limits<float>::infinity();
  const float towards = glm::dot(direction, axis);
  if (!(towards < 0.0F)) return kMiss;
  const float t = glm::dot(position - origin, axis) / towards;
  if (!(t > 0.0F)) return kMiss;
  const Vec3 across = origin + t * direction - position;
  return std::abs(glm::dot(across, right)) <= half_side && std::abs(glm::dot(across, up)) <= half_side ? t : kMiss;
}

std::string picture_key(const RigLight& light) {
  const std::array<float, 26> numbers{static_cast<float>(light.kind),
                                      light.position.x,
                                      light.position.y,
                                      light.position.z,
                                      light.axis.x,
                                      light.axis.y,
                                      light.axis.z,
                                      light.near_cutoff.x,
                                      light.near_cutoff.y,
                                      light.far_cutoff.x,
                                      light.far_cutoff.y,
                                      light.falloff_exponent,
                                      light.falloff_distance,
                                      light.barn.x,
                                      light.barn.y,
                                      light.barn.z,
                                      light.edge_softness,
                                      light.shadows ? 1.0F : 0.0F,
                                      light.shadow_density,
                                      light.shadow_softness,
                                      light.shadow_position.x,
                                      light.shadow_position.y,
                                      light.shadow_position.z,
                                      light.half_side};
  std::string key(reinterpret_cast<const char*>(numbers.data()), sizeof(numbers));
  return key.append(light.unlit.data(), light.unlit.size());
}

}  // namespace luminist
