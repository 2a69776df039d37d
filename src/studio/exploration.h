#pragma once
// studio/exploration.h -- a session looks further: other lights for the same paint, the same picture with fewer lights.
#include <string>

#include "explore/alternatives.h"
#include "explore/light_diet.h"
#include "studio/session.h"

namespace luminist {

/// A light goes, and a solve begins in which the others make up for it: finish_solve(), accept() and revert() as with
/// any. The target is the picture of the lights in force; paint plays no part. errors those of removal_task().
Result<RemovalFacts> start_removal(Session& session, const std::string& light, const SolveOptions& options);

/// Good solutions of what is painted. Changes nothing. errors kNothingToDo without paint; those of the search.
Result<Alternatives> find_alternatives(Session& session, const AlternativesOptions& options, const ExploreWatch& watch);

/// "5%" is a share of what a black picture would be off, "0.002" an epsilon. errors kUsage.
Result<ErrorBudget> parse_budget(const std::string& text);

/// The lights in force, fewer and fewer. Changes nothing. errors those of light_diet().
Result<Diet> find_diet(Session& session, const DietOptions& options, const ExploreWatch& watch);

/// What was found becomes the session's proposal.
Result<void> propose(Session& session, const Alternative& found);
void propose(Session& session, const Diet& diet, std::size_t step);

}  // namespace luminist
