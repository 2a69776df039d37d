#include "scene/mesh_repair.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "scene/face_faults.h"
#include "scene/triple_index.h"

namespace luminist {
namespace {

/// Where triangles meet at more than this, an edge is meant; organic shapes stay round. A die has 90 degrees between
/// faces, a coarse sphere of 8 segments 45.
constexpr double kCreaseAngle = kPi / 3.0;

void drop_unused_vertices(Mesh& mesh) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> renamed(mesh.positions.size(), kUnused);
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t index : t) renamed[index] = index;
  }
  Mesh used;
  for (std::size_t i = 0; i < renamed.size(); ++i) {
    if (renamed[i] == kUnused) continue;
    renamed[i] = static_cast<std::uint32_t>(used.positions.size());
    used.append_vertex(mesh, i);
  }
  for (const auto& t : mesh.triangles) used.triangles.push_back({renamed[t[0]], renamed[t[1]], renamed[t[2]]});
  mesh = std::move(used);
}

Vec3 area_vector(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  return glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
}

/// Replaces the normals that are zero or not finite; returns how many.
std::size_t fill_broken_normals(Mesh& mesh) {
  std::vector<std::size_t> broken;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const float length = glm::length(mesh.normals[i]);
    if (std::isfinite(length) && length > 1e-12F) {
      // What is unit up to rounding stays as it is, to the bit, however often a scene is saved and loaded.
      if (std::abs(length - 1.0F) > 1e-5F) mesh.normals[i] /= length;
    } else {
      broken.push_back(i);
    }
  }
  if (broken.empty()) return 0;
  Mesh smooth;  // no corner is split, so vertices keep their numbers
  smooth.positions = mesh.positions, smooth.triangles = mesh.triangles;
  compute_normals(smooth, kPi);
  for (const std::size_t i : broken) mesh.normals[i] = smooth.normals[i];
  return broken.size();
}

/// The share of the surface whose vertex normals look to the back of their face.
double share_on_back(const Mesh& mesh) {
  double back = 0.0, all = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 area = area_vector(mesh, t);
    const double size = glm::length(area);
    all += size;
    if (glm::dot(area, mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]]) < 0.0F) back += size;
  }
  return all > 0.0 ? back / all : 0.0;
}

/// Six times the volume that the surface encloses, measured from the middle of its bounds.
double signed_volume(const Mesh& mesh) {
  const glm::dvec3 middle(mesh.bounds().center());
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const glm::dvec3 a = glm::dvec3(mesh.positions[t[0]]) - middle;
    sum +=
        glm::dot(a, glm::cross(glm::dvec3(mesh.positions[t[1]]) - middle, glm::dvec3(mesh.positions[t[2]]) - middle));
  }
  return sum;
}

/// Every side of a triangle runs as often one way as the other, between welded positions.
bool is_closed(const Mesh& mesh) {
  TripleIndex points(mesh.positions.size()), sides(2 * mesh.triangles.size());
  std::vector<std::uint32_t> welded;
  for (const Vec3& p : mesh.positions) welded.push_back(points.add(position_bits(p)));
  std::vector<int> balance;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = welded[t[k]], b = welded[t[(k + 1) % 3]];
      const std::uint32_t side = sides.add({std::min(a, b), std::max(a, b), 0});
      if (side == balance.size()) balance.push_back(0);
      balance[side] += a < b ? 1 : (a > b ? -1 : 0);
    }
  }
  return std::all_of(balance.begin(), balance.end(), [](int b) { return b == 0; });
}

void turn_winding(Mesh& mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
}

}  // namespace

void drop_faulty_faces(Mesh& mesh, const std::string& where, const std::string& field, Diagnostics& diagnostics) {
  FaceFaults outside("an index points to nothing"), not_finite("a corner is not a finite number");
  std::size_t kept = 0;
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    const auto t = mesh.triangles[face];
    bool sound = true;
    for (const std::uint32_t index : t) {
      if (!sound) break;
      sound = index < mesh.positions.size() && is_usable(mesh.positions[index]);
      FaceFaults& fault = index < mesh.positions.size() ? not_finite : outside;
      if (!sound) fault.add(where, fmt::format("{} face {}, vertex {}", field, face, index));
    }
    if (sound) mesh.triangles[kept++] = t;
  }
  mesh.triangles.resize(kept);
  outside.report(diagnostics);
  not_finite.report(diagnostics);
  drop_unused_vertices(mesh);
  for (Vec2& uv : mesh.uvs) {
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) uv = Vec2(0.0F);
  }
}

bool repair_normals(Mesh& mesh, const std::string& where, const std::string& field, Diagnostics& diagnostics) {
  if (mesh.normals.size() != mesh.positions.size()) {
    compute_normals(mesh, kCreaseAngle);
    return false;
  }
  const std::size_t filled = fill_broken_normals(mesh);
  if (filled > 0) diagnostics.warn(where, fmt::format("{}: {} broken normals were made smooth", field, filled));
  constexpr double kMost = 0.9;  // beyond doubt: a rim that bends its normals over does not count
  if (share_on_back(mesh) <= kMost) return false;
  for (Vec3& n : mesh.normals) n = -n;
  diagnostics.warn(where, fmt::format("{}: the normals look inwards and were turned", field));
  return true;
}

bool turn_outside(Mesh& mesh) {
  if (signed_volume(mesh) >= 0.0 || !is_closed(mesh)) return false;
  turn_winding(mesh);
  for (Vec3& n : mesh.normals) n = -n;
  return true;
}

Mesh mirrored(const Mesh& mesh) {
  Mesh result = mesh;
  for (Vec3& p : result.positions) p.x = -p.x;
  for (Vec3& n : result.normals) n.x = -n.x;
  for (Vec4& t : result.tangents) t.x = -t.x, t.w = -t.w;
  turn_winding(result);
  return result;
}

}  // namespace luminist
