#include "prep/split_sides.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace luminist {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The vertices in the middle of sides, made when they are asked for.
class Middles {
 public:
  Middles(Mesh& mesh, float longest) : mesh_(&mesh), longest_(longest) {}

  [[nodiscard]] bool is_long(std::uint32_t a, std::uint32_t b) const {
    return glm::distance(mesh_->positions[a], mesh_->positions[b]) > longest_;
  }
  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    const std::uint64_t key = (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
    const auto [entry, is_new] = made_.try_emplace(key, static_cast<std::uint32_t>(mesh_->positions.size()));
    if (!is_new) return entry->second;
    Mesh& m = *mesh_;
    // The sum of two floats is the same either way: both sides of a seam get the same place.
    m.positions.push_back(0.5F * (m.positions[a] + m.positions[b]));
    m.normals.push_back(unit_or(m.normals[a] + m.normals[b], m.normals[a]));
    if (!m.uvs.empty()) m.uvs.push_back(0.5F * (m.uvs[a] + m.uvs[b]));
    if (!m.line_widths.empty()) m.line_widths.push_back(0.5F * (m.line_widths[a] + m.line_widths[b]));
    if (!m.tangents.empty()) {
      const Vec4 from = m.tangents[a];
      m.tangents.emplace_back(unit_or(Vec3(from) + Vec3(m.tangents[b]), Vec3(from)), from.w);
    }
    return entry->second;
  }

 private:
  Mesh* mesh_;
  float longest_;
  std::unordered_map<std::uint64_t, std::uint32_t> made_;
};

/// Halves every long side once.
void split(const Triangle& t, Middles& middles, std::vector<Triangle>& triangles) {
  std::array<bool, 3> cut;
  for (std::size_t k = 0; k < 3; ++k) cut[k] = middles.is_long(t[k], t[(k + 1) % 3]);
  const auto count = std::ranges::count(cut, true);
  if (count == 0) {
    triangles.push_back(t);
    return;
  }
  // Turned so that side 0 is cut and, of two, side 1 is too.
  std::size_t first = 0;
  while (!cut[first] || (count == 2 && !cut[(first + 1) % 3])) ++first;
  const std::uint32_t a = t[first];
  const std::uint32_t b = t[(first + 1) % 3];
  const std::uint32_t c = t[(first + 2) % 3];
  const std::uint32_t ab = middles.between(a, b);
  if (count == 1) {
    triangles.insert(triangles.end(), {Triangle{a, ab, c}, Triangle{ab, b, c}});
    return;
  }
  const std::uint32_t bc = middles.between(b, c);
  triangles.push_back({ab, b, bc});
  if (count == 2) {
    triangles.insert(triangles.end(), {Triangle{a, ab, bc}, Triangle{a, bc, c}});
    return;
  }
  const std::uint32_t ca = middles.between(c, a);
  triangles.insert(triangles.end(), {Triangle{a, ab, ca}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}});
}

}  // namespace

void split_long_sides(Mesh& mesh, float longest, std::size_t most_triangles) {
  if (!(longest > 0.0F)) return;
  for (std::size_t before = 0; before != mesh.triangles.size() && mesh.triangles.size() < most_triangles / 4;) {
    before = mesh.triangles.size();
    Middles middles(mesh, longest);
    std::vector<Triangle> triangles;
    for (const Triangle& t : mesh.triangles) split(t, middles, triangles);
    mesh.triangles = std::move(triangles);
  }
}

}  // namespace luminist
