// prep/stroke_field.cpp -- stroke_field() of curvature.h: the smooth field, as one linear system.
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <complex>

#include <Eigen/Eigenvalues>

#include "prep/curvature.h"

namespace luminist {
namespace {

using Complex = std::complex<double>;  // a direction at angle a is e^(2 i a): it has no sign

/// How far a direction reaches, as a share of a piece's size (the root of its area).
constexpr double kFieldReach = 0.07;
/// Directions of the default have this share of the say of full curvature, so that they decide where there is none.
constexpr double kDefaultSay = 1e-4;

/// Turns beyond this (radians) are edges, not curvature: no stroke runs over them, and what is on one side need not
/// agree with the other.
constexpr double kEdge = 0.87;
constexpr double kOverEdges = 0.01;  ///< what is left of the say and the agreement there

/// The axis that strokes run around where nothing bends: the longest of the surface, or up where it has no longest.
glm::dvec3 longest_axis(const WeldedMesh& surface, const SurfaceSides& sides) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  double area = 0.0;
  const glm::dvec3 origin(surface.positions.front());
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    glm::dvec3 middle(0.0);
    for (const std::uint32_t v : surface.triangles[f]) middle += (glm::dvec3(surface.positions[v]) - origin) / 3.0;
    const Eigen::Vector3d at(middle.x, middle.y, middle.z);
    sum += sides.areas[f] * at;
    squares += sides.areas[f] * at * at.transpose();
    area += sides.areas[f];
  }
  const glm::dvec3 up(0.0, 1.0, 0.0);
  const Eigen::Matrix3d spread = squares / area - sum * sum.transpose() / (area * area);
  if (!spread.allFinite()) return up;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  constexpr double kClearly = 1.2;  // ratio of variances
  if (!(solver.eigenvalues()[2] > kClearly * solver.eigenvalues()[1])) return up;
  const Eigen::Vector3d axis = solver.eigenvectors().col(2);
  return {axis.x(), axis.y(), axis.z()};
}

Complex doubled(const glm::dvec3& tangent, const TangentFrame& frame) {
  const Complex at(glm::dot(tangent, frame.t), glm::dot(tangent, frame.b));
  return at * at;
}

/// What a position wants: its direction times the weight of that wish, and the weight.
struct Wish {
  Complex direction{0.0};
  double weight = 0.0;
};

class FieldSystem {
 public:
  FieldSystem(const WeldedMesh& surface, const SurfaceSides& sides)
      : surface_(&surface), sides_(&sides), curvature_(curvature_of(surface, sides)) {
    for (const glm::dvec3& n : curvature_.normals) frames_.push_back(tangent_frame_of(n));
    is_edge_.assign(frames_.size(), 0);
    for (std::uint32_t s = 0; s < sides.turns.size(); ++s) {
      if (std::abs(sides.turns[s]) > kEdge) is_edge_[surface.triangles[s / 3][s % 3]] = 1;
    }
    add_wishes();
  }

  StrokeField solve() const {
    const auto count = static_cast<Eigen::Index>(frames_.size());
    Eigen::SparseMatrix<Complex> matrix(count, count);
    const std::vector<Eigen::Triplet<Complex>> entries = this->entries();
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::VectorXcd right(count);
    for (Eigen::Index v = 0; v < count; ++v) right[v] = wishes_[static_cast<std::size_t>(v)].direction;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<Complex>> solver(matrix);
    Eigen::VectorXcd field = right;
    if (solver.info() == Eigen::Success) field = solver.solve(right);
    StrokeField result{curvature_.normals, {}, {}};
    for (std::size_t v = 0; v < frames_.size(); ++v) {
      Complex z = field[static_cast<Eigen::Index>(v)];
      double length = std::abs(z);
      if (!std::isfinite(length) || length == 0.0) z = 1.0, length = 0.0;
      const double angle = 0.5 * std::arg(z);
      result.directions.push_back(std::cos(angle) * frames_[v].t + std::sin(angle) * frames_[v].b);
      result.confidence.push_back(std::min(length, 1.0) * share_of(v));
    }
    return result;
  }

