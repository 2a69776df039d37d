#include "prep/curvature.h"

#include <Eigen/Dense>
#include <cmath>

namespace luminist {
namespace {

using TriangleCorners = std::array<glm::dvec3, 3>;

TriangleCorners corners_of(const WeldedMesh& surface, std::size_t f) {
  const auto& t = surface.triangles[f];
  return {glm::dvec3(surface.positions[t[0]]), glm::dvec3(surface.positions[t[1]]),
          glm::dvec3(surface.positions[t[2]])};
}

/// Weights that are exact on spheres (Max 1999).
std::vector<glm::dvec3> normals_of(const WeldedMesh& surface, const SurfaceSides& sides) {
  std::vector<glm::dvec3> sums(surface.positions.size(), glm::dvec3(0.0));
  std::vector<glm::dvec3> any(surface.positions.size(), glm::dvec3(0.0, 0.0, 1.0));
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double before = sides.lengths[3 * f + (k + 2) % 3];
      const double after = sides.lengths[3 * f + k];
      sums[surface.triangles[f][k]] += sides.normals[f] * (sides.areas[f] / (before * before)) / (after * after);
      any[surface.triangles[f][k]] = sides.normals[f];
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const double length = glm::length(sums[v]);
    // The triangles of a fold can cancel each other out.
    sums[v] = std::isfinite(length) && length > 0.0 ? sums[v] / length : any[v];
    if (!(std::abs(glm::length(sums[v]) - 1.0) < 1e-6)) sums[v] = any[v];
  }
  return sums;
}

/// The second fundamental form of a triangle in its frame (uu, uv, vv), from the normals of its corners.
Eigen::Vector3d form_of(const TriangleCorners& p, const TriangleCorners& n, const TangentFrame& frame) {
  Eigen::Matrix3d system = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 edge = p[(k + 2) % 3] - p[(k + 1) % 3];
    const glm::dvec3 change = n[(k + 2) % 3] - n[(k + 1) % 3];
    const double u = glm::dot(edge, frame.t);
    const double v = glm::dot(edge, frame.b);
    const Eigen::Vector3d first(u, v, 0.0);
    const Eigen::Vector3d second(0.0, u, v);
    system += first * first.transpose() + second * second.transpose();
    right += first * glm::dot(change, frame.t) + second * glm::dot(change, frame.b);
  }
  const Eigen::Vector3d form = system.ldlt().solve(right);
  return form.allFinite() ? form : Eigen::Vector3d::Zero();
}

}  // namespace

Curvature curvature_of(const WeldedMesh& surface, const SurfaceSides& sides) {
  Curvature result;
  result.normals = normals_of(surface, sides);
  const std::size_t positions = surface.positions.size();
  std::vector<Eigen::Vector3d> forms(positions, Eigen::Vector3d::Zero());
  std::vector<double> weights(positions, 0.0);
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const auto& t = surface.triangles[f];
    const TriangleCorners n{result.normals[t[0]], result.normals[t[1]], result.normals[t[2]]};
    const TangentFrame frame = tangent_frame_of(sides.normals[f]);
    const Eigen::Vector3d form = form_of(corners_of(surface, f), n, frame);
    for (std::size_t k = 0; k < 3; ++k) {
      const TangentFrame own = tangent_frame_of(n[k]);
      const glm::dvec3 along = transported(frame.t, sides.normals[f], n[k]);
      const double c = glm::dot(along, own.t);
      const double s = glm::dot(along, own.b);
      // The same form in a frame turned back by the angle of (c, s).
      forms[t[k]] += sides.areas[f] * Eigen::Vector3d(c * c * form[0] - 2.0 * c * s * form[1] + s * s * form[2],
                                                      c * s * (form[0] - form[2]) + (c * c - s * s) * form[1],
                                                      s * s * form[0] + 2.0 * c * s * form[1] + c * c * form[2]);
      weights[t[k]] += sides.areas[f];
    }
  }
  result.directions.resize(positions), result.largest.resize(positions), result.other.resize(positions);
  for (std::size_t v = 0; v < positions; ++v) {
    const Eigen::Vector3d form = weights[v] > 0.0 ? Eigen::Vector3d(forms[v] / weights[v]) : Eigen::Vector3d::Zero();
    const double mean = 0.5 * (form[0] + form[2]);
    const double half = 0.5 * (form[0] - form[2]);
    const double spread = std::hypot(half, form[1]);
    double angle = 0.5 * std::atan2(form[1], half);  // of the algebraically largest
    if (mean < 0.0) angle += 0.5 * kPi;
    const TangentFrame frame = tangent_frame_of(result.normals[v]);
    result.directions[v] = std::cos(angle) * frame.t + std::sin(angle) * frame.b;
    result.largest[v] = mean < 0.0 ? mean - spread : mean + spread;
    result.other[v] = mean < 0.0 ? mean + spread : mean - spread;
  }
  return result;
}

glm::dvec3 direction_on(const StrokeField& field, const WeldedMesh& surface, const SurfaceSides& sides,
                        std::size_t triangle) {
  const TangentFrame frame = tangent_frame_of(sides.normals[triangle]);
  glm::dvec2 sum(0.0);  // directions doubled, so that d and -d agree
  for (const std::uint32_t v : surface.triangles[triangle]) {
    const glm::dvec3 d = transported(field.directions[v], field.normals[v], sides.normals[triangle]);
    const glm::dvec2 at(glm::dot(d, frame.t), glm::dot(d, frame.b));
    sum += field.confidence[v] * glm::dvec2(at.x * at.x - at.y * at.y, 2.0 * at.x * at.y) / 3.0;
  }
  const double length = glm::length(sum);
  if (!(length > 0.0)) return 0.0 * frame.t;
  const double angle = 0.5 * std::atan2(sum.y, sum.x);
  return length * (std::cos(angle) * frame.t + std::sin(angle) * frame.b);
}

}  // namespace luminist
