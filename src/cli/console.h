#pragma once
// cli/console.h -- what the program says: results on stdout, everything else on stderr.
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/result.h"
#include "solve/solve_session.h"
#include "verdict/verdict.h"

namespace luminist {

class Console {
 public:
  /// Objects instead of lines.
  void use_json(bool json) { json_ = json; }
  [[nodiscard]] bool json() const { return json_; }

  /// A line of the result. A reader that went away is no fault.
  void result(std::string_view line);
  /// One line a stroke, and what bounds the error where a stroke is not met.
  void result(const Verdict& verdict);
  /// errors kUnwritable if a result could not be written (a full disk).
  [[nodiscard]] Result<void> finish();

  void warn(const Diagnostics& diagnostics);
  /// One line that replaces the last one; only on a terminal.
  void progress(const std::string& line);
  void progress(const SolveReport& report);
  /// The one error line.
  void error(const Error& error);

 private:
  void clear_progress();
  bool json_ = false;
  bool progress_shown_ = false;
  std::string fault_;  ///< why a result could not be written
};

}  // namespace luminist
