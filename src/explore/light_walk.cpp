#include "explore/light_walk.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/check.h"
#include "solve/aim_map.h"

namespace luminist {
namespace {

constexpr double kOctaveShare = 0.125;  // of a doubled distance: without falloff that hardly shows

/// Parameters that say where a light is and what it shines on.
struct PlaceParams {
  std::optional<int> position;
  std::optional<int> direction;
};

PlaceParams place_params(const Light& light) {
  const ParamSchema& schema = light.params.schema();
  return {schema.by_role("position"), schema.by_role("direction")};
}

Vec3 unit_or(const Vec3& v, const Vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0.0F && std::isfinite(length) ? v / length : otherwise;
}

bool same_param(const ParamBlock& a, const ParamBlock& b, int param) {
  for (int c = 0; c < a.schema()[param].components(); ++c) {
    if (a.get(param, c) != b.get(param, c)) return false;
  }
  return true;
}

void take_param(ParamBlock& to, const ParamBlock& from, int param) {
  for (int c = 0; c < to.schema()[param].components(); ++c) to.set(param, c, from.get(param, c));
}

double place_difference(const Vec3& a, const Vec3& b, const SceneFrame& frame, const Vec3& focus) {
  const float least = 0.01F * frame.radius;
  const Vec3 up(0.0F, 1.0F, 0.0F);
  const double chord = 0.5 * glm::distance(unit_or(a - focus, up), unit_or(b - focus, up));
  const double near = std::max(least, glm::distance(a, focus));
  const double far = std::max(least, glm::distance(b, focus));
  return std::min(1.0, std::hypot(chord, kOctaveShare * std::log2(far / near)));
}

double color_difference(const Vec3& a, const Vec3& b) {
  const float sum = glm::length(a) + glm::length(b);
  return sum > 0.0F ? glm::distance(a, b) / sum : 0.0;
}

/// The largest of the components, in unit coordinates; of a direction half the chord.
double param_difference(const ParamBlock& a, const ParamBlock& b, int param, const SceneFrame& frame) {
  const ParamSpec& spec = a.schema()[param];
  if (spec.type == ParamType::kDirection) return 0.5 * glm::distance(a.vec3(param), b.vec3(param));
  double most = 0.0;
  for (int c = 0; c < spec.components(); ++c) {
    const auto i = static_cast<std::size_t>(c);
    const double low = spec.range_min.empty() ? 0.0 : spec.stored(c, spec.range_min[i], frame);
    const double high = spec.range_max.empty() ? 1.0 : spec.stored(c, spec.range_max[i], frame);
    double difference = std::abs(a.get(param, c) - b.get(param, c)) / (high - low);
    if (spec.scale == ParamScale::kLog && a.get(param, c) > 0.0 && b.get(param, c) > 0.0) {
      difference = std::abs(std::log(a.get(param, c) / b.get(param, c)) / std::log(high / low));
    }
    most = std::max(most, difference);
  }
  return most;
}

/// Takes over all but place and colour.
double take_beam(Light& light, const Light& to, const SceneFrame& frame, const Vec3& focus) {
  const PlaceParams place = place_params(light);
  const std::optional<int> color = light.params.schema().by_role("color");
  const double aims = glm::distance(aim_point(light, frame, focus), aim_point(to, frame, focus)) / frame.radius;
  double most = 0.0;
  for (int param = 0; param < light.params.schema().size(); ++param) {
    if (param == color) continue;
    const bool aimed = place.position && param == place.direction;  // the aim says it
    if (!aimed) most = std::max(most, param_difference(light.params, to.params, param, frame));
    take_param(light.params, to.params, param);
  }
  return std::min(1.0, std::hypot(aims, most));
}

}  // namespace

Vec3 aim_point(const Light& light, const SceneFrame& frame, const Vec3& focus) {
  const PlaceParams place = place_params(light);
  if (!place.position || !place.direction) return focus;
  const Vec3 at = light.params.vec3(*place.position);
  const Vec3 way = unit_or(light.params.vec3(*place.direction), Vec3(0.0F, -1.0F, 0.0F));
  return at + std::max(glm::dot(focus - at, way), 0.25F * frame.radius) * way;
}

void move_light(Light& light, const Vec3& position, const Vec3& aim, const SceneFrame& frame) {
  const PlaceParams place = place_params(light);
  LUM_CHECK(place.position.has_value(), "the light has a place");
  const float before = glm::distance(light.params.vec3(*place.position), aim);
  const float now = glm::distance(position, aim);
  light.params.set_vec3(*place.position, position);
  const float least = 1e-4F * frame.radius;
  if (!(before > least) || !(now > least)) return;
  if (place.direction) light.params.set_vec3(*place.direction, (aim - position) / now);
  keep_footprint(light.params, frame, before, now);
}

std::vector<WalkStep> light_walk(const Light& from, const Light& to, const SceneFrame& frame, const Vec3& focus) {
  LUM_CHECK(from.type == to.type, "only lights of one type turn into each other");
  std::vector<WalkStep> walk;
  Light light = from;
  const PlaceParams place = place_params(from);
  if (place.position && !same_param(light.params, to.params, *place.position)) {
    const Vec3 target = to.params.vec3(*place.position);
    const double difference = place_difference(light.params.vec3(*place.position), target, frame, focus);
    move_light(light, target, aim_point(light, frame, focus), frame);
    walk.push_back({LightAspect::kPlace, difference, light});
  }
  const ParamBlock before = light.params;
  const double beams = take_beam(light, to, frame, focus);
  if (!light.params.same_values(before)) walk.push_back({LightAspect::kBeam, beams, light});
  const std::optional<int> color = from.params.schema().by_role("color");
  if (color && !same_param(light.params, to.params, *color)) {
    const double difference = color_difference(light.params.vec3(*color), to.params.vec3(*color));
    take_param(light.params, to.params, *color);
    walk.push_back({LightAspect::kColor, difference, light});
  }
  return walk;
}

double walk_length(const std::vector<WalkStep>& walk) {
  double sum = 0.0;
  for (const WalkStep& step : walk) sum += step.difference * step.difference;
  return std::sqrt(sum);
}

}  // namespace luminist
