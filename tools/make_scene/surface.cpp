#include "make_scene/surface.h"

#include <cstdint>

#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "base/check.h"

namespace luminist {
namespace {

constexpr double kStep = 1e-4;  // of the parameters, for differences

Point3 difference(const Surface& surface, double u, double v, const Point2& step) {
  const double u0 = std::clamp(u - step.x, 0.0, 1.0);
  const double u1 = std::clamp(u + step.x, 0.0, 1.0);
  const double v0 = std::clamp(v - step.y, 0.0, 1.0);
  const double v1 = std::clamp(v + step.y, 0.0, 1.0);
  return surface(u1, v1) - surface(u0, v0);
}

}  // namespace

Point3 surface_normal(const Surface& surface, double u, double v) {
  const Point3 du = difference(surface, u, v, {kStep, 0.0});
  const Point3 dv = difference(surface, u, v, {0.0, kStep});
  const Point3 normal = glm::cross(du, dv);
  const double length = glm::length(normal);
  if (length > 1e-7 * glm::dot(dv, dv) && length > 0.0) return normal / length;
  const double inside = v + (v < 0.5 ? 1e-3 : -1e-3);
  const Point3 nudged =
      glm::cross(difference(surface, u, inside, {kStep, 0.0}), difference(surface, u, inside, {0.0, kStep}));
  const double nudged_length = glm::length(nudged);
  return nudged_length > 0.0 ? nudged / nudged_length : Point3(0.0, 1.0, 0.0);
}

Mesh tessellate(const Surface& surface, int columns, int rows) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double u = static_cast<double>(i) / columns;
      const double v = static_cast<double>(j) / rows;
      mesh.positions.emplace_back(surface(u, v));
      mesh.normals.emplace_back(surface_normal(surface, u, v));
      mesh.uvs.emplace_back(static_cast<float>(u), static_cast<float>(v));
    }
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vec3 ab = mesh.positions[b] - mesh.positions[a];
    const Vec3 ac = mesh.positions[c] - mesh.positions[a];
    if (glm::length(glm::cross(ab, ac)) > 1e-12F) mesh.triangles.push_back({a, b, c});
  };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (columns + 1) + i);
      const auto c = a + static_cast<std::uint32_t>(columns) + 1;
      add(a, a + 1, c + 1);
      add(a, c + 1, c);
    }
  }
  return mesh;
}

void append(Mesh& mesh, const Mesh& other) {
  LUM_CHECK(mesh.positions.empty() || mesh.uvs.empty() == other.uvs.empty(), "parts of a mesh have uvs alike");
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
  mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
  for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
}

void transform(Mesh& mesh, const Mat4& matrix) {
  const Mat3 normal_matrix = glm::transpose(glm::inverse(Mat3(matrix)));
  for (Vec3& p : mesh.positions) p = Vec3(matrix * Vec4(p, 1.0F));
  for (Vec3& n : mesh.normals) n = glm::normalize(normal_matrix * n);
}

void scale_uvs(Mesh& mesh, const Vec2& factor) {
  for (Vec2& uv : mesh.uvs) uv *= factor;
}

Mat4 Placement::matrix() const {
  Mat4 m = glm::translate(Mat4(1.0F), position);
  m = glm::rotate(m, angles.y, Vec3(0.0F, 1.0F, 0.0F));
  m = glm::rotate(m, angles.x, Vec3(1.0F, 0.0F, 0.0F));
  m = glm::rotate(m, angles.z, Vec3(0.0F, 0.0F, 1.0F));
  return glm::scale(m, scale);
}

}  // namespace luminist
