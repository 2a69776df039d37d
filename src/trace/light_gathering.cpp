#include "trace/light_gathering.h"

#include <cmath>
#include <utility>

#include "base/check.h"
#include "trace/mesh_emitters.h"
#include "trace/panel_view.h"

namespace luminist {
namespace {

/// Light that arrives at a vertex and is reflected towards the eye, if nothing stands between.
struct Arrival {
  Vec3 radiance{0.0F};
  Segment segment;  ///< from the light
};

/// A point of a disc of radius `softness` times the distance, that faces the vertex: a lamp of a size.
Vec3 lamp_point(const RigLight& light, const PathVertex& vertex) {
  if (!(light.shadow_softness > 0.0F)) return light.shadow_position;
  const Vec3 way = vertex.position - light.shadow_position;
  const float distance = glm::length(way);
  if (!(distance > 0.0F)) return light.shadow_position;
  Vec3 t;
  Vec3 b;
  tangent_frame(way / distance, t, b);
  const float radius = light.shadow_softness * distance * std::sqrt(vertex.place.x);
  const float angle = 2.0F * kPiF * vertex.place.y;
  return light.shadow_position + radius * (std::cos(angle) * t + std::sin(angle) * b);
}

bool arrives_from_point(const RigLight& light, const PathVertex& vertex, Arrival& arrival) {
  const Vec3 to_light = light.position - vertex.position;
  const float distance = glm::length(to_light);
  if (!(distance > 0.0F)) return false;
  const Vec3 direction = to_light / distance;
  if (!(glm::dot(direction, vertex.surface.normal) > 0.0F)) return false;
  const float strength = point_strength(light, vertex.position);
  if (!(strength > 0.0F)) return false;
  // A white diffuser shows the light's colour, so pi times that arrives.
  arrival.radiance = vertex.throughput * evaluate(vertex.surface, direction).value * (kPiF * strength);
  arrival.segment = {lamp_point(light, vertex), vertex.position};
  return true;
}

bool arrives_from_panel(const RigLight& light, const PathVertex& vertex, Arrival& arrival) {
  const Vec3 way = light.position - vertex.position;
  const Vec3& normal = vertex.surface.normal;
  const float reach =
      light.half_side * (std::abs(glm::dot(light.right, normal)) + std::abs(glm::dot(light.up, normal)));
  if (!(glm::dot(way, light.axis) < 0.0F) || !(glm::dot(way, normal) + reach > 0.0F)) return false;
  const PanelView view(light, vertex.position);
  const Vec3 point = view.point(vertex.place);
  const Vec3 to_light = point - vertex.position;
  const float square = glm::dot(to_light, to_light);
  if (!(square > 0.0F)) return false;
  const Vec3 direction = to_light / std::sqrt(square);
  const float cosine = -glm::dot(direction, light.axis);
  if (!(cosine > 0.0F) || !(glm::dot(direction, normal) > 0.0F)) return false;
  const Scattered scattered = evaluate(vertex.surface, direction);
  const float pdf = view.pdf(square, cosine);
  const float weight = mis_weight(pdf, scattered.pdf) / pdf;
  arrival.radiance = vertex.throughput * scattered.value * (weight * light.panel_radiance());
  arrival.segment = {point, vertex.position};
  return true;
}

/// What the way on from a vertex sees of a panel.
Vec3 seen_panel(const RigLight& light, const PathVertex& vertex) {
  if (vertex.way_length == PathVertex::kNoWay) return Vec3(0.0F);
  const float distance = light.meet_panel(vertex.position, vertex.way);
  if (!(distance < vertex.way_length)) return Vec3(0.0F);
  float weight = 1.0F;
  if (vertex.way_pdf > 0.0F) {
    const float cosine = -glm::dot(vertex.way, light.axis);
    weight = mis_weight(vertex.way_pdf, PanelView(light, vertex.position).pdf(distance * distance, cosine));
  }
  return vertex.way_throughput * (weight * light.panel_radiance());
}

}  // namespace

std::size_t gather_light(const RayScene& rays, const LightPaths& paths, std::size_t first, std::size_t count,
                         const RigLight& light, std::span<Vec3> sums, std::span<Vec3> later) {
  LUM_CHECK(first + count <= paths.size() && sums.size() == count, "one sum per path");
  LUM_CHECK(later.empty() || later.size() == count, "one sum per path");
  const bool panel = light.kind == RigLight::Kind::kArea;
  std::size_t asked = 0;
  for (std::size_t path = 0; path < count; ++path) {
    bool spread = false;  // at a vertex before
    for (std::uint32_t i = paths.first[first + path]; i < paths.first[first + path + 1]; ++i) {
      const PathVertex& vertex = paths.vertices[i];
      const bool is_later = std::exchange(spread, spread || vertex.way_pdf > 0.0F);
      Arrival arrival;
      Vec3 added(0.0F);
      if (!light.lights(vertex.object)) continue;
      if (vertex.scatters &&
          (panel ? arrives_from_panel(light, vertex, arrival) : arrives_from_point(light, vertex, arrival)) &&
          arrival.radiance != Vec3(0.0F)) {
        const bool blocked = light.shadows && rays.blocked(arrival.segment);
        added = blocked ? (1.0F - light.shadow_density) * arrival.radiance : arrival.radiance;
        asked += light.shadows ? 1 : 0;
      }
      if (panel) added += seen_panel(light, vertex);
      sums[path] += added;
      if (is_later && !later.empty()) later[path] += added;
    }
  }
  return asked;
}

}  // namespace luminist
