#pragma once
// studio/results.h -- what a shot comes to, as files.
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "studio/session.h"

namespace luminist {

/// The pictures of a step and the lights that make them. All of one size, linear.
struct Results {
  Image picture;
  Image target;
  Image importance;          ///< 1 channel
  Image residual;            ///< 1 channel, I |T - R|
  std::string rig;           ///< TOML
  std::string style_params;  ///< JSON: {parameter: value}, ready for --set style/PARAMETER=VALUE
  std::optional<SolveReport> report;
  std::optional<Verdict> verdict;
  std::string materials = {};  ///< JSON: {material: {parameter: value}} of those that are turned; "" if none is
};

/// Of what the session shows: the proposal or the lights in force. The target is what is painted, or else what the
/// last solve was for. errors the renderer's.
Result<Results> collect_results(Session& session);
/// Of lights that the session does not show. errors the renderer's. cost a picture.
Result<Results> collect_results(const Session& session, const ParamState& lights, const Target& target,
                                const std::optional<SolveReport>& report);

/// picture.{exr,png}, target.{exr,png}, importance.{exr,png} (black counts most, as in the paper's figures),
/// residual.{exr,png} (a heat map over its scale), rig.toml, style.json, materials.json if one is turned (else it is
/// removed), after a solve convergence.{jsonl,png}, and after a verdict verdict.json. errors kUnwritable, kChild.
Result<void> write_results(const Results& results, const std::filesystem::path& folder);

/// Importance as the paper prints it: 1 is black.
Image importance_picture(const Image& importance);

/// {"epsilon_start", "epsilon", "penalty_start", "penalty", "evals", "render_equivalents", "seconds", "solver",
/// "termination", "lights": [{"name", "type", "group", "muted", "objects", "unlocked", "params"}], "ambient":
/// {parameter: value}, "style": {parameter: value}, "materials": {material: {parameter: value}} of those that are
/// turned or free, "verdict" if there is one: verdict_to_json()}
nlohmann::json solve_to_json(const SolveReport& report, const ParamState& state,
                             const std::optional<Verdict>& verdict = std::nullopt);
/// One JSON object a line: render_equivalents, evals, seconds, epsilon.
std::string convergence_lines(const SolveReport& report);

/// A row of a contact sheet.
struct SheetRow {
  std::string label;
  std::vector<Image> pictures;  ///< of any size, 1 or 3 channels
};
/// Rows under column titles, each picture scaled to column_width pixels. cost O(pixels).
Image contact_sheet(const std::vector<std::string>& columns, const std::vector<SheetRow>& rows, int column_width);

}  // namespace luminist
