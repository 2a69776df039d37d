#include "scene/mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>

#include <glm/common.hpp>

#include "base/check.h"
#include "base/disjoint_sets.h"
#include "scene/triple_index.h"

namespace luminist {
namespace {

using DVec3 = glm::dvec3;

DVec3 normalized_or_zero(const DVec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : DVec3(0.0);
}

/// Unit, or zero for a triangle without area: one so thin that its normal is made of rounding errors.
std::vector<DVec3> face_normals(const Mesh& mesh) {
  constexpr double kThinnest = 1e-7;
  std::vector<DVec3> normals;
  normals.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const DVec3 a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    const DVec3 area = glm::cross(b - a, c - a);
    const double longest = std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
    normals.push_back(glm::length(area) > kThinnest * longest ? glm::normalize(area) : DVec3(0.0));
  }
  return normals;
}

/// The side of a triangle that starts at corner `corner`, between two welded positions.
struct Side {
  std::uint32_t lo, hi;
  std::uint32_t corner;
  bool operator<(const Side& other) const {
    return std::tie(lo, hi, corner) < std::tie(other.lo, other.hi, other.corner);
  }
};

std::uint32_t next_corner(std::uint32_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// Joins the corners of triangles that share a side and bend over it by at most the crease angle.
void join_across_sides(const Mesh& mesh, const std::vector<std::uint32_t>& welded, const std::vector<DVec3>& faces,
                       double crease_angle, DisjointSets& sets) {
  constexpr std::size_t kMostNeighbours = 8;  // a side that hundreds of triangles share must not cost their square
  const double least_cosine = std::cos(crease_angle);
  const auto position_of = [&](std::uint32_t corner) { return welded[mesh.triangles[corner / 3][corner % 3]]; };
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    const auto [lo, hi] = std::minmax({position_of(corner), position_of(next_corner(corner))});
    if (lo != hi) sides.push_back({lo, hi, corner});
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::size_t end = std::min(sides.size(), i + kMostNeighbours);
    for (std::size_t j = i + 1; j < end && sides[j].lo == sides[i].lo && sides[j].hi == sides[i].hi; ++j) {
      const std::uint32_t a = sides[i].corner, b = sides[j].corner;
      if (glm::dot(faces[a / 3], faces[b / 3]) < least_cosine) continue;
      const std::uint32_t a_end = next_corner(a), b_end = next_corner(b);
      const bool same_way = position_of(a) == position_of(b);
      sets.join(a, same_way ? b : b_end);
      sets.join(a_end, same_way ? b_end : b);
    }
  }
}

double corner_angle(const Mesh& mesh, std::uint32_t corner) {
  const auto& t = mesh.triangles[corner / 3];
  const DVec3 p(mesh.positions[t[corner % 3]]);
  const DVec3 u = normalized_or_zero(DVec3(mesh.positions[t[(corner + 1) % 3]]) - p);
  const DVec3 v = normalized_or_zero(DVec3(mesh.positions[t[(corner + 2) % 3]]) - p);
  return std::acos(std::clamp(glm::dot(u, v), -1.0, 1.0));
}

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Gives every vertex one value per group of its corners: the first group keeps the vertex, others get copies.
/// group_of(corner) names the group, or kNone for a corner that takes what is there; on_vertex(vertex, corner) fills
/// what belongs to the group.
template <class GroupOf, class OnVertex>
void split_vertices(Mesh& mesh, GroupOf group_of, OnVertex on_vertex) {
  const auto first_copy = static_cast<std::uint32_t>(mesh.positions.size());
  std::vector<std::uint32_t> owner(mesh.positions.size(), kNone);
  TripleIndex copies;
  for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    std::uint32_t& index = mesh.triangles[corner / 3][corner % 3];
    const std::uint32_t group = group_of(corner);
    if (group == kNone) continue;
    if (owner[index] == kNone) owner[index] = group, on_vertex(index, corner);
    if (owner[index] == group) continue;
    const std::size_t known = copies.size();
    const std::uint32_t vertex = first_copy + copies.add({index, group, 0});
    if (copies.size() > known) {
      mesh.append_vertex(mesh, index);
      on_vertex(vertex, corner);
    }
    index = vertex;
  }
}

}  // namespace

std::vector<std::uint32_t> places_of(const std::vector<Vec3>& positions) {
  constexpr double kCells = 1 << 20;
  Box box;
  for (const Vec3& p : positions) box.extend(p);
  const DVec3 size = box.empty() ? DVec3(0.0) : DVec3(box.hi) - DVec3(box.lo);
  const double cell = std::max({size.x, size.y, size.z}) / kCells;
  TripleIndex index(positions.size());
  std::vector<std::uint32_t> places;
  places.reserve(positions.size());
  for (const Vec3& p : positions) {
    const DVec3 q = cell > 0.0 ? glm::round((DVec3(p) - DVec3(box.lo)) / cell) : DVec3(0.0);
    const auto whole = [](double x) { return x >= 0.0 && x <= kCells ? static_cast<std::uint32_t>(x) : 0xffffffffU; };
    places.push_back(index.add({whole(q.x), whole(q.y), whole(q.z)}));
  }
  return places;
}

