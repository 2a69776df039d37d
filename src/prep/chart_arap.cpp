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

using FlatCorners = std::array<std::complex<double>, 3>;

/// The similarity that best carries the triangle to where its corners are.
std::complex<double> similarity_of(const Flat& flat, const FlatCorners& at) {
  std::complex<double> sum = 0.0;
  double size = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::complex<double> side = flat.corners[(k + 1) % 3] - flat.corners[k];
    sum += flat.weights[k] * (at[(k + 1) % 3] - at[k]) * std::conj(side);
    size += flat.weights[k] * std::norm(side);
  }
  return size > 0.0 ? sum / size : 1.0;
}

std::complex<double> unit(std::complex<double> z) {
  const double length = std::abs(z);
  return length > 0.0 ? z / length : 1.0;
}

/// The points between triangles that were turned and scaled, each by itself.
class PiecedTriangles {
 public:
  PiecedTriangles(const Disc& disc, const std::vector<glm::dvec2>& places)
      : disc_(&disc), at_(static_cast<Eigen::Index>(places.size()), 2) {
    const auto count = static_cast<Eigen::Index>(disc.points.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.emplace_back(0, 0, 1.0);  // holds the first point: the rest is free to turn around it
    for (const auto& t : disc.triangles) {
      flats_.push_back(flat_of(disc, t));
      for (std::size_t k = 0; k < 3; ++k) {
        const auto a = static_cast<int>(t[k]), b = static_cast<int>(t[(k + 1) % 3]);
        const double w = flats_.back().weights[k];
        entries.emplace_back(a, a, w), entries.emplace_back(b, b, w);
        entries.emplace_back(a, b, -w), entries.emplace_back(b, a, -w);
      }
    }
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver_.compute(matrix);
    for (Eigen::Index i = 0; i < count; ++i) {
      const glm::dvec2 p = places[static_cast<std::size_t>(i)] - places[0];
      at_.row(i) << p.x, p.y;
    }
  }
  [[nodiscard]] bool good() const { return solver_.info() == Eigen::Success && at_.allFinite(); }

  /// How every triangle lies.
  [[nodiscard]] std::vector<std::complex<double>> similarities() const {
    std::vector<std::complex<double>> result;
    for (std::size_t f = 0; f < flats_.size(); ++f) {
      const auto& t = disc_->triangles[f];
      FlatCorners corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = {at_(t[k], 0), at_(t[k], 1)};
      result.push_back(similarity_of(flats_[f], corners));
    }
    return result;
  }

  /// Every triangle lies as wanted, as nearly as its neighbours let it.
  void solve(const std::vector<std::complex<double>>& wanted) {
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(at_.rows(), 2);
    for (std::size_t f = 0; f < flats_.size(); ++f) {
      const auto& t = disc_->triangles[f];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const auto side = flats_[f].weights[k] * wanted[f] * (flats_[f].corners[next] - flats_[f].corners[k]);
        right.row(t[next]) += Eigen::RowVector2d(side.real(), side.imag());
        right.row(t[k]) -= Eigen::RowVector2d(side.real(), side.imag());
      }
    }
    at_ = solver_.solve(right);
  }

  [[nodiscard]] std::vector<glm::dvec2> places() const {
    std::vector<glm::dvec2> places;
    for (Eigen::Index i = 0; i < at_.rows(); ++i) places.emplace_back(at_(i, 0), at_(i, 1));
    return places;
  }

 private:
  const Disc* disc_;
  std::vector<Flat> flats_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  Eigen::MatrixX2d at_;
};

}  // namespace

std::optional<std::vector<glm::dvec2>> as_rigid_as_possible(const Disc& disc, const std::vector<glm::dvec2>& places) {
  constexpr int kSteps = 10;
  PiecedTriangles pieces(disc, places);
  for (int step = 0; step < kSteps && pieces.good(); ++step) {
    std::vector<std::complex<double>> wanted = pieces.similarities();
    for (std::complex<double>& each : wanted) each = unit(each);
    pieces.solve(wanted);
  }
  return pieces.good() ? std::optional(pieces.places()) : std::nullopt;
}

std::optional<std::vector<glm::dvec2>> with_triangles_turned(const Disc& disc, const std::vector<glm::dvec2>& places,
                                                             const std::vector<double>& turns) {
  constexpr int kSteps = 8;
  constexpr double kMostScale = 2.0;
  PiecedTriangles pieces(disc, places);
  if (!pieces.good()) return std::nullopt;
  std::vector<std::complex<double>> directions = pieces.similarities();
  for (std::size_t f = 0; f < directions.size(); ++f) directions[f] = unit(directions[f]) * std::polar(1.0, turns[f]);
  std::vector<std::complex<double>> wanted = directions;
  for (int step = 0; step < kSteps; ++step) {
    pieces.solve(wanted);
    if (!pieces.good()) return std::nullopt;
    const std::vector<std::complex<double>> now = pieces.similarities();
    for (std::size_t f = 0; f < now.size(); ++f) {
      const double along = (now[f] * std::conj(directions[f])).real();
      wanted[f] = std::clamp(along, 1.0 / kMostScale, kMostScale) * directions[f];
    }
  }
  return pieces.places();
}

}  // namespace luminist
