// The actions of a script that solve and export, and the loop over its lines.
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "studio/script_runner.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kLogStart = R"({"hash":")";  // what a project's log begins with

/// An error of an action that does not say where, at the action's line.
Error placed(Error error, const std::string& line) {
  if (error.where.empty()) {
    error.where = line;
  } else if (error.where != line && !error.where.starts_with(line + ":")) {
    error.hint += fmt::format("{}in {}", error.hint.empty() ? "" : "; ", line);
  }
  return error;
}

}  // namespace

Result<SolveOptions> solve_options(const Action& action) {
  SolveOptions options;
  LUM_TRY(const auto solver, action.text("solver"));
  LUM_TRY(const auto seed, action.number("seed"));
  LUM_TRY(const auto max_evals, action.number("max_evals"));
  LUM_TRY(const auto until, action.number("until"));
  LUM_TRY(const auto restarts, action.number("restarts"));
  const std::string name = solver.value_or("auto");
  if (name != "auto" && name != "fast" && name != "simplex") {
    return action.wrong("auto, fast or simplex is wanted", "solver");
  }
  options.solver = name == "fast" ? SolverKind::kFast : name == "simplex" ? SolverKind::kSimplex : SolverKind::kAuto;
  const auto whole = [](double value, double most) {
    return value >= 0.0 && value <= most && value == std::floor(value);
  };
  if (!whole(seed.value_or(0.0), 9e15)) return action.wrong("a whole number from 0 is wanted", "seed");
  if (!whole(max_evals.value_or(1.0), std::numeric_limits<int>::max()) || max_evals.value_or(1.0) < 1.0) {
    return action.wrong("a whole number from 1 is wanted", "max_evals");
  }
  if (!whole(restarts.value_or(0.0), 1e6)) return action.wrong("a whole number from 0 is wanted", "restarts");
  if (until.value_or(0.0) < 0.0) return action.wrong("a number from 0 is wanted", "until");
  if (seed) options.seed = static_cast<std::uint64_t>(*seed);
  if (max_evals) options.max_evals = static_cast<int>(*max_evals);
  if (until) options.until = *until;
  if (restarts) options.restarts = static_cast<int>(*restarts);
  return options;
}

Result<void> ScriptRunner::solve(const Action& action) {
  using Clock = std::chrono::steady_clock;
  LUM_TRY(const SolveOptions options, solve_options(action));
  LUM_TRY(const auto seconds, action.number("seconds"));
  const auto start = Clock::now();
  bool cancelled = false;
  LUM_TRY_VOID(session_->solve(options, [&](const SolveReport& report) {
    cancelled = events_.watch && !events_.watch(report);
    const bool late = seconds && std::chrono::duration<double>(Clock::now() - start).count() > *seconds;
    return !cancelled && !late;
  }));
  if (cancelled) return export_stopped();
  const auto judged = session_->judge([&] {
    cancelled = cancelled || (events_.watch && !events_.watch(session_->solved()->report));
    return !cancelled;
  });
  if (cancelled) return export_stopped();
  if (!judged) return judged.error();
  if (events_.solved) events_.solved(*session_->solved(), session_->shown());
  return {};
}

Result<void> ScriptRunner::remedy(const Action& action) {
  LUM_TRY(const auto stroke, action.number("stroke"));
  if (!stroke || !(*stroke >= 1.0 && *stroke <= 1e9 && *stroke == std::floor(*stroke))) {
    return action.wrong("the number of a stroke is wanted", "stroke");
  }
  return session_->apply_remedy(static_cast<std::uint32_t>(*stroke));
}

/// The best so far; the error that ends the script.
Result<void> ScriptRunner::export_stopped() {
  LUM_TRY_VOID(export_to(output_ / "stopped", "stopped"));
  return Error{ErrorKind::kCancelled, "stopped", "", "", "the best so far is in " + (output_ / "stopped").string()};
}

Result<void> ScriptRunner::write(const Action& action) {
  LUM_TRY(const std::string name, action.needed_text("to"));
  LUM_TRY(const auto label, action.text("label"));
  return export_to(output_ / name, label.value_or(name));
}

Result<void> ScriptRunner::export_to(const fs::path& folder, const std::string& label) {
  LUM_TRY(Results results, collect_results(*session_));
  LUM_TRY_VOID(write_results(results, folder));
  rows_.push_back({label, {results.target, importance_picture(results.importance), results.picture}});
  if (events_.written) events_.written(folder);
  return {};
}

Result<void> ScriptRunner::replay_project(const fs::path& folder) {
  LUM_TRY(session_, Session::open_project(*device_, roots_, folder, Project::Access::kRead, *diagnostics_));
  return export_to(output_, folder.filename().string());
}

namespace {

/// The actions of a script's lines. errors Action's, at their line.
Result<std::vector<Action>> parse_lines(const std::string& text, const fs::path& path) {
  std::vector<Action> actions;
  std::size_t start = 0;
  for (int number = 1; start < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string line = text.substr(start, end - start);
    start = end + 1;
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    LUM_TRY(Action action, Action::parse(line, fmt::format("{}:{}", path.string(), number)));
    actions.push_back(std::move(action));
  }
  return actions;
}

}  // namespace

Result<void> run_script(Device& device, const AssetRoots& roots, const fs::path& path, const fs::path& output,
                        const ScriptEvents& events, Diagnostics& diagnostics,
                        const std::optional<LiveReplayOptions>& live) {
  std::error_code error;
  const bool is_folder = fs::is_directory(path, error);
  if (is_folder && !fs::exists(path / "log.jsonl", error)) {
    return Error{ErrorKind::kMissing, "the folder is no project: it has no log.jsonl", path.string(), "",
                 "give a NAME.lum"};
  }
  LUM_TRY(const std::string text, read_file(is_folder ? path / "log.jsonl" : path));
  LUM_TRY_VOID(make_folder(output));
  const fs::path folder = is_folder || path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (is_folder || text.starts_with(kLogStart)) {
    if (live) {
      return Error{ErrorKind::kUsage, "a project keeps what strokes did, not the strokes", path.string(), "--live",
                   "give an action script"};
    }
    ScriptRunner runner(device, roots, folder, output, events, diagnostics);
    return runner.replay_project(is_folder ? path : folder);
  }
  ScriptRunner runner(device, roots, folder, output, events, diagnostics, live ? live->scale : 1.0);
  LUM_TRY(const std::vector<Action> actions, parse_lines(text, path));
  if (actions.empty()) {
    return Error{ErrorKind::kNothingToDo, "the script has no action", path.string(), "", "see luminist replay --help"};
  }
  for (std::size_t i = 0; i < actions.size();) {
    const std::size_t group = live ? ScriptRunner::live_group(std::span(actions).subspan(i)) : 0;
    auto done = group > 0 ? runner.run_live(std::span(actions).subspan(i, group), *live) : runner.run(actions[i]);
    if (!done) return placed(std::move(done).error(), actions[i].where());
    i += std::max<std::size_t>(1, group);
  }
  return {};
}

}  // namespace luminist
