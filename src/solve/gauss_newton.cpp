#include "solve/gauss_newton.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>

#include "solve/box_solve.h"

namespace luminist {
namespace {

/// Where the un-squared norm is rounded off, of the mean residual. Rounder than the norm asks for: a few cells with
/// tiny residuals would otherwise hold all the others back, and descents take three times as many iterations.
constexpr double kResidualFloor = 0.3;

constexpr double kLeastDamping = 1e-8;

}  // namespace

struct GaussNewton::Equations {
  std::vector<std::size_t> turned;  // coordinates of the map
  Eigen::MatrixXd normal;           // J'WJ
  Eigen::VectorXd gradient;         // J'Wr
};

GaussNewton::GaussNewton(const CellProblem& problem, CellPoint start, const Vec3& focus,
                         const GaussNewtonOptions& options)
    : problem_(&problem), point_(std::move(start)), focus_(focus), options_(options), damping_(options.damping) {}

bool GaussNewton::turns(const Dof& dof) const {
  return options_.block < 0 || dof.block == options_.block || problem_->parts().color_of(dof) >= 0;
}

Result<void> GaussNewton::measure_slopes(const AimMap& map) {
  const std::vector<Dof>& list = map.units().list();
  std::vector<ParamState> states;
  states.reserve(list.size());
  std::vector<double> steps(list.size(), 0.0);
  std::vector<CellProblem::Request> requests;
  slopes_.clear();
  touched_.clear();
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (!turns(list[k]) || problem_->parts().color_of(list[k]) >= 0) continue;
    const ParamBlock& block = *point_.state.blocks()[static_cast<std::size_t>(list[k].block)];
    const bool moves = block.schema()[list[k].param].role == "position";
    steps[k] = moves ? problem_->level().position_step : problem_->level().step;
    if (map.origin()[k] + steps[k] > 1.0) steps[k] = -steps[k];
    std::vector<double> x = map.origin();
    x[k] += steps[k];
    states.push_back(map.at(x));
    for (const int part : problem_->parts().touched_by(point_.state, list[k])) {
      if (std::ranges::find(touched_, part) == touched_.end()) touched_.push_back(part);
      if (problem_->parts().list()[static_cast<std::size_t>(part)].rest != part) continue;
      requests.push_back({&states.back(), part, true});
      slopes_.push_back({k, part, {}});
    }
  }
  LUM_TRY(std::vector<CellField> fields, problem_->evaluate(requests));
  for (std::size_t i = 0; i < slopes_.size(); ++i) {
    const CellField here = problem_->together(point_, slopes_[i].part);
    const auto inverse = static_cast<float>(1.0 / steps[slopes_[i].coordinate]);
    for (std::size_t c = 0; c < here.size(); ++c) fields[i][c] = (fields[i][c] - here[c]) * inverse;
    slopes_[i].field = std::move(fields[i]);
  }
  return {};
}

void GaussNewton::correct_slopes(const CellPoint& before, std::span<const double> step) {
  for (const int part : touched_) {
    double square = 0.0;
    for (const Slope& slope : slopes_)
      square += slope.part == part ? step[slope.coordinate] * step[slope.coordinate] : 0.0;
    if (!(square > 1e-12)) continue;
    CellField missed = problem_->together(point_, part);
    const CellField was = problem_->together(before, part);
    for (std::size_t c = 0; c < missed.size(); ++c) missed[c] -= was[c];
    for (const Slope& slope : slopes_) {
      if (slope.part != part) continue;
      const auto by = static_cast<float>(step[slope.coordinate]);
      for (std::size_t c = 0; c < missed.size(); ++c) missed[c] -= by * slope.field[c];
    }
    for (Slope& slope : slopes_) {
      if (slope.part != part) continue;
      const auto share = static_cast<float>(step[slope.coordinate] / square);
      for (std::size_t c = 0; c < missed.size(); ++c) slope.field[c] += share * missed[c];
    }
  }
}

std::vector<CellField> GaussNewton::columns(const AimMap& map, std::span<const std::size_t> turned) const {
  const CellField nothing(static_cast<std::size_t>(problem_->level().cells.size()), Vec3(0.0F));
  std::vector<CellField> columns(turned.size(), nothing);
  for (std::size_t i = 0; i < turned.size(); ++i) {
    const int color = problem_->parts().color_of(map.units().list()[turned[i]]);
    if (color < 0) continue;
    std::vector<double> x = map.origin();
    const double step = x[turned[i]] < 0.5 ? problem_->level().step : -problem_->level().step;
    x[turned[i]] += step;
    const PartColor& scaling = problem_->parts().colors()[static_cast<std::size_t>(color)];
    const auto value = [&](const ParamState& state) {
      return state.blocks()[static_cast<std::size_t>(scaling.block)]->vec3(scaling.param);
    };
    const Vec3 slope = (value(map.at(x)) - value(point_.state)) * static_cast<float>(1.0 / step);
    const CellField white = problem_->white(point_, color);
    for (std::size_t c = 0; c < white.size(); ++c) columns[i][c] = slope * white[c];
  }
  for (const Slope& slope : slopes_) {
    const auto i = static_cast<std::size_t>(std::ranges::lower_bound(turned, slope.coordinate) - turned.begin());
    const Part& part = problem_->parts().list()[static_cast<std::size_t>(slope.part)];
    const Vec3 color = part_color_without(point_.state, part, true);
    for (std::size_t c = 0; c < slope.field.size(); ++c) columns[i][c] += color * slope.field[c];
  }
  return columns;
}

