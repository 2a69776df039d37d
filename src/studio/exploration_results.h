#pragma once
// studio/exploration_results.h -- what was found beyond one solve, as files: rigs, pictures, a contact sheet, a report.
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "studio/exploration.h"

namespace luminist {

/// folder/1, folder/2... with the results of each (write_results()), contact_sheet.png and report.json. The sheet shows
/// what was painted, then each picture, where its error is, and where its lights stand.
/// errors the renderer's, kUnwritable, kChild.
Result<void> write_alternatives(Session& session, const Alternatives& found, const std::filesystem::path& folder);
/// {"limit", "tried", "good", "stopped", "alternatives": [{"rig", "distance", and the fields of solve_to_json()}]}
nlohmann::json alternatives_to_json(const Alternatives& found);

/// The results of the session's proposal, contact_sheet.png and report.json; the sheet shows the picture with the
/// light, just without it, and made up for. errors as above; kNothingToDo without a proposal.
Result<void> write_removal(Session& session, const RemovalFacts& facts, const std::filesystem::path& folder);
/// {"light", "epsilon_removed", "epsilon", "black", "shadow_share", "shadows_matter", and the fields of
/// solve_to_json()}
nlohmann::json removal_to_json(const RemovalFacts& facts, const SolveReport& report, const ParamState& lights);

/// folder/N_lights with the results of each size, contact_sheet.png and report.json. errors as above.
Result<void> write_diet(const Session& session, const Diet& diet, const std::filesystem::path& folder);
/// {"budget", "black", "chosen", "stopped", "sizes": [{"lights": [names], "removed", "epsilon_removed", "epsilon",
/// "share", "on_front", "within_budget", "rig"}]}
nlohmann::json diet_to_json(const Diet& diet);

/// "6 lights, without fill: error 0.00031 (0.4 % of the picture)"
std::string diet_line(const Diet& diet, std::size_t step);

}  // namespace luminist
