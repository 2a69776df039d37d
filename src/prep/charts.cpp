#include "prep/charts.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>

#include "base/check.h"

namespace luminist {
namespace {

/// Sums over triangles by which a region is judged.
struct Moments {
  double area = 0.0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
  glm::dvec2 feature{0.0};
  double features = 0.0;
  double perimeter = 0.0;
  std::uint32_t open_sides = 0;  ///< in the perimeter

  void add(const Moments& other) {
    area += other.area, normal += other.normal, normals += other.normals;
    feature += other.feature, features += other.features;
    perimeter += other.perimeter, open_sides += other.open_sides;
  }
  /// The variance of the normals off the plane curve that they follow best: the least eigenvalue.
  [[nodiscard]] double bend() const {
    const Eigen::Vector3d mean = normal / area;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(normals / area - mean * mean.transpose(), Eigen::EigenvaluesOnly);
    return std::max(solver.eigenvalues()[0], 0.0);
  }
  [[nodiscard]] double disagreement() const {
    return std::max((features - glm::dot(feature, feature) / area) / area, 0.0);
  }
};

/// What two regions share.
struct Border {
  std::uint32_t to = 0;
  double length = 0.0;
  double turn = 0.0;    ///< absolute, integrated along it
  double groove = 0.0;  ///< the part of it in grooves
  std::uint32_t sides = 0;

  void add(const Border& other) {
    length += other.length, turn += other.turn, groove += other.groove, sides += other.sides;
  }
};

/// When two regions may become one.
struct MergeLimits {
  double spread = std::numeric_limits<double>::infinity();
  double crease = std::numeric_limits<double>::infinity();
  double small = std::numeric_limits<double>::infinity();  ///< one of them covers less than this share of its piece
  std::size_t fewest = 1;                                  ///< regions
};

class Merging {
 public:
  Merging(const SurfaceSides& sides, const Region& triangles, const std::vector<glm::dvec2>& features)
      : sides_(&sides), triangles_(&triangles), region_(triangles.size()), alive_(triangles.size()) {
    std::vector<std::uint32_t> local(sides.areas.size(), SurfaceSides::kNone);
    for (std::uint32_t i = 0; i < triangles.size(); ++i) local[triangles[i]] = i;
    moments_.resize(triangles.size()), borders_.resize(triangles.size()), version_.resize(triangles.size(), 0);
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      add_triangle(i, local, features.empty() ? glm::dvec2(0.0) : features[i]);
    }
  }

  void run(const MergeLimits& limits) {
    for (std::uint32_t a = 0; a < borders_.size(); ++a) {
      for (const Border& border : borders_[a]) {
        if (a < border.to) offer(a, border, limits);
      }
    }
    while (!queue_.empty() && alive_ > limits.fewest) {
      const Offer best = queue_.top();
      queue_.pop();
      if (version_[best.a] != best.version_a || version_[best.b] != best.version_b) continue;
      merge(best.a, best.b);
      for (const Border& border : borders_[best.a]) offer(best.a, border, limits);
    }
    queue_ = {};
  }

  /// [triangles] a number for each region.
  std::vector<std::uint32_t> numbers() { return region_.numbered().first; }

 private:
  struct Offer {
    double cost;
    std::uint32_t a, b, version_a, version_b;
    bool operator>(const Offer& o) const { return std::tie(cost, a, b) > std::tie(o.cost, o.a, o.b); }
  };

  void add_triangle(std::uint32_t i, const std::vector<std::uint32_t>& local, const glm::dvec2& feature) {
    const std::uint32_t f = (*triangles_)[i];
    const glm::dvec3& n = sides_->normals[f];
    Moments& m = moments_[i];
    m.area = std::max(sides_->areas[f], std::numeric_limits<double>::min());
    const Eigen::Vector3d normal(n.x, n.y, n.z);
    m.normal = m.area * normal;
    m.normals = m.area * normal * normal.transpose();
    m.feature = m.area * feature;
    m.features = m.area * glm::dot(feature, feature);
    m.open_sides = 3;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t side = 3 * f + k;
      m.perimeter += sides_->lengths[side];
      const std::uint32_t other = sides_->across[side];
      if (other == SurfaceSides::kNone || local[other / 3] == SurfaceSides::kNone) continue;
      const double turn = sides_->turns[side] * sides_->lengths[side];
      const Border border{local[other / 3], sides_->lengths[side], std::abs(turn), std::max(-turn, 0.0), 1};
      insert(borders_[i], border);
    }
  }

  static void insert(std::vector<Border>& borders, const Border& border) {
    const auto at = std::ranges::lower_bound(borders, border.to, {}, &Border::to);
    if (at != borders.end() && at->to == border.to) {
      at->add(border);
    } else {
      borders.insert(at, border);
    }
  }

  void offer(std::uint32_t a, const Border& border, const MergeLimits& limits) {
    std::uint32_t b = border.to;
    Moments both = moments_[a];
    both.add(moments_[b]);
    both.open_sides -= 2 * border.sides;
    both.perimeter = std::max(both.perimeter - 2.0 * border.length, 0.0);
    if (both.open_sides == 0) return;  // a closed surface has no map
    const double turn = border.length > 0.0 ? border.turn / border.length : 0.0;
    if (turn > limits.crease) return;
    const double piece = sides_->piece_areas[sides_->piece[(*triangles_)[a]]];
    if (std::min(moments_[a].area, moments_[b].area) > limits.small * piece) return;
    const double bend = both.bend();
    if (bend > limits.spread * limits.spread) return;
    constexpr double kFlat = 5e-4;  // on flat ground compact regions grow alike
    const double shape = std::sqrt(both.perimeter * both.perimeter / (4.0 * kPi * both.area));
    const double groove = border.turn > 0.0 ? border.groove / border.turn : 0.0;
    const double cost =
        both.area * (bend + 0.05 * both.disagreement() + kFlat) * shape * (1.0 + 2.0 * turn * (1.0 + 0.5 * groove));
    if (b < a) std::swap(a, b);
    queue_.push({cost, a, b, version_[a], version_[b]});
  }

