#include "solve/sample_simplex.h"

#include <utility>

namespace luminist {
namespace {

std::vector<double> at(const std::vector<double>& x, const std::vector<std::size_t>& coordinates) {
  std::vector<double> chosen;
  for (const std::size_t k : coordinates) chosen.push_back(x[k]);
  return chosen;
}

}  // namespace

std::unique_ptr<SampleSimplex> SampleSimplex::create(const CellProblem& problem, const CellPoint& start, int block,
                                                     const Vec3& focus, double size) {
  AimMap map(start.state, problem.frame(), focus);
  std::vector<std::size_t> coordinates;
  for (std::size_t k = 0; k < map.origin().size(); ++k) {
    const Dof& dof = map.units().list()[k];
    if (dof.block == block && problem.parts().color_of(dof) < 0) coordinates.push_back(k);
  }
  if (coordinates.empty()) return nullptr;
  return std::unique_ptr<SampleSimplex>(
      new SampleSimplex(problem, start, std::move(map), std::move(coordinates), size));
}

SampleSimplex::SampleSimplex(const CellProblem& problem, const CellPoint& start, AimMap map,
                             std::vector<std::size_t> coordinates, double size)
    : problem_(&problem),
      start_(start),
      best_(start),
      map_(std::move(map)),
      coordinates_(std::move(coordinates)),
      simplex_(at(map_.origin(), coordinates_), {.size = size, .tolerance = 1e-3, .restarts = 1}),
      left_(40 + 20 * static_cast<int>(coordinates_.size())) {
  const int block = map_.units().list()[coordinates_.front()].block;
  touched_ = problem.parts().touched_by(start.state, map_.units(), {&block, 1});
}

Result<bool> SampleSimplex::walk(int points) {
  for (; points > 0 && left_ > 0 && !simplex_.done(); --points, --left_) {
    std::vector<double> x = map_.origin();
    for (std::size_t k = 0; k < coordinates_.size(); ++k) x[coordinates_[k]] = simplex_.point()[k];
    LUM_TRY(std::vector<CellPoint> point, problem_->measure({map_.at(x)}, &start_, touched_));
    point.front().cost += penalty(x);
    simplex_.tell(point.front().cost);
    if (point.front().cost < best_.cost) best_ = std::move(point.front());
  }
  return left_ > 0 && !simplex_.done();
}

}  // namespace luminist
