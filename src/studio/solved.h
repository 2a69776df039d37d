#pragma once
// studio/solved.h -- a solve that ran, and what it was asked for.
#include <optional>
#include <string>

#include "solve/solve_session.h"
#include "verdict/verdict.h"

namespace luminist {

struct Solved {
  SolveOptions options;
  SolveReport report;
  Target target;
  std::string label = "Accept a solve";           ///< of the command that accepting it makes
  std::optional<Verdict> verdict = std::nullopt;  ///< empty until Session::judge()
};

}  // namespace luminist
