#include "surface/shadow_caster.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "surface/repair.h"
#include "surface/surface_sides.h"

namespace luminist {
namespace {

constexpr double kLeastHole = 0.01;  // of a piece's area
constexpr float kSlackOfSides = 0.05F;
constexpr float kMostSlack = 0.005F;  // of the radius

/// Of every piece, how much its triangles face along the mesh's normals: below zero it is wound the other way.
std::vector<double> agreements(const Mesh& mesh, const WeldedMesh& surface, const SurfaceSides& sides) {
  std::vector<double> sums(sides.piece_areas.size(), 0.0);
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    Vec3 normal(0.0F);
    for (const std::uint32_t corner : surface.corners[f]) normal += mesh.normals[corner];
    sums[sides.piece[f]] += sides.areas[f] * glm::dot(sides.normals[f], glm::dvec3(normal));
  }
  return sums;
}

/// The most area that a border as long as all of a piece's could enclose.
std::vector<double> holes(const SurfaceSides& sides) {
  std::vector<double> lengths(sides.piece_areas.size(), 0.0);
  for (std::size_t s = 0; s < sides.across.size(); ++s) {
    if (sides.across[s] == SurfaceSides::kNone) lengths[sides.piece[s / 3]] += sides.lengths[s];
  }
  for (double& length : lengths) length = length * length / (4.0 * kPi);
  return lengths;
}

}  // namespace

ShadowCaster shadow_caster(const Mesh& mesh) {
  LUM_CHECK(mesh.normals.size() == mesh.positions.size(), "loading fills normals");
  const WeldedMesh surface = repair(mesh).surface;
  const SurfaceSides sides = sides_of(surface);
  const std::vector<double> agreement = agreements(mesh, surface, sides);
  const std::vector<double> hole = holes(sides);
  ShadowCaster caster;
  caster.positions = surface.positions;
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    auto [a, b, c] = surface.triangles[f];
    const std::uint32_t piece = sides.piece[f];
    if (agreement[piece] < 0.0) std::swap(b, c);
    const bool closed = hole[piece] <= kLeastHole * sides.piece_areas[piece];
    (closed ? caster.closed : caster.open).push_back({a, b, c});
  }
  caster.slack = std::min(kSlackOfSides * mesh.mean_side(), kMostSlack * mesh.bounds().radius());
  return caster;
}

float world_slack(const ShadowCaster& caster, const Mat4& world_from_object) {
  return caster.slack * std::cbrt(std::abs(glm::determinant(Mat3(world_from_object))));
}

}  // namespace luminist
