#include "bench/perturbation.h"

#include <algorithm>
#include <vector>

namespace luminist {

PerturbReach full_reach() {
  return {0.1, 0.5};
}

PerturbReach small_reach() {
  return {0.025, 0.125};
}

void unlock_roles(Light& light, std::span<const std::string_view> roles) {
  const ParamSchema& schema = light.params.schema();
  for (int param = 0; param < schema.size(); ++param) {
    const bool named = std::find(roles.begin(), roles.end(), schema[param].role) != roles.end();
    if (named && !schema[param].quality) light.params.set_param_locked(param, false);
  }
}

ParamState perturbed(const ParamState& original, const SceneFrame& frame, const PerturbReach& reach, Random& random) {
  ParamState result = original;
  const std::vector<const ParamBlock*> readable = original.blocks();
  const UnitMap map = UnitMap::create(readable, frame);
  std::vector<double> x = map.to_unit(readable);
  for (double& number : x) {
    const double step = random.uniform(reach.least, reach.most);
    const bool up = random.uniform() < 0.5;
    const bool fits = up ? number + step <= 1.0 : number - step >= 0.0;
    number += up == fits ? step : -step;
  }
  const std::vector<ParamBlock*> writable = result.blocks();
  map.from_unit(x, writable);
  return result;
}

}  // namespace luminist
