// The actions of a script that look further than one solve.
#include <cmath>

#include <fmt/format.h>

#include "studio/exploration_results.h"
#include "studio/script_runner.h"

namespace luminist {
namespace {

/// A whole number within its bounds, or the default.
template <class Number>
Result<void> read_whole(const Action& action, const char* field, double least, double most, Number& value) {
  LUM_TRY(const auto number, action.number(field));
  if (!number) return {};
  if (!(*number >= least && *number <= most && *number == std::floor(*number))) {
    return action.wrong(fmt::format("a whole number from {} to {} is wanted", least, most), field);
  }
  value = static_cast<Number>(*number);
  return {};
}

ExploreWatch explore_watch(const ScriptEvents& events) {
  if (!events.watch) return {};
  return [watch = events.watch](const ExploreProgress& progress) {
    SolveReport report;
    report.epsilon = progress.epsilon;
    return watch(report);
  };
}

Error stopped(const std::string& what) {
  return {ErrorKind::kCancelled, "stopped", "", "", what};
}

}  // namespace

Result<void> ScriptRunner::make_up(const Action& action) {
  LUM_TRY(const std::string light, action.needed_text("light"));
  LUM_TRY(const SolveOptions options, solve_options(action));
  LUM_TRY(const auto to, action.text("to"));
  LUM_TRY(const RemovalFacts facts, start_removal(*session_, light, options));
  LUM_TRY_VOID(session_->finish_solve(events_.watch));
  const SolveReport& report = session_->solved()->report;
  if (report.termination == Termination::kStopped) return export_stopped();
  if (to) {
    LUM_TRY_VOID(write_removal(*session_, facts, output_ / *to));
    if (events_.written) events_.written(output_ / *to);
  }
  if (events_.solved) events_.solved(*session_->solved(), session_->shown());
  return {};
}

Result<void> ScriptRunner::alternatives(const Action& action) {
  AlternativesOptions options;
  LUM_TRY(const auto within, action.number("within"));
  LUM_TRY(const auto to, action.text("to"));
  LUM_TRY_VOID(read_whole(action, "count", 2, 64, options.count));
  LUM_TRY_VOID(read_whole(action, "tries", 1, 10000, options.tries));
  LUM_TRY_VOID(read_whole(action, "seed", 0, 9e15, options.seed));
  std::size_t take = 0;
  LUM_TRY_VOID(read_whole(action, "take", 1, 64, take));
  if (within && !(*within >= 1.0)) return action.wrong("a number from 1 is wanted", "within");
  options.factor = within.value_or(options.factor);
  LUM_TRY(const Alternatives found, find_alternatives(*session_, options, explore_watch(events_)));
  if (to) {
    LUM_TRY_VOID(write_alternatives(*session_, found, output_ / *to));
    if (events_.written) events_.written(output_ / *to);
  }
  if (found.stopped) return stopped(to ? "what was found is in " + (output_ / *to).string() : "");
  if (take > found.list.size()) {
    return action.wrong(fmt::format("{} were found", found.list.size()), "take");
  }
  return take > 0 ? propose(*session_, found.list[take - 1]) : Result<void>();
}

Result<void> ScriptRunner::diet(const Action& action) {
  DietOptions options;
  LUM_TRY(const auto budget, action.text("budget"));
  LUM_TRY(const auto to, action.text("to"));
  LUM_TRY(const auto take, action.flag("take"));
  LUM_TRY_VOID(read_whole(action, "fewest", 1, 10000, options.fewest));
  LUM_TRY_VOID(read_whole(action, "breadth", 1, 10000, options.breadth));
  LUM_TRY_VOID(read_whole(action, "seed", 0, 9e15, options.seed));
  if (budget) {
    LUM_TRY(options.budget, parse_budget(*budget));
  }
  LUM_TRY(const Diet found, find_diet(*session_, options, explore_watch(events_)));
  if (to) {
    LUM_TRY_VOID(write_diet(*session_, found, output_ / *to));
    if (events_.written) events_.written(output_ / *to);
  }
  if (found.stopped) return stopped(to ? "the sizes found so far are in " + (output_ / *to).string() : "");
  if (take.value_or(false)) propose(*session_, found, found.chosen);
  return {};
}

}  // namespace luminist
