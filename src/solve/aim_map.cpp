#include "solve/aim_map.h"

#include <algorithm>

namespace luminist {
namespace {

UnitMap units_of(const ParamState& state, const SceneFrame& frame) {
  const std::vector<const ParamBlock*> blocks = state.blocks();
  return UnitMap::create(blocks, frame);
}

bool any_free(const ParamBlock& params, int param) {
  const ParamSpec& spec = params.schema()[param];
  for (int k = 0; k < spec.dofs(); ++k) {
    if (!params.locked(spec.first_dof + k)) return true;
  }
  return false;
}

bool all_free(const ParamBlock& params, int param) {
  const ParamSpec& spec = params.schema()[param];
  for (int k = 0; k < spec.dofs(); ++k) {
    if (params.locked(spec.first_dof + k)) return false;
  }
  return true;
}

}  // namespace

Vec3 rotate_between(const Vec3& a, const Vec3& b, const Vec3& v) {
  const Vec3 axis = glm::cross(a, b);
  const float cosine = glm::dot(a, b);
  if (cosine < -0.9999F) return v;
  return v + glm::cross(axis, v) + glm::cross(axis, glm::cross(axis, v)) / (1.0F + cosine);
}

ParamState in_range(const ParamState& state, const SceneFrame& frame, const Vec3& focus) {
  const std::vector<const ParamBlock*> blocks = state.blocks();
  if (penalty(units_of(state, frame).to_unit(blocks)) <= 0.0) return state;
  const AimMap map(state, frame, focus);
  return map.at(map.origin());
}

AimMap::AimMap(const ParamState& state, const SceneFrame& frame, const Vec3& focus)
    : frame_(frame), base_(state), units_(units_of(state, frame)) {
  const std::vector<const ParamBlock*> blocks = state.blocks();
  origin_ = units_.to_unit(blocks);
  for (double& x : origin_) x = x >= 0.0 ? std::min(x, 1.0) : 0.0;
  for (std::size_t i = 0; i < state.rig.lights.size(); ++i) {
    const ParamBlock& params = state.rig.lights[i].params;
    const std::optional<int> position = params.schema().by_role("position");
    const std::optional<int> direction = params.schema().by_role("direction");
    if (!position || !direction || params.schema()[*direction].type != ParamType::kDirection) continue;
    if (!any_free(params, *position) || !all_free(params, *direction)) continue;
    AimedLight light{i, *position, *direction, params.vec3(*position), params.vec3(*direction), 1.0F};
    const float length = glm::length(light.way);
    if (!(length > 0.0F)) continue;
    light.way /= length;
    light.distance = std::max(glm::dot(focus - light.place, light.way), 0.25F * frame.radius);
    aimed_.push_back(light);
  }
}

void keep_footprint(ParamBlock& params, const SceneFrame& frame, float before, float now) {
  for (int param = 0; param < params.schema().size(); ++param) {
    const ParamSpec& spec = params.schema()[param];
    const bool shape = spec.role == "shape";
    const bool reference = spec.role == "falloff_distance";
    const bool cutoff = spec.role == "cutoff";
    for (int c = 0; c < spec.dofs(); ++c) {
      if (params.locked(spec.first_dof + c) || (cutoff && c > 0) || !(shape || reference || cutoff)) continue;
      const double value = params.get(param, c);
      const double wanted = shape ? value * before / now : reference ? value * now / before : value + now - before;
      const auto [low, high] = params.range(param, c, frame);
      // A value that was out of its range may go no farther.
      params.set(param, c, std::clamp(wanted, std::min(low, value), std::max(high, value)));
    }
  }
}

ParamState AimMap::at(std::span<const double> x) const {
  ParamState state = base_;
  const std::vector<ParamBlock*> blocks = state.blocks();
  units_.from_unit(x, blocks);
  keep_constraints(state.rig);  // a light aims from where it may stand
  for (const AimedLight& light : aimed_) {
    ParamBlock& params = state.rig.lights[light.light].params;
    const Vec3 to_aim = light.place + light.distance * light.way - params.vec3(light.position);
    const float length = glm::length(to_aim);
    if (!(length > 1e-3F * light.distance)) continue;
    const Vec3 way = rotate_between(light.way, to_aim / length, params.vec3(light.direction));
    params.set_vec3(light.direction, glm::normalize(way));
    if (length != light.distance) keep_footprint(params, frame_, light.distance, length);
  }
  if (!state.rig.constraints.empty()) keep_constraints(state.rig);  // what follows the aimed ones
  return state;
}

}  // namespace luminist
