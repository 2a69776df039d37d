#include "surface/outline_hull.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "surface/surface_sides.h"

namespace luminist {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
using DVec3 = glm::dvec3;

double corner_angle(const WeldedMesh& surface, const Triangle& t, std::size_t k) {
  const DVec3 p(surface.positions[t[k]]);
  const DVec3 a = DVec3(surface.positions[t[(k + 1) % 3]]) - p;
  const DVec3 b = DVec3(surface.positions[t[(k + 2) % 3]]) - p;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Unit, or zero where the sum has no direction.
DVec3 unit(const DVec3& sum) {
  const double length = glm::length(sum);
  return length > 1e-9 ? sum / length : DVec3(0.0);
}

/// A unit direction made so long that it moves by 1 along the one of its neighbours that it follows least.
Vec3 mitred(const DVec3& direction, double least_cosine) {
  return Vec3(direction / std::max(least_cosine, 1.0 / static_cast<double>(OutlineHull::kLongest)));
}

std::vector<Vec3> hull_directions(const WeldedMesh& surface, const SurfaceSides& sides) {
  std::vector<DVec3> sums(surface.positions.size(), DVec3(0.0));
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const Triangle& t = surface.triangles[f];
    for (std::size_t k = 0; k < 3; ++k) sums[t[k]] += corner_angle(surface, t, k) * sides.normals[f];
  }
  for (DVec3& sum : sums) sum = unit(sum);
  std::vector<double> least(sums.size(), 1.0);
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    for (const std::uint32_t v : surface.triangles[f]) {
      least[v] = std::min(least[v], glm::dot(sums[v], sides.normals[f]));
    }
  }
  std::vector<Vec3> directions(sums.size());
  for (std::size_t v = 0; v < sums.size(); ++v) directions[v] = mitred(sums[v], least[v]);
  return directions;
}

std::vector<float> hull_widths(const Mesh& mesh, const Texture* mask, const WeldedMesh& surface) {
  std::vector<float> widths(surface.positions.size(), 1.0F);
  const bool masked = mask != nullptr && !mesh.uvs.empty();
  if (mesh.line_widths.empty() && !masked) return widths;
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t corner = surface.corners[f][k];
      float width = mesh.line_widths.empty() ? 1.0F : mesh.line_widths[corner];
      if (masked) width *= std::clamp(mask->red_at(mesh.uvs[corner]), 0.0F, 1.0F);
      float& least = widths[surface.triangles[f][k]];
      least = std::min(least, width);
    }
  }
  return widths;
}

/// A side that only one triangle has, and the direction away from that triangle in its plane.
struct OpenSide {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  DVec3 outward{0.0};
};

/// Whether two triangles have one shading normal at a place that both have.
bool is_round_at(const Mesh& mesh, const WeldedMesh& surface, std::uint32_t place, std::uint32_t a, std::uint32_t b) {
  constexpr float kJoined = 0.98F;  // cosine
  const auto normal = [&](std::uint32_t face) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (surface.triangles[face][k] == place) return mesh.normals[surface.corners[face][k]];
    }
    return Vec3(0.0F);
  };
  return glm::dot(normal(a), normal(b)) > kJoined;
}

/// Borders, and the edges that bend into hull.edges.
std::vector<OpenSide> sort_edges(const Mesh& mesh, const WeldedMesh& surface, const SurfaceSides& sides,
                                 OutlineHull& hull) {
  std::vector<OpenSide> open;
  for (std::uint32_t side = 0; side < sides.across.size(); ++side) {
    const std::uint32_t face = side / 3;
    const std::uint32_t from = surface.triangles[face][side % 3];
    const std::uint32_t to = surface.triangles[face][(side % 3 + 1) % 3];
    const std::uint32_t other = sides.across[side];
    if (other == SurfaceSides::kNone) {
      const DVec3 along = DVec3(surface.positions[to]) - DVec3(surface.positions[from]);
      open.push_back({from, to, unit(glm::cross(along, sides.normals[face]))});
      continue;
    }
    if (other < side) continue;  // seen from there
    auto angle = static_cast<float>(std::abs(sides.turns[side]));
    const auto is_round = [&](std::uint32_t end) { return is_round_at(mesh, surface, end, face, other / 3); };
    if (is_round(from) && is_round(to)) angle *= 0.5F;
    if (angle > OutlineHull::kFlat) hull.edges.push_back({from, to, angle});
  }
  return open;
}

