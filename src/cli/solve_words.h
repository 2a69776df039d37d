#pragma once
// cli/solve_words.h -- what `solve` was asked for, and how it says and writes what came of it.
#include <optional>
#include <string>

#include "cli/shot_words.h"
#include "cli/task_words.h"

namespace luminist {

struct SolveWords {
  ShotWords shot;
  PaintWords paint;
  LockWords locks;
  std::string solver = "auto";
  std::optional<double> seconds;
  SolveOptions options;
  std::optional<double> until;
  std::string output;
  bool together = false;
  std::vector<std::string> views;  ///< as typed; of solve_views()
  bool keys = false;               ///< what was solved becomes keys at the shot's frame
  bool json = false;
};

/// "fast: error 0.01, was 0.3; ..." of a report.
std::string report_line(const SolveReport& report);
/// A line "lights/key: color=1,1,1 ..." for each block of a state that has something unlocked, but the style's if
/// `without_style`.
void print_free_values(Console& console, const ParamState& state, bool without_style);
/// The report of one solve; with --json nothing.
void print_solved(Console& console, const Solved& solved, const ParamState& state);

/// What the solve found, also where an error ended it: the error is the result then.
Result<void> write_proposal(Session& session, const std::string& folder, Result<void> solved);

/// One solve in a session, judged unless it was interrupted, and written into a folder. errors the solve's.
Result<void> solve_into(Session& session, const SolveWords& words, const std::string& folder, VerbContext& context);

}  // namespace luminist
