#include "rig/constraint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/ext/matrix_double3x3.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/matrix.hpp>

#include "params/param_text.h"
#include "rig/light_rig.h"

namespace luminist {
namespace {

using DVec3 = glm::dvec3;
using DMat3 = glm::dmat3;

constexpr double kRounding = 3e-7;  // of a length: a place stored in floats is off by a third of that

std::optional<int> position_of(const Light& light) {
  const std::optional<int> param = light.params.schema().by_role("position");
  return param && light.params.schema()[*param].components() == 3 ? param : std::nullopt;
}

std::optional<int> color_of(const Light& light) {
  const std::optional<int> param = light.params.schema().by_role("color");
  return param && light.params.schema()[*param].type == ParamType::kColor ? param : std::nullopt;
}

DVec3 reflected(const DVec3& vector, const DVec3& unit_normal) {
  return vector - 2.0 * glm::dot(vector, unit_normal) * unit_normal;
}

/// Where a light may stand: on a plane, at a distance, or both.
class Stand {
 public:
  Stand(const LightRig& rig, const Light& light) {
    for (const Constraint& constraint : rig.constraints) {
      if (constraint.light != light.name) continue;
      if (const auto* on = std::get_if<OnPlane>(&constraint.rule)) plane_ = &on->plane;
      if (const auto* at = std::get_if<AtDistance>(&constraint.rule)) sphere_ = at;
    }
    if (plane_ != nullptr) normal_ = glm::normalize(DVec3(plane_->normal));
  }

  [[nodiscard]] bool anywhere() const { return plane_ == nullptr && sphere_ == nullptr; }

  [[nodiscard]] bool allows(const DVec3& place) const {
    const double length = glm::length(place);
    if (plane_ != nullptr && !(std::abs(gap(place)) <= kRounding * std::max(length, glm::length(DVec3(plane_->point)))))
      return false;
    if (sphere_ == nullptr) return true;
    const DVec3 from(sphere_->from);
    return std::abs(glm::length(place - from) - sphere_->distance) <= kRounding * (length + glm::length(from));
  }

  /// The nearest allowed place, going only where `ways` (an orthogonal projector) leads; nothing if there is none.
  /// back: the way to go from the centre of the sphere.
  [[nodiscard]] std::optional<DVec3> nearest(DVec3 place, DMat3 ways, const DVec3& back) const {
    if (plane_ != nullptr) {
      const DVec3 along = ways * normal_;
      const double reach = glm::dot(along, along);
      if (reach > 1e-6) {
        place -= gap(place) / reach * along;
        ways -= glm::outerProduct(along, along) / reach;
      }
    }
    if (sphere_ != nullptr) {
      const DVec3 offset = place - DVec3(sphere_->from);
      DVec3 way = ways * offset;
      const DVec3 fixed = offset - way;
      const double radius2 = static_cast<double>(sphere_->distance) * sphere_->distance - glm::dot(fixed, fixed);
      if (!(glm::length(way) > kRounding * sphere_->distance)) way = ways * back;
      for (int axis = 0; axis < 3 && !(glm::length(way) > 1e-3); ++axis) way = ways[axis];
      if (radius2 < 0.0 || !(glm::length(way) > 0.0)) return std::nullopt;
      place = DVec3(sphere_->from) + fixed + std::sqrt(radius2) * glm::normalize(way);
    }
    const bool there = allows(DVec3(Vec3(place)));
    return there ? std::optional(place) : std::nullopt;
  }

 private:
  [[nodiscard]] double gap(const DVec3& place) const { return glm::dot(place - DVec3(plane_->point), normal_); }

