#include "explore/locks.h"

#include <algorithm>

#include "base/check.h"

namespace luminist {

bool is_free(const Light& light) {
  if (light.muted) return false;
  for (int dof = 0; dof < light.params.schema().dofs(); ++dof) {
    if (!light.params.locked(dof)) return true;
  }
  return false;
}

ParamState with_free_lights(ParamState state, MakeUp who) {
  for (MaterialParams& material : state.materials) material.params.set_param_locked(-1, true);
  if (who == MakeUp::kUnlocked || std::any_of(state.rig.lights.begin(), state.rig.lights.end(), is_free)) return state;
  for (Light& light : state.rig.lights) {
    for (const ParamSpec& spec : light.params.schema().specs()) {
      for (int k = 0; k < spec.dofs(); ++k) light.params.set_locked(spec.first_dof + k, !spec.solve);
    }
  }
  return state;
}

std::optional<ParamState> with_only_colors_free(ParamState state) {
  state.rig.ambient.set_param_locked(-1, true);
  state.style.set_param_locked(-1, true);
  for (MaterialParams& material : state.materials) material.params.set_param_locked(-1, true);
  for (Light& light : state.rig.lights) {
    const ParamSchema& schema = light.params.schema();
    for (int param = 0; param < schema.size(); ++param) {
      if (schema[param].role != "color") light.params.set_param_locked(param, true);
    }
  }
  if (std::none_of(state.rig.lights.begin(), state.rig.lights.end(), is_free)) return std::nullopt;
  return state;
}

ParamState with_locks_of(ParamState values, const ParamState& locks) {
  const std::vector<ParamBlock*> to = values.blocks();
  const std::vector<const ParamBlock*> from = locks.blocks();
  LUM_CHECK(to.size() == from.size(), "both states have the same lights");
  for (std::size_t b = 0; b < to.size(); ++b) {
    for (int dof = 0; dof < to[b]->schema().dofs(); ++dof) to[b]->set_locked(dof, from[b]->locked_by_hand(dof));
  }
  return values;
}

}  // namespace luminist
