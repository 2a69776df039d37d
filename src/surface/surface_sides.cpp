#include "surface/surface_sides.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace luminist {
namespace {

void join_sides(const WeldedMesh& surface, SurfaceSides& sides) {
  using Edge = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // lower end, upper end, side
  std::vector<Edge> edges;
  edges.reserve(3 * surface.triangles.size());
  for (std::uint32_t f = 0; f < surface.triangles.size(); ++f) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = surface.triangles[f][k];
      const std::uint32_t b = surface.triangles[f][(k + 1) % 3];
      edges.emplace_back(std::min(a, b), std::max(a, b), 3 * f + k);
    }
  }
  std::ranges::sort(edges);
  sides.across.assign(edges.size(), SurfaceSides::kNone);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const auto& [lo, hi, side] = edges[i];
    const auto& [other_lo, other_hi, other] = edges[i - 1];
    if (lo == other_lo && hi == other_hi) sides.across[side] = other, sides.across[other] = side;
  }
}

void measure(const WeldedMesh& surface, SurfaceSides& sides) {
  const std::size_t faces = surface.triangles.size();
  sides.normals.resize(faces), sides.areas.resize(faces), sides.lengths.resize(3 * faces);
  for (std::size_t f = 0; f < faces; ++f) {
    std::array<glm::dvec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = glm::dvec3(surface.positions[surface.triangles[f][k]]);
    for (std::size_t k = 0; k < 3; ++k) sides.lengths[3 * f + k] = glm::length(p[(k + 1) % 3] - p[k]);
    const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
    sides.areas[f] = 0.5 * glm::length(cross);
    sides.normals[f] = glm::normalize(cross);
  }
  sides.turns.assign(3 * faces, 0.0);
  for (std::uint32_t s = 0; s < 3 * faces; ++s) {
    const std::uint32_t other = sides.across[s];
    if (other == SurfaceSides::kNone) continue;
    const auto& t = surface.triangles[s / 3];
    const glm::dvec3 along(surface.positions[t[(s % 3 + 1) % 3]] - surface.positions[t[s % 3]]);
    const glm::dvec3 cross = glm::cross(sides.normals[s / 3], sides.normals[other / 3]);
    const double angle = std::atan2(glm::length(cross), glm::dot(sides.normals[s / 3], sides.normals[other / 3]));
    sides.turns[s] = glm::dot(cross, along) >= 0.0 ? angle : -angle;
  }
}

}  // namespace

SurfaceSides sides_of(const WeldedMesh& surface) {
  SurfaceSides sides;
  join_sides(surface, sides);
  measure(surface, sides);
  DisjointSets pieces(surface.triangles.size());
  for (std::uint32_t s = 0; s < sides.across.size(); ++s) {
    if (sides.across[s] != SurfaceSides::kNone) pieces.join(s / 3, sides.across[s] / 3);
  }
  std::uint32_t count = 0;
  std::tie(sides.piece, count) = pieces.numbered();
  sides.piece_areas.assign(count, 0.0);
  for (std::size_t f = 0; f < sides.piece.size(); ++f) sides.piece_areas[sides.piece[f]] += sides.areas[f];
  return sides;
}

SurfaceSides smoothed(const SurfaceSides& sides, double reach) {
  constexpr double kEdge = 0.6;  // radians: a turn by this much lets a third through
  constexpr int kMost = 40;      // passes; each reaches one triangle farther, as a random walk
  SurfaceSides result = sides;
  const double triangles_in_reach = reach * reach * static_cast<double>(sides.areas.size());
  const int passes = std::min(static_cast<int>(triangles_in_reach), kMost);
  if (passes == 0) return result;
  std::vector<glm::dvec3> before;
  for (int pass = 0; pass < passes; ++pass) {
    before = result.normals;
    for (std::uint32_t f = 0; f < before.size(); ++f) {
      glm::dvec3 sum = sides.areas[f] * before[f];
      for (std::uint32_t s = 3 * f; s < 3 * f + 3; ++s) {
        const std::uint32_t other = sides.across[s];
        if (other == SurfaceSides::kNone) continue;
        const double apart = glm::length(before[f] - before[other / 3]) / kEdge;
        sum += sides.areas[other / 3] * std::exp(-apart * apart) * before[other / 3];
      }
      const double length = glm::length(sum);
      if (length > 0.0) result.normals[f] = sum / length;
    }
  }
  for (std::uint32_t s = 0; s < result.turns.size(); ++s) {
    const std::uint32_t other = sides.across[s];
    if (other == SurfaceSides::kNone) continue;
    const double chord = glm::length(result.normals[s / 3] - result.normals[other / 3]);
    result.turns[s] = std::copysign(2.0 * std::asin(std::min(0.5 * chord, 1.0)), sides.turns[s]);
  }
  return result;
}

TangentFrame tangent_frame_of(const glm::dvec3& n) {
  const double sign = std::copysign(1.0, n.z);  // Duff et al. 2017
  const double a = -1.0 / (sign + n.z);
  const double c = n.x * n.y * a;
  return {{1.0 + sign * n.x * n.x * a, sign * c, -sign * n.x}, {c, sign + n.y * n.y * a, -n.y}};
}

glm::dvec3 transported(const glm::dvec3& tangent, const glm::dvec3& from, const glm::dvec3& to) {
  constexpr double kOpposite = 1e-9;  // of 1 + cosine: any rotation by pi is as good as another
  const double cosine = glm::dot(from, to);
  if (1.0 + cosine < kOpposite) return tangent;
  const glm::dvec3 axis = glm::cross(from, to);
  return tangent * cosine + glm::cross(axis, tangent) + axis * (glm::dot(axis, tangent) / (1.0 + cosine));
}

}  // namespace luminist