/// Limits every edge by what continues it; a border continues anything.
void join_creases(const std::vector<OpenSide>& borders, std::size_t places, std::vector<OutlineHull::Edge>& edges) {
  constexpr int kFar = 3;  // edges
  for (int round = 0; round < kFar; ++round) {
    std::vector<std::array<float, 2>> sharpest(places, {0.0F, 0.0F});
    const auto add = [&](std::uint32_t place, float angle) {
      auto& [first, second] = sharpest[place];
      second = std::max(second, std::min(first, angle));
      first = std::max(first, angle);
    };
    for (const OpenSide& side : borders) add(side.from, 4.0F), add(side.to, 4.0F);
    for (const OutlineHull::Edge& edge : edges) add(edge.from, edge.angle), add(edge.to, edge.angle);
    for (OutlineHull::Edge& edge : edges) {
      const float own = edge.angle;
      for (const std::uint32_t end : {edge.from, edge.to}) {
        const auto& [first, second] = sharpest[end];
        edge.angle = std::min(edge.angle, first > own ? first : second);
      }
    }
  }
}

/// Adds the edges and the strip along open borders, joined where two sides meet.
void add_border(const Mesh& mesh, const WeldedMesh& surface, const SurfaceSides& neighbours, OutlineHull& hull) {
  const std::vector<OpenSide> sides = sort_edges(mesh, surface, neighbours, hull);
  join_creases(sides, surface.positions.size(), hull.edges);
  std::map<std::uint32_t, DVec3> outward;
  for (const OpenSide& side : sides) {
    for (const std::uint32_t v : {side.from, side.to}) outward.try_emplace(v, 0.0).first->second += side.outward;
  }
  std::map<std::uint32_t, double> least;
  for (auto& [v, sum] : outward) sum = unit(sum);
  for (const OpenSide& side : sides) {
    for (const std::uint32_t v : {side.from, side.to}) {
      double& cosine = least.try_emplace(v, 1.0).first->second;
      cosine = std::min(cosine, glm::dot(outward[v], side.outward));
    }
  }
  std::map<std::uint32_t, std::uint32_t> inner;  // the outer one is the next
  for (const auto& [v, direction] : outward) {
    inner[v] = static_cast<std::uint32_t>(hull.positions.size());
    const float width = hull.widths[v];
    for (const Vec3& step : {Vec3(0.0F), mitred(direction, least[v])}) {
      hull.positions.push_back(surface.positions[v]);
      hull.directions.push_back(step);
      hull.widths.push_back(width);
    }
  }
  for (const OpenSide& side : sides) {
    const std::uint32_t a = inner[side.from];
    const std::uint32_t b = inner[side.to];
    const std::array<Triangle, 4> strip{{{a, b, b + 1}, {a, b + 1, a + 1}, {a, b + 1, b}, {a, a + 1, b + 1}}};
    hull.triangles.insert(hull.triangles.end(), strip.begin(), strip.end());
  }
}

}  // namespace

OutlineHull outline_hull(const Mesh& mesh, const Texture* mask) {
  const WeldedMesh surface = repair(mesh).surface;
  const SurfaceSides sides = sides_of(surface);
  OutlineHull hull;
  hull.positions = surface.positions;
  hull.directions = hull_directions(surface, sides);
  hull.widths = hull_widths(mesh, mask, surface);
  hull.triangles = surface.triangles;
  add_border(mesh, surface, sides, hull);
  return hull;
}

}  // namespace luminist
