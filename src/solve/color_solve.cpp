#include "solve/color_solve.h"

#include <cmath>

#include "solve/box_solve.h"

namespace luminist {
namespace {

constexpr int kReweightings = 3;
constexpr double kNormFloor = 0.01;  // of the mean residual: where the un-squared norm is rounded off

CellField compose(std::span<const Vec3> rest, std::span<const CellField* const> white, std::span<const Vec3> colors) {
  CellField picture(rest.begin(), rest.end());
  for (std::size_t k = 0; k < white.size(); ++k) {
    for (std::size_t c = 0; c < picture.size(); ++c) picture[c] += colors[k] * (*white[k])[c];
  }
  return picture;
}

/// One channel's normal equations over the lights that are free in it, solved in place.
void solve_channel(int channel, const SampleCells& cells, std::span<const Vec3> picture,
                   std::span<const CellField* const> white, std::span<const ColorRange> ranges,
                   std::span<const double> weights, std::span<Vec3> colors) {
  std::vector<std::size_t> unknown;
  for (std::size_t k = 0; k < white.size(); ++k) {
    if (ranges[k].free[static_cast<std::size_t>(channel)]) unknown.push_back(k);
  }
  const std::size_t n = unknown.size();
  if (n == 0) return;
  std::vector<double> a(n * n, 0.0);
  std::vector<double> b(n, 0.0);
  for (std::size_t c = 0; c < weights.size(); ++c) {
    double wanted = static_cast<double>(cells.target[c][channel]) - picture[c][channel];
    for (const std::size_t k : unknown) wanted += static_cast<double>(colors[k][channel]) * (*white[k])[c][channel];
    for (std::size_t i = 0; i < n; ++i) {
      const double left = weights[c] * (*white[unknown[i]])[c][channel];
      b[i] += left * wanted;
      for (std::size_t j = 0; j <= i; ++j) a[i * n + j] += left * (*white[unknown[j]])[c][channel];
    }
  }
  double trace = 0.0;
  for (std::size_t i = 0; i < n; ++i) trace += a[i * n + i];
  std::vector<double> x(n);
  std::vector<double> low(n);
  std::vector<double> high(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) a[j * n + i] = a[i * n + j];
    x[i] = colors[unknown[i]][channel];
    // Lights that look alike share what they cannot tell apart: a slight pull to where they are.
    const double ridge = 1e-7 * trace;
    a[i * n + i] += ridge;
    b[i] += ridge * x[i];
    low[i] = ranges[unknown[i]].low[static_cast<std::size_t>(channel)];
    high[i] = ranges[unknown[i]].high[static_cast<std::size_t>(channel)];
  }
  solve_box(a, b, low, high, x);
  for (std::size_t i = 0; i < n; ++i) colors[unknown[i]][channel] = static_cast<float>(x[i]);
}

}  // namespace

double cell_cost(const SampleCells& cells, std::span<const Vec3> picture, Norm norm) {
  double sum = 0.0;
  for (std::size_t c = 0; c < picture.size(); ++c) {
    const Vec3 r = picture[c] - cells.target[c];
    const double square = glm::dot(r, r);
    sum += cells.weight[c] * (norm == Norm::kUnsquared ? std::sqrt(square) : square);
  }
  return sum;
}

void solve_colors(const SampleCells& cells, std::span<const Vec3> rest, std::span<const CellField* const> white,
                  std::span<const ColorRange> ranges, Norm norm, std::span<Vec3> colors) {
  if (white.empty()) return;
  CellField picture = compose(rest, white, colors);
  double cost = cell_cost(cells, picture, norm);
  for (int round = 0; round < (norm == Norm::kUnsquared ? kReweightings : 1); ++round) {
    const double mean = cell_cost(cells, picture, Norm::kUnsquared);
    std::vector<double> weights(cells.weight);
    if (norm == Norm::kUnsquared) {
      for (std::size_t c = 0; c < weights.size(); ++c) {
        weights[c] /= glm::length(picture[c] - cells.target[c]) + kNormFloor * mean + 1e-12;
      }
    }
    std::vector<Vec3> trial(colors.begin(), colors.end());
    for (int channel = 0; channel < 3; ++channel) {
      solve_channel(channel, cells, picture, white, ranges, weights, trial);
    }
    CellField trial_picture = compose(rest, white, trial);
    const double trial_cost = cell_cost(cells, trial_picture, norm);
    if (!(trial_cost < cost)) return;
    const bool settled = trial_cost > 0.999 * cost;
    std::copy(trial.begin(), trial.end(), colors.begin());
    picture = std::move(trial_picture);
    cost = trial_cost;
    if (settled) return;
  }
}

}  // namespace luminist
