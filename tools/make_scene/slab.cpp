#include "make_scene/slab.h"

#include <array>
#include <cstdint>

namespace luminist {
namespace {

/// Places along one axis: fine over the bevels, nothing between.
std::vector<float> stations(float half, float bevel, int bevel_steps) {
  std::vector<float> places;
  for (int i = 0; i <= bevel_steps; ++i) {
    const double angle = 0.25 * kPi * i / bevel_steps;  // equal steps of the rounded edge
    places.push_back(half - bevel + bevel * static_cast<float>(std::tan(angle)));
  }
  std::vector<float> all(places.rbegin(), places.rend());
  for (float& p : all) p = -p;
  all.insert(all.end(), places.begin(), places.end());
  return all;
}

/// One of the six faces: `axis` is its normal's, `sign` the normal's direction.
void add_face(Mesh& mesh, const Vec3& half, float bevel, int axis, float sign, int long_axis, float texture_size,
              int bevel_steps) {
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  const std::vector<float> us = stations(half[a], bevel, bevel_steps);
  const std::vector<float> vs = stations(half[b], bevel, bevel_steps);
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  const bool swap = b == long_axis;
  for (const float v : vs) {
    for (const float u : us) {
      Vec3 p(0.0F);
      p[axis] = sign * half[axis], p[a] = u, p[b] = v;
      const Vec3 core = glm::clamp(p, bevel - half, half - bevel);
      const Vec3 normal = glm::normalize(p - core);
      mesh.positions.push_back(core + bevel * normal);
      mesh.normals.push_back(normal);
      const Vec2 uv = Vec2(u + half[a], v + half[b]) / texture_size;
      mesh.uvs.push_back(swap ? Vec2(uv.y, uv.x) : uv);
    }
  }
  const auto columns = static_cast<std::uint32_t>(us.size());
  for (std::uint32_t j = 0; j + 1 < vs.size(); ++j) {
    for (std::uint32_t i = 0; i + 1 < columns; ++i) {
      const std::uint32_t p = base + j * columns + i;
      std::array<std::uint32_t, 4> quad{p, p + 1, p + columns + 1, p + columns};
      if (sign < 0.0F) std::swap(quad[1], quad[3]);
      mesh.triangles.push_back({quad[0], quad[1], quad[2]});
      mesh.triangles.push_back({quad[0], quad[2], quad[3]});
    }
  }
}

}  // namespace

Mesh slab(const Vec3& half, float bevel, float texture_size, int bevel_steps) {
  Mesh mesh;
  int long_axis = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (half[axis] > half[long_axis]) long_axis = axis;
  }
  for (int axis = 0; axis < 3; ++axis) {
    add_face(mesh, half, bevel, axis, 1.0F, long_axis, texture_size, bevel_steps);
    add_face(mesh, half, bevel, axis, -1.0F, long_axis, texture_size, bevel_steps);
  }
  return mesh;
}

Mesh slab_at(const Vec3& center, const Vec3& half, float bevel, float texture_size, const Vec2& offset,
             int bevel_steps) {
  Mesh mesh = slab(half, bevel, texture_size, bevel_steps);
  for (Vec3& p : mesh.positions) p += center;
  for (Vec2& uv : mesh.uvs) uv += offset;
  return mesh;
}

}  // namespace luminist
