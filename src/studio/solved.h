#pragma once
// studio/solved.h -- a solve that ran, and what it was asked for.
#include <string>

#include "solve/solve_session.h"

namespace luminist {

struct Solved {
  SolveOptions options;
  SolveReport report;
  Target target;
  std::string label = "Accept a solve";  ///< of the command that accepting it makes
};

}  // namespace luminist
