// Lights of a glTF scene as lights of a rig (rig/light_rig.h).
#include <algorithm>
#include <cmath>

#include "rig/light_rig.h"

namespace luminist {
namespace {

constexpr float kWidestAngle = 1.4F;      ///< radians; the tangent of a half sphere is infinite
constexpr float kFadeStart = 0.7F;        ///< of a light's range; KHR_lights_punctual is at 3/4 strength there
constexpr float kNearestDistance = 0.1F;  ///< scene radii

/// The last parameter with a role: of two cutoffs the far one.
std::optional<int> last_by_role(const ParamSchema& schema, std::string_view role) {
  for (int param = schema.size() - 1; param >= 0; --param) {
    if (schema[param].role == role) return param;
  }
  return std::nullopt;
}

void set_numbers(ParamBlock& block, std::optional<int> param, const Vec3& value) {
  if (!param) return;
  for (int c = 0; c < std::min(3, block.schema()[*param].components()); ++c) {
    block.set(*param, c, static_cast<double>(value[c]));
  }
}

void set_by_role(ParamBlock& block, std::string_view role, const Vec3& value) {
  set_numbers(block, block.schema().by_role(role), value);
}

/// Names may hold anything in glTF; paths of parameters may not.
std::string usable_name(const PunctualLight& light) {
  std::string name = light.name.substr(0, 200);
  for (char& c : name) {
    if (!is_light_name(std::string_view(&c, 1))) c = '_';
  }
  if (!name.empty()) return name;
  if (light.kind == PunctualLight::Kind::kSun) return "sun";
  return light.kind == PunctualLight::Kind::kSpot ? "spot" : "point";
}

/// Falloff and colour such that a white diffuser facing the light at distance d has the radiance I / (pi d^2).
void set_intensity(ParamBlock& block, const PunctualLight& light, const SceneFrame& frame) {
  const float distance = std::max(glm::length(light.position - frame.center), kNearestDistance * frame.radius);
  set_by_role(block, "falloff", Vec3(2.0F));
  set_by_role(block, "falloff_distance", Vec3(distance));
  set_by_role(block, "color", light.color * (light.intensity / (kPiF * distance * distance)));
  const auto cutoff = last_by_role(block.schema(), "cutoff");
  if (!cutoff) return;
  if (light.range > 0.0F) {
    set_numbers(block, cutoff, Vec3(kFadeStart * light.range, (1.0F - kFadeStart) * light.range, 0.0F));
  } else {
    // A light without a range reaches through the whole scene.
    const double reach = static_cast<double>(distance + 2.0F * frame.radius);
    block.set(*cutoff, 0, std::max(block.get(*cutoff, 0), reach));
  }
}

void set_spot(ParamBlock& block, const PunctualLight& light) {
  const float outer = std::tan(std::clamp(light.outer_angle, 0.0F, kWidestAngle));
  const float inner = std::min(outer, std::tan(std::clamp(light.inner_angle, 0.0F, kWidestAngle)));
  // A barn door is full inside its half sizes and fades out over the edge.
  set_by_role(block, "shape", Vec3(inner, inner, outer - inner));
}

const char* type_of(PunctualLight::Kind kind) {
  if (kind == PunctualLight::Kind::kSun) return "sun";
  return kind == PunctualLight::Kind::kPoint ? "point" : "cinematic";
}

}  // namespace

Result<std::vector<Light>> from_punctual(const std::vector<PunctualLight>& lights, const LightTypes& types,
                                         const SceneFrame& frame) {
  LightRig rig = empty_rig(types, frame);
  for (const PunctualLight& light : lights) {
    const std::string name = rig.unused_name(usable_name(light));
    LUM_TRY(Light made, make_light(types, type_of(light.kind), name, frame));
    const Vec3 direction = unit_direction(light.direction).value_or(Vec3(0.0F, 0.0F, -1.0F));
    set_by_role(made.params, "direction", direction);
    if (light.kind == PunctualLight::Kind::kSun) {
      set_by_role(made.params, "color", light.color * (light.intensity / kPiF));
    } else {
      set_by_role(made.params, "position", light.position);
      set_intensity(made.params, light, frame);
    }
    if (light.kind == PunctualLight::Kind::kSpot) set_spot(made.params, light);
    rig.lights.push_back(std::move(made));
  }
  return std::move(rig.lights);
}

bool follow_scene(LightRig& rig, const std::vector<Light>& before, const std::vector<Light>& after) {
  bool moved = false;
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
    Light* light = rig.find(before[i].name);
    if (light == nullptr || light->type != before[i].type || before[i].type != after[i].type) continue;
    const ParamSchema& schema = light->params.schema();
    std::vector<int> places;
    bool there = true;
    for (const char* role : {"position", "direction"}) {
      const auto param = schema.by_role(role);
      if (!param) continue;
      places.push_back(*param);
      there &= light->params.vec3(*param) == before[i].params.vec3(*param);
      there &= std::none_of(rig.keys.begin(), rig.keys.end(), [&](const KeyTrack& track) {
        return track.light == light->name && track.param == schema[*param].name;
      });
    }
    for (const int param : places) {
      if (!there || light->params.vec3(param) == after[i].params.vec3(param)) continue;
      set_numbers(light->params, param, after[i].params.vec3(param));
      moved = true;
    }
  }
  return moved;
}

}  // namespace luminist
