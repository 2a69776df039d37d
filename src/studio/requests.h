#pragma once
// studio/requests.h -- what is asked of a session, and what a solve was asked for.
#include <string>

#include "render/target.h"
#include "solve/solve_session.h"

namespace luminist {

struct NewLight {
  std::string type = "cinematic";
  std::string name = "light";  ///< "-2", "-3"... is appended if it is taken
  std::string group = "";
  bool from_paint = true;  ///< start where the paint says (paper, section 5.2); else at the type's defaults
  bool lock_others = true;
};

/// A solve that ran, and what it was asked for.
struct Solved {
  SolveOptions options;
  SolveReport report;
  Target target;
};

}  // namespace luminist
