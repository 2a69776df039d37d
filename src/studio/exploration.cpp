#include "studio/exploration.h"

#include <utility>

#include <fmt/format.h>

#include "params/param_text.h"

namespace luminist {

namespace {

MakeUp who_makes_up(const Session& session) {
  return session.locks_chosen() ? MakeUp::kUnlocked : MakeUp::kUnlockedOrByType;
}

}  // namespace

Result<RemovalFacts> start_removal(Session& session, const std::string& light, const SolveOptions& options) {
  LUM_TRY(RemovalTask task, removal_task(*session.stage().renderer, session.state(), light, who_makes_up(session)));
  LUM_TRY_VOID(session.start_solve(std::move(task.start), std::move(task.target), options, "Make up for " + light));
  return std::move(task.facts);
}

Result<Alternatives> find_alternatives(Session& session, const AlternativesOptions& options,
                                       const ExploreWatch& watch) {
  if (!session.painted()) {
    return Error{ErrorKind::kNothingToDo, "nothing is painted", "", "", "paint the light that you want to see"};
  }
  LUM_TRY(const Target* target, session.target());
  return find_alternatives(*session.stage().renderer, session.state(), *target, options, watch);
}

Result<ErrorBudget> parse_budget(const std::string& text) {
  const bool of_black = text.ends_with('%');
  const auto value = parse_number(std::string_view(text).substr(0, text.size() - (of_black ? 1 : 0)));
  if (!value || *value < 0.0) {
    return Error{ErrorKind::kUsage, fmt::format("\"{}\" is no budget", text), "", "budget",
                 "write 5% for a share of the picture, or an error as 0.002"};
  }
  return ErrorBudget{of_black ? *value / 100.0 : *value, of_black};
}

Result<Diet> find_diet(Session& session, const DietOptions& options, const ExploreWatch& watch) {
  DietOptions as_locked = options;
  as_locked.who = who_makes_up(session);
  return light_diet(*session.stage().renderer, session.state(), as_locked, watch);
}

Result<void> propose(Session& session, const Alternative& found) {
  LUM_TRY(const Target* target, session.target());
  session.propose(found.state, {{}, found.report, *target, "Accept an alternative"});
  return {};
}

void propose(Session& session, const Diet& diet, std::size_t step) {
  SolveReport report;
  report.solver = "fast";
  report.termination = Termination::kConverged;
  report.epsilon_start = diet.steps[step].epsilon_removed;
  report.epsilon = diet.steps[step].epsilon;
  session.propose(diet.steps[step].state,
                  {{}, report, diet.target, fmt::format("Keep {} lights", diet.steps[step].state.rig.lights.size())});
}

}  // namespace luminist
