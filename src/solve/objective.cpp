#include "solve/objective.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace luminist {
namespace {

UnitMap map_of(const ParamState& state, const SceneFrame& frame) {
  const std::vector<const ParamBlock*> blocks = state.blocks();
  return UnitMap::create(blocks, frame);
}

}  // namespace

std::vector<int> moving_lights(const ParamState& state, const UnitMap& map) {
  const int lights = static_cast<int>(state.rig.lights.size());
  std::vector<int> moving;
  bool all = false;
  for (const Dof& dof : map.list()) {
    if (dof.block < 1 || dof.block > lights) {
      all = true;
      continue;
    }
    for (const Tie& tie : tied_to(state.rig, static_cast<std::size_t>(dof.block - 1), dof.param)) {
      all = all || state.rig.lights[tie.light].name == state.rig.shadow_light;
      moving.push_back(static_cast<int>(tie.light));
    }
  }
  if (all) {
    moving.resize(static_cast<std::size_t>(lights));
    std::iota(moving.begin(), moving.end(), 0);
  }
  std::sort(moving.begin(), moving.end());
  moving.erase(std::unique(moving.begin(), moving.end()), moving.end());
  return moving;
}

Objective::Objective(Renderer& renderer, ParamState centre, const Target& target)
    : renderer_(&renderer), target_(&target), centre_(std::move(centre)), map_(map_of(centre_, renderer.frame())) {
  moving_ = moving_lights(centre_, map_);
}

Result<double> Objective::evaluate(std::span<const double> x) {
  LUM_CHECK(static_cast<int>(x.size()) == dofs(), "x has one number per unlocked degree of freedom");
  LUM_TRY(const double error, renderer_->error(state(x), *target_, moving_));
  const double epsilon = error + penalty(x);
  return std::isfinite(epsilon) ? epsilon : std::numeric_limits<double>::infinity();
}

std::vector<double> Objective::unit(const ParamState& state) const {
  const std::vector<const ParamBlock*> blocks = state.blocks();
  return map_.to_unit(blocks);
}

ParamState Objective::state(std::span<const double> x) const {
  ParamState result = centre_;
  const std::vector<ParamBlock*> blocks = result.blocks();
  map_.from_unit(x, blocks);
  keep_constraints(result.rig);
  return result;
}

double penalty_of(const ParamState& state, const SceneFrame& frame) {
  const std::vector<const ParamBlock*> blocks = state.blocks();
  return penalty(UnitMap::create(blocks, frame).to_unit(blocks));
}

void Objective::recentre(const ParamState& state) {
  centre_ = state;
  map_ = map_of(centre_, renderer_->frame());
}

}  // namespace luminist
