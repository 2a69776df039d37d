#include "explore/light_place.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "solve/aim_map.h"

namespace luminist {
namespace {

constexpr double kOctaveShare = 0.125;
const Vec3 kDown(0.0F, -1.0F, 0.0F);

}  // namespace

std::optional<LightPlace> light_place(const Light& light, const Vec3& seen_from) {
  const std::optional<int> position = light.params.schema().by_role("position");
  const std::optional<int> direction = light.params.schema().by_role("direction");
  if (position) {
    const Vec3 way = light.params.vec3(*position) - seen_from;
    const double distance = std::max(glm::length(way), 1e-6F);
    return LightPlace{unit_or(way, -kDown), std::log2(distance)};
  }
  if (direction) return LightPlace{-unit_or(light.params.vec3(*direction), kDown), 0.0};
  return std::nullopt;
}

double place_difference(const std::optional<LightPlace>& a, const std::optional<LightPlace>& b) {
  if (!a || !b) return a || b ? 1.0 : 0.0;
  const double chord = 0.5 * glm::distance(a->way, b->way);
  return std::min(1.0, std::hypot(chord, kOctaveShare * (a->octaves - b->octaves)));
}

Vec3 aim_point(const Light& light, const SceneFrame& frame, const Vec3& focus) {
  const std::optional<int> position = light.params.schema().by_role("position");
  const std::optional<int> direction = light.params.schema().by_role("direction");
  if (!position || !direction) return focus;
  const Vec3 at = light.params.vec3(*position);
  const Vec3 way = unit_or(light.params.vec3(*direction), kDown);
  return at + std::max(glm::dot(focus - at, way), 0.25F * frame.radius) * way;
}

void move_light(Light& light, const Vec3& position, const Vec3& aim, const SceneFrame& frame) {
  const std::optional<int> place = light.params.schema().by_role("position");
  const std::optional<int> direction = light.params.schema().by_role("direction");
  LUM_CHECK(place.has_value(), "the light has a position");
  const float before = glm::distance(light.params.vec3(*place), aim);
  const float now = glm::distance(position, aim);
  light.params.set_vec3(*place, position);
  const float least = 1e-4F * frame.radius;
  if (!(before > least) || !(now > least)) return;
  if (direction) light.params.set_vec3(*direction, (aim - position) / now);
  keep_footprint(light.params, frame, before, now);
}

}  // namespace luminist
