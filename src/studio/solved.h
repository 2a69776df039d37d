#pragma once
// studio/solved.h -- a solve that ran, and what it was asked for.
#include <optional>
#include <string>
#include <vector>

#include "project/frame_paint.h"
#include "solve/solve_session.h"
#include "verdict/verdict.h"

namespace luminist {

/// What a solve of several frames or cameras came to at one of them.
struct SolvedFrame {
  Vantage at;
  double weight = 1.0;
  double start = 0.0;  ///< error before, without penalties
  double found = 0.0;
  std::optional<Verdict> verdict;  ///< of its strokes; empty if none was asked for
  Document accepted;               ///< its "paint/..." once the lights are accepted
};

struct Solved {
  SolveOptions options;
  SolveReport report;
  Target target;
  std::string label = "Accept a solve";           ///< of the command that accepting it makes
  std::optional<Verdict> verdict = std::nullopt;  ///< empty until Session::judge()
  std::vector<SolvedFrame> frames = {};           ///< of a solve of several (studio/shots.h)
};

}  // namespace luminist
