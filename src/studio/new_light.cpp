#include "studio/new_light.h"

namespace luminist {

std::vector<std::string> waiting_lights(const LightRig& rig) {
  std::vector<std::string> names;
  for (const Light& light : rig.lights) {
    const ParamSchema& schema = light.params.schema();
    const auto color = schema.by_role("color");
    if (light.muted || !color || light.params.vec3(*color) != Vec3(0.0F)) continue;
    if (!light.params.locked(schema[*color].first_dof)) names.push_back(light.name);
  }
  return names;
}

}  // namespace luminist
