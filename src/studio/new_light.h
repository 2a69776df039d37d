#pragma once
// studio/new_light.h -- a light that is asked for.
#include <string>

namespace luminist {

struct NewLight {
  std::string type = "cinematic";
  std::string name = "light";  ///< "-2", "-3"... is appended if it is taken
  std::string group = "";
  bool from_paint = true;  ///< start where the paint says (paper, section 5.2); else at the type's defaults
  bool lock_others = true;
};

}  // namespace luminist