void Mesh::append_vertex(const Mesh& from, std::size_t vertex) {
  // By value: the vertex may be of this mesh, whose arrays move as they grow.
  const auto append = [vertex](auto& to, const auto& values) {
    if (!values.empty()) to.push_back(typename std::decay_t<decltype(values)>::value_type(values[vertex]));
  };
  append(positions, from.positions);
  append(normals, from.normals);
  append(uvs, from.uvs);
  append(tangents, from.tangents);
  append(line_widths, from.line_widths);
}

Box Mesh::bounds() const {
  Box box;
  for (const Vec3& p : positions) box.extend(p);
  return box;
}

float Mesh::mean_side() const {
  double sum = 0.0;
  for (const auto& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) sum += glm::distance(positions[t[k]], positions[t[(k + 1) % 3]]);
  }
  return triangles.empty() ? 0.0F : static_cast<float>(sum / (3.0 * static_cast<double>(triangles.size())));
}

void compute_normals(Mesh& mesh, double crease_angle) {
  const std::vector<DVec3> faces = face_normals(mesh);
  const std::vector<std::uint32_t> welded = places_of(mesh.positions);
  const auto corners = static_cast<std::uint32_t>(3 * mesh.triangles.size());
  DisjointSets sets(corners);
  if (crease_angle >= kPi) {
    std::vector<std::uint32_t> first(mesh.positions.size(), corners);
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
      std::uint32_t& owner = first[welded[mesh.triangles[corner / 3][corner % 3]]];
      if (owner == corners) owner = corner;
      sets.join(owner, corner);
    }
  } else {
    join_across_sides(mesh, welded, faces, crease_angle, sets);
  }

  std::vector<DVec3> sums(corners, DVec3(0.0));
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    sums[sets.find(corner)] += corner_angle(mesh, corner) * faces[corner / 3];
  }
  mesh.tangents.clear();
  mesh.normals.assign(mesh.positions.size(), Vec3(0.0F, 1.0F, 0.0F));
  split_vertices(
      mesh, [&](std::uint32_t corner) { return faces[corner / 3] == DVec3(0.0) ? kNone : sets.find(corner); },
      [&](std::uint32_t vertex, std::uint32_t corner) {
        const DVec3 normal = normalized_or_zero(sums[sets.find(corner)]);
        mesh.normals[vertex] = Vec3(normal == DVec3(0.0) ? faces[corner / 3] : normal);  // zero: the faces cancel out
      });
}

void compute_tangents(Mesh& mesh) {
  if (mesh.uvs.empty()) return;
  LUM_CHECK(mesh.uvs.size() == mesh.positions.size() && mesh.normals.size() == mesh.positions.size(),
            "a mesh has normals before it gets tangents");
  // A vertex on the seam of mirrored texture coordinates is split by the sign of its triangles.
  std::vector<bool> mirrored;
  std::vector<DVec3> directions;
  for (const auto& t : mesh.triangles) {
    const DVec3 e1 = DVec3(mesh.positions[t[1]]) - DVec3(mesh.positions[t[0]]);
    const DVec3 e2 = DVec3(mesh.positions[t[2]]) - DVec3(mesh.positions[t[0]]);
    const glm::dvec2 d1 = glm::dvec2(mesh.uvs[t[1]]) - glm::dvec2(mesh.uvs[t[0]]);
    const glm::dvec2 d2 = glm::dvec2(mesh.uvs[t[2]]) - glm::dvec2(mesh.uvs[t[0]]);
    const double area = d1.x * d2.y - d1.y * d2.x;
    // v runs down the texture and the bitangent (normal x tangent) up, so the common, unmirrored case has area < 0.
    mirrored.push_back(area > 0.0);
    directions.push_back((area < 0.0 ? -1.0 : 1.0) * normalized_or_zero(e1 * d2.y - e2 * d1.y));
  }
  mesh.tangents.assign(mesh.positions.size(), Vec4(0.0F));
  split_vertices(
      mesh, [&](std::uint32_t corner) { return mirrored[corner / 3] ? 1U : 0U; },
      [&](std::uint32_t vertex, std::uint32_t corner) {
        mesh.tangents[vertex] = Vec4(0.0F, 0.0F, 0.0F, mirrored[corner / 3] ? -1.0F : 1.0F);
      });
  std::vector<DVec3> sums(mesh.positions.size(), DVec3(0.0));
  for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    sums[mesh.triangles[corner / 3][corner % 3]] += corner_angle(mesh, corner) * directions[corner / 3];
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const DVec3 normal(mesh.normals[i]);
    DVec3 tangent = normalized_or_zero(sums[i] - glm::dot(sums[i], normal) * normal);
    if (tangent == DVec3(0.0)) {
      Vec3 t, b;
      tangent_frame(mesh.normals[i], t, b);
      tangent = DVec3(t);
    }
    mesh.tangents[i] = Vec4(Vec3(tangent), mesh.tangents[i].w == 0.0F ? 1.0F : mesh.tangents[i].w);
  }
}

}  // namespace luminist