GaussNewton::Equations GaussNewton::equations(const AimMap& map) const {
  Equations equations;
  const std::vector<Dof>& list = map.units().list();
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (turns(list[k])) equations.turned.push_back(k);
  }
  const std::vector<CellField> fields = columns(map, equations.turned);
  const SampleCells& cells = problem_->level().cells;
  const CellField picture = problem_->picture(point_);
  const double mean = cell_cost(cells, picture, Norm::kUnsquared);
  const auto rows = static_cast<Eigen::Index>(3 * cells.target.size());
  Eigen::MatrixXd jacobian(rows, static_cast<Eigen::Index>(fields.size()));
  Eigen::VectorXd residual(rows);
  for (std::size_t c = 0; c < cells.target.size(); ++c) {
    const Vec3 r = picture[c] - cells.target[c];
    double weight = cells.weight[c];
    if (problem_->norm() == Norm::kUnsquared) weight /= glm::length(r) + kResidualFloor * mean + 1e-12;
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
  equations.normal = Eigen::MatrixXd::Zero(n, n);
  equations.normal.selfadjointView<Eigen::Lower>().rankUpdate(jacobian.transpose());
  equations.normal.triangularView<Eigen::StrictlyUpper>() = equations.normal.transpose();
  equations.gradient = jacobian.transpose() * residual;
  return equations;
}

std::vector<double> GaussNewton::step(const AimMap& map, const Equations& equations, double damping) const {
  const std::vector<double>& x0 = map.origin();
  const std::size_t n = equations.turned.size();
  const double floor = 1e-6 * equations.normal.diagonal().maxCoeff() + 1e-30;
  std::vector<double> a(n * n);
  std::vector<double> b(n);
  std::vector<double> low(n);
  std::vector<double> high(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const std::size_t k = equations.turned[i];
    for (std::size_t j = 0; j < n; ++j) a[i * n + j] = equations.normal(row, static_cast<Eigen::Index>(j));
    a[i * n + i] += damping * std::max(a[i * n + i], floor) + 1e-12 * floor;
    b[i] = -equations.gradient(row);
    // Colours may go any way: the trial solves them anyway.
    const bool color = problem_->parts().color_of(map.units().list()[k]) >= 0;
    low[i] = color ? -x0[k] : std::max(-x0[k], -options_.largest_step);
    high[i] = color ? 1.0 - x0[k] : std::min(1.0 - x0[k], options_.largest_step);
  }
  std::vector<double> moved(n, 0.0);
  solve_box(a, b, low, high, moved);
  std::vector<double> step(x0.size(), 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = equations.turned[i];
    step[k] = std::clamp(x0[k] + moved[i], 0.0, 1.0) - x0[k];
  }
  return step;
}

Result<double> GaussNewton::improve(const AimMap& map, int tries) {
  constexpr double kEase = 8.0;
  const Equations here = equations(map);
  const bool partly = options_.block >= 0;
  std::optional<CellPoint> best;
  std::vector<double> best_step;
  double best_damping = damping_;
  double damping = damping_;
  for (int attempt = 0; attempt < tries; ++attempt) {
    std::vector<double> moved = step(map, here, damping);
    std::vector<double> x = map.origin();
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += moved[k];
    LUM_TRY(std::vector<CellPoint> trial, problem_->measure({map.at(x)}, partly ? &point_ : nullptr, touched_));
    if (trial.front().cost < (best ? best->cost : point_.cost)) {
      best = std::move(trial.front());
      best_step = std::move(moved);
      best_damping = damping;
      if (damping > damping_ || !options_.eager) break;
      damping = damping / kEase;
    } else if (best) {
      break;
    } else {
      damping *= attempt < 2 ? 6.0 : 10.0;
    }
  }
  damping_ = std::clamp(best ? best_damping / 3.0 : damping, kLeastDamping, 1e7);
  if (!best) return 0.0;
  const double gain = (point_.cost - best->cost) / point_.cost;
  std::swap(point_, *best);
  if (options_.secants > 0) correct_slopes(*best, best_step);
  return gain;
}

Result<bool> GaussNewton::iterate() {
  constexpr int kSecantTries = 3;
  constexpr double kSecantGain = 0.03;  // less: slopes are measured again
  if (!(point_.cost > 0.0)) return false;
  const AimMap map(point_.state, problem_->frame(), focus_);
  if (map.dofs() == 0) return false;
  const bool follows = iterations_ > 0 && secants_ < options_.secants;
  if (follows) {
    LUM_TRY(const double gain, improve(map, kSecantTries));
    secants_ = gain < kSecantGain ? options_.secants : secants_ + 1;
    return true;
  }
  ++iterations_;
  secants_ = 0;
  LUM_TRY_VOID(measure_slopes(map));
  LUM_TRY(const double gain, improve(map, options_.tries));
  small_gains_ = gain < options_.enough_gain ? small_gains_ + 1 : 0;
  if (gain < kSecantGain) secants_ = options_.secants;
  return gain > 0.0 && small_gains_ < 2 && iterations_ < problem_->level().iterations;
}

}  // namespace luminist