 private:
  [[nodiscard]] double share_of(std::size_t position) const { return is_edge_[position] != 0 ? kOverEdges : 1.0; }

  void add_wishes() {
    wishes_.resize(frames_.size());
    const glm::dvec3 axis = longest_axis(*surface_, *sides_);
    for (std::size_t f = 0; f < surface_->triangles.size(); ++f) {
      const double size = std::sqrt(sides_->piece_areas[sides_->piece[f]]);
      const double share = sides_->areas[f] / (3.0 * kFieldReach * kFieldReach * size * size);
      for (const std::uint32_t v : surface_->triangles[f]) {
        const double bend = (std::abs(curvature_.largest[v]) - std::abs(curvature_.other[v])) * size;
        const double say = share_of(v) * share * (std::isfinite(bend) ? bend / (1.0 + bend) : 0.0);
        wishes_[v].direction += say * doubled(curvature_.directions[v], frames_[v]);
        const glm::dvec3 around = glm::cross(axis, curvature_.normals[v]);
        wishes_[v].direction += kDefaultSay * share * doubled(around, frames_[v]);
        wishes_[v].weight += say + kDefaultSay * share;
      }
    }
  }

  /// sum over edges w |z_a - turned z_b|^2 + sum of the wishes, as the rows where its gradient is zero.
  [[nodiscard]] std::vector<Eigen::Triplet<Complex>> entries() const {
    std::vector<Eigen::Triplet<Complex>> entries;
    entries.reserve(12 * surface_->triangles.size() + frames_.size());
    for (std::size_t f = 0; f < surface_->triangles.size(); ++f) {
      const auto& t = surface_->triangles[f];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[(k + 1) % 3];
        const std::uint32_t b = t[(k + 2) % 3];
        const double w = weight_opposite(f, k) * std::min(share_of(a), share_of(b));
        // Where a's first axis comes to lie at b: its doubled angle turns a's directions into b's.
        const glm::dvec3 axis = transported(frames_[a].t, curvature_.normals[a], curvature_.normals[b]);
        Complex turn = doubled(axis, frames_[b]);
        turn = std::abs(turn) > 0.0 ? turn / std::abs(turn) : Complex(1.0);
        const auto row_a = static_cast<int>(a);
        const auto row_b = static_cast<int>(b);
        entries.emplace_back(row_a, row_a, w), entries.emplace_back(row_b, row_b, w);
        entries.emplace_back(row_b, row_a, -w * turn), entries.emplace_back(row_a, row_b, -w * std::conj(turn));
      }
    }
    for (std::size_t v = 0; v < frames_.size(); ++v) {
      entries.emplace_back(static_cast<int>(v), static_cast<int>(v), std::max(wishes_[v].weight, 1e-12));
    }
    return entries;
  }

  /// Half the cotangent of the angle at corner k, kept positive and bounded for thin triangles.
  [[nodiscard]] double weight_opposite(std::size_t f, std::size_t k) const {
    const double a = sides_->lengths[3 * f + k];
    const double b = sides_->lengths[3 * f + (k + 2) % 3];
    const double c = sides_->lengths[3 * f + (k + 1) % 3];
    const double cotangent = (a * a + b * b - c * c) / (4.0 * sides_->areas[f]);
    return 0.5 * std::clamp(std::isfinite(cotangent) ? cotangent : 0.0, 0.1, 10.0);
  }

  const WeldedMesh* surface_;
  const SurfaceSides* sides_;
  Curvature curvature_;
  std::vector<TangentFrame> frames_;  ///< [positions]
  std::vector<Wish> wishes_;          ///< [positions]
  std::vector<char> is_edge_;         ///< [positions]
};

}  // namespace

StrokeField stroke_field(const WeldedMesh& surface, const SurfaceSides& sides) {
  if (surface.triangles.empty()) return {};
  return FieldSystem(surface, sides).solve();
}

}  // namespace luminist
