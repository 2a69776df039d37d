#pragma once
// studio/new_light.h -- a light that is asked for.
#include <string>
#include <vector>

#include "render/param_state.h"

namespace luminist {

struct NewLight {
  std::string type = "cinematic";
  std::string name = "light";  ///< "-2", "-3"... is appended if it is taken
  std::string group = "";
  bool from_paint = true;  ///< start where the paint says (paper, section 5.2); else at the type's defaults
  bool lock_others = true;
  bool dark =
      false;  ///< without colour, at the type's defaults: it waits for paint, and a solve begins where that says
};

/// Names of the lights that wait for paint: dark, not muted, their colour free.
std::vector<std::string> waiting_lights(const LightRig& rig);

}  // namespace luminist