  const Plane* plane_ = nullptr;
  const AtDistance* sphere_ = nullptr;
  DVec3 normal_{0.0};
};

void put_in_place(const LightRig& rig, Light& light) {
  const std::optional<int> position = position_of(light);
  const Stand stand(rig, light);
  if (stand.anywhere() || !position) return;
  const Vec3 stored = light.params.vec3(*position);
  if (!is_finite(stored) || stand.allows(DVec3(stored))) return;
  const std::optional<int> direction = light.params.schema().by_role("direction");
  const DVec3 back = direction ? -DVec3(light.params.vec3(*direction)) : DVec3(0.0, 1.0, 0.0);
  DMat3 unlocked(1.0);
  const int first = light.params.schema()[*position].first_dof;
  DMat3 within(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    if (light.params.limits(first + axis) != nullptr) within[axis][axis] = unlocked[axis][axis] = 0.0;
    if (light.params.locked_by_hand(first + axis)) unlocked[axis][axis] = 0.0;
  }
  auto place = stand.nearest(DVec3(stored), unlocked, back);
  if (!place) place = stand.nearest(DVec3(stored), within, back);
  if (place) light.params.set_vec3(*position, Vec3(*place));
}

/// A dark light stays dark, whatever the range of its colour: it waits for paint.
void hold_between(const Between& range, Light& light) {
  const auto numbers = limited_numbers(light, range.param);
  if (!numbers || !(range.low < range.high)) return;
  const bool dark = color_of(light) == numbers->param && light.params.vec3(numbers->param) == Vec3(0.0F);
  for (int c = numbers->first; c < numbers->first + numbers->count; ++c) {
    light.params.set_limits(light.params.schema()[numbers->param].first_dof + c, {range.low, range.high});
    if (dark) continue;
    const float value = static_cast<float>(light.params.get(numbers->param, c));
    if (value < range.low) light.params.set(numbers->param, c, range.low);
    if (value > range.high) light.params.set(numbers->param, c, range.high);
  }
}

void mirror(const Light& leader, const Plane& plane, Light& light) {
  ParamBlock& params = light.params;
  const ParamSchema& schema = params.schema();
  if (light.type != leader.type || schema.dofs() != leader.params.schema().dofs()) return;
  const DVec3 normal = glm::normalize(DVec3(plane.normal));
  for (int param = 0; param < schema.size(); ++param) {
    const bool place = schema[param].role == "position" && schema[param].components() == 3;
    if (place || schema[param].type == ParamType::kDirection) {
      const DVec3 origin = place ? DVec3(plane.point) : DVec3(0.0);
      params.set_vec3(param, Vec3(origin + reflected(DVec3(leader.params.vec3(param)) - origin, normal)));
    } else {
      for (int c = 0; c < schema[param].components(); ++c) params.set(param, c, leader.params.get(param, c));
    }
  }
  params.set_param_following(-1, true);
}

void copy_color(const Light& leader, float factor, Light& light) {
  const std::optional<int> from = color_of(leader);
  const std::optional<int> to = color_of(light);
  if (!from || !to) return;
  light.params.set_vec3(*to, factor * leader.params.vec3(*from));
  light.params.set_param_following(*to, true);
}

/// A light after the one that it follows; `kept` says who is done.
void keep(LightRig& rig, Light& light, std::vector<bool>& kept) {
  const auto index = static_cast<std::size_t>(&light - rig.lights.data());
  if (kept[index]) return;
  kept[index] = true;
  for (const Constraint& constraint : rig.constraints) {
    const auto* range = std::get_if<Between>(&constraint.rule);
    if (range != nullptr && constraint.light == light.name) hold_between(*range, light);
  }
  put_in_place(rig, light);
  for (const Constraint& constraint : rig.constraints) {
    const std::string* name = leader(constraint);
    if (constraint.light != light.name || name == nullptr) continue;
    Light* followed = rig.find(*name);
    if (followed == nullptr || followed == &light) continue;
    keep(rig, *followed, kept);
    if (const auto* image = std::get_if<MirrorOf>(&constraint.rule)) mirror(*followed, image->plane, light);
    if (const auto* same = std::get_if<SameColor>(&constraint.rule)) copy_color(*followed, same->factor, light);
  }
}

}  // namespace

const char* rule_name(const Constraint& constraint) {
  return kRuleNames[constraint.rule.index()];
}

bool same_kind(const Constraint& a, const Constraint& b) {
  if (a.light != b.light || a.rule.index() != b.rule.index()) return false;
  const auto* range = std::get_if<Between>(&a.rule);
  return range == nullptr || range->param == std::get<Between>(b.rule).param;
}

std::optional<LimitedNumbers> limited_numbers(const Light& light, std::string_view param) {
  const ParamSchema& schema = light.params.schema();
  const auto whole = schema.find(param.substr(0, param.find('.')));
  if (!whole) return std::nullopt;
  const ParamSpec& spec = schema[*whole];
  if (spec.type == ParamType::kDirection || spec.dofs() == 0) return std::nullopt;
  if (param == spec.name) return LimitedNumbers{*whole, 0, spec.components()};
  for (int c = 0; c < spec.components(); ++c) {
    if (param == dof_name(spec, c)) return LimitedNumbers{*whole, c, 1};
  }
  return std::nullopt;
}

const std::string* leader(const Constraint& constraint) {
  if (const auto* image = std::get_if<MirrorOf>(&constraint.rule)) return &image->light;
  if (const auto* same = std::get_if<SameColor>(&constraint.rule)) return &same->light;
  return nullptr;
}

void keep_constraints(LightRig& rig) {
  for (Light& light : rig.lights) {
    light.params.set_param_following(-1, false);
    light.params.clear_limits();
  }
  if (rig.constraints.empty()) return;
  std::vector<bool> kept(rig.lights.size(), false);
  for (Light& light : rig.lights) keep(rig, light, kept);
}

std::vector<Tie> tied_to(const LightRig& rig, std::size_t light, int param) {
  std::vector<Tie> ties{{light, 1.0F}};
  const bool color = color_of(rig.lights[light]) == param;
  for (std::size_t i = 0; i < ties.size(); ++i) {
    for (const Constraint& constraint : rig.constraints) {
      const std::string* name = leader(constraint);
      const auto* same = std::get_if<SameColor>(&constraint.rule);
      if (name == nullptr || *name != rig.lights[ties[i].light].name || (same != nullptr && !color)) continue;
      const Light* follower = rig.find(constraint.light);
      if (follower == nullptr) continue;
      const auto index = static_cast<std::size_t>(follower - rig.lights.data());
      const bool known = std::any_of(ties.begin(), ties.end(), [&](const Tie& tie) { return tie.light == index; });
      if (!known) ties.push_back({index, ties[i].factor * (same != nullptr ? same->factor : 1.0F)});
    }
  }
  return ties;
}

bool may_change(const LightRig& rig, const Light& light) {
  const Light* at = &light;
  for (std::size_t steps = 0; at != nullptr && steps <= rig.lights.size(); ++steps) {
    for (int dof = 0; dof < at->params.schema().dofs(); ++dof) {
      if (!at->params.locked(dof)) return true;
    }
    const auto follows = std::find_if(
        rig.constraints.begin(), rig.constraints.end(),
        [&](const Constraint& constraint) { return constraint.light == at->name && leader(constraint) != nullptr; });
    at = follows == rig.constraints.end() ? nullptr : rig.find(*leader(*follows));
  }
  return false;
}

std::vector<Constraint> remove_light(LightRig& rig, const std::string& name) {
  const Light* light = rig.find(name);
  LUM_CHECK(light != nullptr, "the light is in the rig");
  std::vector<Constraint> gone;
  std::erase_if(rig.constraints, [&](const Constraint& constraint) {
    const std::string* followed = leader(constraint);
    if (constraint.light != name && (followed == nullptr || *followed != name)) return false;
    gone.push_back(constraint);
    return true;
  });
  if (rig.shadow_light == name) rig.shadow_light.clear();
  std::erase_if(rig.keys, [&](const KeyTrack& track) { return track.light == name; });
  rig.lights.erase(rig.lights.begin() + (light - rig.lights.data()));
  keep_constraints(rig);
  return gone;
}

}  // namespace luminist