  void merge(std::uint32_t a, std::uint32_t b) {
    region_.join(a, b);
    --alive_;
    moments_[a].add(moments_[b]);
    const auto shared = std::ranges::lower_bound(borders_[a], b, {}, &Border::to);
    moments_[a].perimeter = std::max(moments_[a].perimeter - 2.0 * shared->length, 0.0);
    moments_[a].open_sides -= 2 * shared->sides;
    borders_[a].erase(shared);
    for (const Border& border : borders_[b]) {
      if (border.to == a) continue;
      insert(borders_[a], border);
      auto& back = borders_[border.to];
      const auto to_b = std::ranges::lower_bound(back, b, {}, &Border::to);
      Border moved = *to_b;
      back.erase(to_b);
      moved.to = a;
      insert(back, moved);
    }
    borders_[b].clear();
    ++version_[a], ++version_[b];
  }

  const SurfaceSides* sides_;
  const Region* triangles_;
  DisjointSets region_;
  std::size_t alive_;
  std::vector<Moments> moments_;              ///< [triangles] of the region that a triangle stands for
  std::vector<std::vector<Border>> borders_;  ///< [triangles] sorted by the other's number
  std::vector<std::uint32_t> version_;        ///< [triangles] offers to older regions are void
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> queue_;
};

/// How much a cut is worth along a side: it is long, and hides on edges and in grooves.
double cut_length(const SurfaceSides& sides, std::uint32_t side) {
  const double turn = sides.turns[side];
  return sides.lengths[side] / (1.0 + 2.0 * std::abs(turn) * (turn < 0.0 ? 1.5 : 1.0));
}

/// Triangles that stick out into a neighbour go over to it when that makes the border shorter. Only such that hang on
/// their region by one side go, so that it stays connected, and none goes over a crease.
void straighten(const SurfaceSides& sides, std::vector<std::uint32_t>& label, double crease) {
  constexpr int kPasses = 6;
  for (int pass = 0; pass < kPasses; ++pass) {
    bool changed = false;
    for (std::uint32_t f = 0; f < label.size(); ++f) {
      std::array<std::uint32_t, 3> around{SurfaceSides::kNone, SurfaceSides::kNone, SurfaceSides::kNone};
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t other = sides.across[3 * f + k];
        if (other != SurfaceSides::kNone) around[k] = label[other / 3];
      }
      if (std::ranges::count(around, label[f]) != 1) continue;
      const auto own = static_cast<std::uint32_t>(std::ranges::find(around, label[f]) - around.begin());
      const std::uint32_t left = (own + 1) % 3;
      const std::uint32_t right = (own + 2) % 3;
      if (around[left] != around[right] || around[left] == SurfaceSides::kNone) continue;
      if (std::max(std::abs(sides.turns[3 * f + left]), std::abs(sides.turns[3 * f + right])) > crease) continue;
      const double before = cut_length(sides, 3 * f + left) + cut_length(sides, 3 * f + right);
      if (cut_length(sides, 3 * f + own) >= before) continue;
      label[f] = around[left];
      changed = true;
    }
    if (!changed) return;
  }
}

std::vector<Region> regions_of(const std::vector<std::uint32_t>& label) {
  std::vector<std::uint32_t> number(label.size(), SurfaceSides::kNone);
  std::vector<Region> regions;
  for (std::uint32_t f = 0; f < label.size(); ++f) {
    std::uint32_t& at = number[label[f]];
    if (at == SurfaceSides::kNone) at = static_cast<std::uint32_t>(regions.size()), regions.emplace_back();
    regions[at].push_back(f);
  }
  return regions;
}

}  // namespace

std::vector<Region> charts_of(const SurfaceSides& sides, const ChartOptions& options) {
  Region all(sides.areas.size());
  std::iota(all.begin(), all.end(), 0U);
  Merging merging(sides, all, {});
  merging.run({.spread = options.spread, .crease = options.crease});
  merging.run({.spread = 2.0 * options.spread, .crease = 1.3 * options.crease, .small = options.smallest});
  merging.run({.small = options.tiny});
  std::vector<std::uint32_t> label = merging.numbers();
  straighten(sides, label, 0.5 * options.crease);
  return regions_of(label);
}

std::array<Region, 2> halves_of(const SurfaceSides& sides, const Region& region,
                                const std::vector<glm::dvec2>& features) {
  LUM_CHECK(region.size() >= 2, "one triangle needs no halves");
  Merging merging(sides, region, features);
  // First without crumbs, which a torn chart would otherwise shed one by one.
  merging.run({.small = ChartOptions{}.tiny, .fewest = 2});
  merging.run({.fewest = 2});
  const std::vector<std::uint32_t> number = merging.numbers();
  std::array<Region, 2> halves;
  for (std::size_t i = 0; i < region.size(); ++i) halves[number[i] == number[0] ? 0 : 1].push_back(region[i]);
  return halves;
}

}  // namespace luminist
