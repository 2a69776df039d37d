#include "solve/box_solve.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace luminist {
namespace {

using Matrix = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
using Vector = Eigen::Map<const Eigen::VectorXd>;

enum class Side { kFree, kLow, kHigh, kUntouched };

struct BoxProblem {
  Matrix a;
  Vector b, low, high;
};

/// The step of the free coordinates to their minimum; empty if there is none.
Eigen::VectorXd free_step(const BoxProblem& box, const Eigen::VectorXd& gradient,
                          const std::vector<Eigen::Index>& open) {
  const auto m = static_cast<Eigen::Index>(open.size());
  Eigen::MatrixXd a(m, m);
  Eigen::VectorXd wanted(m);
  for (Eigen::Index i = 0; i < m; ++i) {
    wanted(i) = -gradient(open[static_cast<std::size_t>(i)]);
    for (Eigen::Index j = 0; j < m; ++j) {
      a(i, j) = box.a(open[static_cast<std::size_t>(i)], open[static_cast<std::size_t>(j)]);
    }
  }
  Eigen::VectorXd step = a.ldlt().solve(wanted);
  if (!step.allFinite() || step.dot(wanted) < 0.0) step.resize(0);
  return step;
}

/// Walks until a bound stops it. returns whether none did.
bool walk(const BoxProblem& box, const Eigen::VectorXd& step, const std::vector<Eigen::Index>& open, Eigen::VectorXd& x,
          std::vector<Side>& side) {
  double share = 1.0;
  Eigen::Index stopped = -1;
  for (std::size_t i = 0; i < open.size(); ++i) {
    const Eigen::Index k = open[i];
    const double change = step(static_cast<Eigen::Index>(i));
    const double room = change > 0.0 ? box.high(k) - x(k) : box.low(k) - x(k);
    if (change == 0.0 || share * std::abs(change) <= std::abs(room)) continue;
    share = std::abs(room / change);
    stopped = k;
  }
  for (std::size_t i = 0; i < open.size(); ++i) {
    const Eigen::Index k = open[i];
    const double change = step(static_cast<Eigen::Index>(i));
    x(k) = std::clamp(x(k) + share * change, box.low(k), box.high(k));
    if (k == stopped) {
      side[static_cast<std::size_t>(k)] = change > 0.0 ? Side::kHigh : Side::kLow;
      x(k) = change > 0.0 ? box.high(k) : box.low(k);
    }
  }
  return stopped < 0;
}

/// Lets go of the coordinate that would gain most by leaving its bound. returns whether there was one.
bool let_go(const BoxProblem& box, const Eigen::VectorXd& gradient, std::vector<Side>& side) {
  double most = 1e-12 * gradient.cwiseAbs().maxCoeff();
  Eigen::Index chosen = -1;
  for (Eigen::Index k = 0; k < gradient.size(); ++k) {
    const Side at = side[static_cast<std::size_t>(k)];
    if (at != Side::kLow && at != Side::kHigh) continue;
    if (!(box.high(k) > box.low(k))) continue;
    const double inwards = at == Side::kLow ? -gradient(k) : gradient(k);
    const double gain = inwards / std::sqrt(box.a(k, k));
    if (inwards > 0.0 && gain > most) {
      most = gain;
      chosen = k;
    }
  }
  if (chosen < 0) return false;
  side[static_cast<std::size_t>(chosen)] = Side::kFree;
  return true;
}

}  // namespace

void solve_box(std::span<const double> a, std::span<const double> b, std::span<const double> low,
               std::span<const double> high, std::span<double> x) {
  if (x.empty()) return;
  const auto n = static_cast<Eigen::Index>(x.size());
  const BoxProblem box{Matrix(a.data(), n, n), Vector(b.data(), n), Vector(low.data(), n), Vector(high.data(), n)};
  Eigen::VectorXd at(n);
  std::vector<Side> side(x.size(), Side::kFree);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    at(k) = std::clamp(x[i], low[i], high[i]);
    if (!(box.a(k, k) > 0.0)) side[i] = Side::kUntouched;
  }
  const int most = 20 + 4 * static_cast<int>(x.size());  // each change of the set gains; this many are plenty
  for (int change = 0; change < most; ++change) {
    Eigen::VectorXd gradient = box.a * at - box.b;
    std::vector<Eigen::Index> open;
    for (Eigen::Index k = 0; k < n; ++k) {
      if (side[static_cast<std::size_t>(k)] == Side::kFree) open.push_back(k);
    }
    if (!open.empty()) {
      const Eigen::VectorXd step = free_step(box, gradient, open);
      if (step.size() == 0) break;
      if (!walk(box, step, open, at, side)) continue;
      gradient = box.a * at - box.b;
    }
    if (!let_go(box, gradient, side)) break;
  }
  for (Eigen::Index k = 0; k < n; ++k) x[static_cast<std::size_t>(k)] = at(k);
}

}  // namespace luminist
