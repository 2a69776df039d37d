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
    const int light = dof.block - 1;
    all = all || light < 0 || light >= lights ||
          state.rig.lights[static_cast<std::size_t>(light)].name == state.rig.shadow_light;
    if (moving.empty() || moving.back() != light) moving.push_back(light);
  }
  if (!all) return moving;
  moving.resize(static_cast<std::size_t>(lights));
  std::iota(moving.begin(), moving.end(), 0);
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

void Objective::recentre(const ParamState& state) {
  centre_ = state;
  map_ = map_of(centre_, renderer_->frame());
}

}  // namespace luminist
