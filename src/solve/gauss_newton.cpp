#include "solve/gauss_newton.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "solve/box_solve.h"

namespace luminist {
namespace {

/// Where the un-squared norm is rounded off, of the mean residual. Rounder than the norm asks for: a few cells with
/// tiny residuals would otherwise hold all the others back, and descents took three times as many iterations.
constexpr double kNormFloor = 0.3;

}  // namespace

struct GaussNewton::Slopes {
  Eigen::MatrixXd normal;    // J'WJ
  Eigen::VectorXd gradient;  // J'Wr
};

GaussNewton::GaussNewton(const CellProblem& problem, CellPoint start, const Vec3& focus,
                         const GaussNewtonOptions& options)
    : problem_(&problem), point_(std::move(start)), focus_(focus), options_(options), damping_(options.damping) {}

Result<std::vector<CellField>> GaussNewton::columns(const AimMap& map) const {
  const std::vector<double>& x0 = map.origin();
  const std::vector<Dof>& list = map.units().list();
  std::vector<ParamState> states;
  std::vector<double> steps;
  states.reserve(list.size());
  for (std::size_t k = 0; k < list.size(); ++k) {
    const ParamBlock& block = *point_.state.blocks()[static_cast<std::size_t>(list[k].block)];
    const bool moves = block.schema()[list[k].param].role == "position";
    double step = moves ? problem_->level().position_step : problem_->level().step;
    if (x0[k] + step > 1.0) step = -step;
    std::vector<double> x = x0;
    x[k] += step;
    steps.push_back(step);
    states.push_back(map.at(x));
  }
  std::vector<CellProblem::Request> requests;
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (problem_->parts().scaled_by(list[k]) >= 0) continue;
    for (const int part : problem_->parts().touched_by(point_.state, list[k])) requests.push_back({&states[k], part});
  }
  LUM_TRY(const std::vector<CellField> fields, problem_->evaluate(requests));

  std::vector<CellField> columns;
  std::size_t next = 0;
  for (std::size_t k = 0; k < list.size(); ++k) {
    CellField column(static_cast<std::size_t>(problem_->level().cells.size()), Vec3(0.0F));
    const auto inverse = static_cast<float>(1.0 / steps[k]);
    if (const int part = problem_->parts().scaled_by(list[k]); part >= 0) {
      const Part& scaled = problem_->parts().list()[static_cast<std::size_t>(part)];
      const Vec3 slope = (part_color(states[k], scaled) - part_color(point_.state, scaled)) * inverse;
      const CellField white = problem_->white(point_, part);
      for (std::size_t c = 0; c < column.size(); ++c) column[c] = slope * white[c];
    } else {
      for (const int touched : problem_->parts().touched_by(point_.state, list[k])) {
        const auto index = static_cast<std::size_t>(touched);
        const Vec3 color = part_color(point_.state, problem_->parts().list()[index]) * inverse;
        const CellField& moved = fields[next++];
        for (std::size_t c = 0; c < column.size(); ++c) column[c] += color * (moved[c] - point_.fields[index][c]);
      }
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

Result<GaussNewton::Slopes> GaussNewton::slopes(const AimMap& map) const {
  LUM_TRY(const std::vector<CellField> fields, columns(map));
  const SampleCells& cells = problem_->level().cells;
  const CellField picture = problem_->picture(point_);
  const double mean = cell_cost(cells, picture, Norm::kUnsquared);
  const auto rows = static_cast<Eigen::Index>(3 * cells.target.size());
  Eigen::MatrixXd jacobian(rows, static_cast<Eigen::Index>(fields.size()));
  Eigen::VectorXd residual(rows);
  for (std::size_t c = 0; c < cells.target.size(); ++c) {
    const Vec3 r = picture[c] - cells.target[c];
    double weight = cells.weight[c];
    if (problem_->norm() == Norm::kUnsquared) weight /= glm::length(r) + kNormFloor * mean + 1e-12;
    const double root = std::sqrt(weight);
    for (int channel = 0; channel < 3; ++channel) {
      const Eigen::Index row = static_cast<Eigen::Index>(3 * c) + channel;
      residual(row) = root * r[channel];
      for (std::size_t k = 0; k < fields.size(); ++k) {
        jacobian(row, static_cast<Eigen::Index>(k)) = root * fields[k][c][channel];
      }
    }
  }
  const auto n = static_cast<Eigen::Index>(fields.size());
  Slopes slopes{Eigen::MatrixXd::Zero(n, n), jacobian.transpose() * residual};
  slopes.normal.selfadjointView<Eigen::Lower>().rankUpdate(jacobian.transpose());
  slopes.normal.triangularView<Eigen::StrictlyUpper>() = slopes.normal.transpose();
  return slopes;
}

std::vector<double> GaussNewton::step(const AimMap& map, const Slopes& slopes) const {
  const std::vector<double>& x0 = map.origin();
  const std::size_t n = x0.size();
  const double floor = 1e-6 * slopes.normal.diagonal().maxCoeff() + 1e-30;
  std::vector<double> a(n * n);
  std::vector<double> b(n);
  std::vector<double> low(n);
  std::vector<double> high(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t j = 0; j < n; ++j) a[i * n + j] = slopes.normal(row, static_cast<Eigen::Index>(j));
    a[i * n + i] += damping_ * std::max(a[i * n + i], floor) + 1e-12 * floor;
    b[i] = -slopes.gradient(row);
    // Colours may go any way: the trial solves them anyway.
    const bool color = problem_->parts().scaled_by(map.units().list()[i]) >= 0;
    low[i] = color ? -x0[i] : std::max(-x0[i], -options_.largest_step);
    high[i] = color ? 1.0 - x0[i] : std::min(1.0 - x0[i], options_.largest_step);
  }
  std::vector<double> x(n, 0.0);
  solve_box(a, b, low, high, x);
  for (std::size_t k = 0; k < n; ++k) x[k] = std::clamp(x0[k] + x[k], 0.0, 1.0);
  return x;
}

Result<bool> GaussNewton::improve(const AimMap& map, const Slopes& slopes) {
  for (int attempt = 0; attempt < options_.tries; ++attempt) {
    const std::vector<double> x = step(map, slopes);
    if (!x.empty()) {
      LUM_TRY(CellPoint trial, problem_->measure(map.at(x)));
      if (trial.cost < point_.cost) {
        const double gain = (point_.cost - trial.cost) / point_.cost;
        point_ = std::move(trial);
        damping_ = std::max(damping_ / 5.0, 1e-7);
        small_gains_ = gain < options_.enough_gain ? small_gains_ + 1 : 0;
        return small_gains_ < 2;
      }
    }
    damping_ = std::min(damping_ * (attempt < 2 ? 6.0 : 10.0), 1e7);
  }
  return false;
}

Result<bool> GaussNewton::iterate() {
  ++iterations_;
  if (!(point_.cost > 0.0)) return false;
  const AimMap map(point_.state, problem_->frame(), focus_);
  if (map.dofs() == 0) return false;
  LUM_TRY(const Slopes at, slopes(map));
  LUM_TRY(const bool more, improve(map, at));
  return more && iterations_ < problem_->level().iterations;
}

}  // namespace luminist
