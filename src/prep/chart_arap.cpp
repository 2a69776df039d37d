// prep/chart_arap.cpp -- as_rigid_as_possible() of chart_map.h.
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <complex>

#include "prep/chart_map.h"

namespace luminist {
namespace {

/// A triangle as it lies on the surface, in a frame of its own: complex numbers, because turns are products.
struct Flat {
  std::array<std::complex<double>, 3> corners;
  std::array<double, 3> weights;  ///< of the side after each corner: half the cotangent of the angle opposite
};

constexpr double kMost = 1e3;  // cotangents of thin triangles, so that they do not decide alone

Flat flat_of(const Disc& disc, const std::array<std::uint32_t, 3>& t) {
  const glm::dvec3 e = disc.points[t[1]] - disc.points[t[0]];
  const glm::dvec3 f = disc.points[t[2]] - disc.points[t[0]];
  const double length = glm::length(e);
  const double height = glm::length(glm::cross(e, f)) / length;
  Flat flat{{0.0, length, {glm::dot(e, f) / length, height}}, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::complex<double> apex = flat.corners[(k + 2) % 3];
    const std::complex<double> angle = std::conj(flat.corners[k] - apex) * (flat.corners[(k + 1) % 3] - apex);
    flat.weights[k] = 0.5 * std::clamp(angle.real() / std::max(angle.imag(), 1e-300), -kMost, kMost);
  }
  return flat;
}

/// The turn that best carries the triangle to where its corners are.
std::complex<double> turn_of(const Flat& flat, const std::array<std::complex<double>, 3>& at) {
  std::complex<double> sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    sum += flat.weights[k] * (at[next] - at[k]) * std::conj(flat.corners[next] - flat.corners[k]);
  }
  const double length = std::abs(sum);
  return length > 0.0 ? sum / length : 1.0;
}

}  // namespace

std::optional<std::vector<glm::dvec2>> as_rigid_as_possible(const Disc& disc, std::vector<glm::dvec2> places) {
  constexpr int kSteps = 10;
  const auto count = static_cast<Eigen::Index>(disc.points.size());
  std::vector<Flat> flats;
  std::vector<Eigen::Triplet<double>> entries;
  entries.emplace_back(0, 0, 1.0);  // holds the first point: the rest is free to turn around it
  for (const auto& t : disc.triangles) {
    flats.push_back(flat_of(disc, t));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<int>(t[k]), b = static_cast<int>(t[(k + 1) % 3]);
      const double w = flats.back().weights[k];
      entries.emplace_back(a, a, w), entries.emplace_back(b, b, w);
      entries.emplace_back(a, b, -w), entries.emplace_back(b, a, -w);
    }
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  if (solver.info() != Eigen::Success) return std::nullopt;
  Eigen::MatrixX2d at(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const glm::dvec2 p = places[static_cast<std::size_t>(i)] - places[0];
    at.row(i) << p.x, p.y;
  }
  for (int step = 0; step < kSteps; ++step) {
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(count, 2);
    for (std::size_t f = 0; f < flats.size(); ++f) {
      const auto& t = disc.triangles[f];
      std::array<std::complex<double>, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = {at(t[k], 0), at(t[k], 1)};
      const std::complex<double> turn = turn_of(flats[f], corners);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const std::complex<double> side = flats[f].weights[k] * turn * (flats[f].corners[next] - flats[f].corners[k]);
        right.row(t[next]) += Eigen::RowVector2d(side.real(), side.imag());
        right.row(t[k]) -= Eigen::RowVector2d(side.real(), side.imag());
      }
    }
    at = solver.solve(right);
    if (solver.info() != Eigen::Success || !at.allFinite()) return std::nullopt;
  }
  for (Eigen::Index i = 0; i < count; ++i) places[static_cast<std::size_t>(i)] = {at(i, 0), at(i, 1)};
  return places;
}

}  // namespace luminist
