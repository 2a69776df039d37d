#include "cli/console.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace luminist {
namespace {

void say(const std::string& line) {
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fflush(stderr);
}

/// Text as JSON takes it: bytes that are not UTF-8 (of a file name) are replaced.
std::string dump(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

void Console::result(std::string_view line) {
  clear_progress();
  std::string text(line);
  text.push_back('\n');
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written && errno != EPIPE && fault_.empty()) fault_ = std::strerror(errno);
}

void Console::result(const Verdict& verdict) {
  for (const StrokeVerdict& stroke : verdict.strokes) result(verdict_line(stroke));
  std::string bounds;
  if (verdict.least_epsilon && *verdict.least_epsilon > 0.01 * verdict.epsilon) {
    bounds = fmt::format("certainly not below {:.5f}", *verdict.least_epsilon);
  }
  if (verdict.estimated_epsilon) {
    bounds += fmt::format("{}about {:.5f} with more lights (estimate)", bounds.empty() ? "" : "; ",
                          *verdict.estimated_epsilon);
  }
  if (!bounds.empty()) result(fmt::format("error {:.5f} with these locks: {}", verdict.epsilon, bounds));
}

Result<void> Console::finish() {
  clear_progress();
  if (fault_.empty()) return {};
  return Error{ErrorKind::kUnwritable, "cannot write the results: " + fault_, "stdout", "", "send them elsewhere"};
}

void Console::warn(const Diagnostics& diagnostics) {
  clear_progress();
  for (const Diagnostics::Warning& warning : diagnostics.warnings()) {
    say(json_ ? dump({{"warning", {{"where", warning.where}, {"what", warning.what}}}}) + "\n"
              : fmt::format("luminist: warning {}: {}\n", warning.where, warning.what));
  }
}

void Console::progress(const std::string& line) {
  if (json_ || ::isatty(STDERR_FILENO) == 0) return;
  say("\r\x1b[K" + line);
  progress_shown_ = true;
}

void Console::progress(const SolveReport& report) {
  progress(fmt::format("{:6.1f} s  error {:.5f}, was {:.5f}  {} pictures compared", report.seconds, report.error(),
                       report.error_start(), report.evals));
}

void Console::clear_progress() {
  if (progress_shown_) say("\r\x1b[K");
  progress_shown_ = false;
}

void Console::error(const Error& error) {
  clear_progress();
  if (!json_) {
    say("luminist: " + error.message() + "\n");
    return;
  }
  say(dump({{"error",
             {{"code", fmt::format("E{}", static_cast<int>(error.kind) * 100)},
              {"exit", static_cast<int>(error.kind)},
              {"what", error.what},
              {"where", error.where},
              {"field", error.field},
              {"hint", error.hint}}}}) +
      "\n");
}

}  // namespace luminist
