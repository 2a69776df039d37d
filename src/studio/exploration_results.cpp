#include "studio/exploration_results.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "image_io/image_io.h"
#include "studio/heat_map.h"
#include "studio/light_map.h"
#include "studio/results.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int kColumn = 320;
const std::vector<std::string> kColumns = {"picture", "error", "lights from above", "from the side"};

/// A sheet with one row for each rig, all errors and all maps to one scale.
class RigSheet {
 public:
  RigSheet(const Session& session, std::span<const LightRig* const> rigs, float white)
      : surface_(&session.stage().renderer->surface()), scale_(map_scale(rigs, session.stage().frame)), white_(white) {}

  void add(std::string label, const Results& results, const LightRig& rig) {
    const int height = std::max(1, kColumn * results.picture.height / results.picture.width);
    const auto map = [&](MapView view) { return light_map(rig, *surface_, scale_, view, kColumn, height); };
    rows_.push_back({std::move(label),
                     {results.picture, heat_map(results.residual, white_), map(MapView::kAbove), map(MapView::kSide)}});
  }
  void add(SheetRow row) { rows_.push_back(std::move(row)); }
  [[nodiscard]] Result<void> write(const fs::path& folder) const {
    return write_image((folder / "contact_sheet.png").string(), contact_sheet(kColumns, rows_, kColumn));
  }

 private:
  const SurfaceBuffer* surface_;
  MapScale scale_;
  float white_;
  std::vector<SheetRow> rows_;
};

/// The error that is drawn white: half of what the picture is made of on average.
float white_error(const Target& target) {
  return std::max(1e-6F, static_cast<float>(0.5 * black_error(target)));
}

Result<void> write_report(const Json& report, const fs::path& folder) {
  return write_file_atomic(folder / "report.json", report.dump(2) + "\n");
}

std::string size_folder(const DietStep& step) {
  const std::size_t lights = step.state.rig.lights.size();
  return fmt::format("{}_light{}", lights, lights == 1 ? "" : "s");
}

}  // namespace

Json alternatives_to_json(const Alternatives& found) {
  Json list = Json::array();
  for (std::size_t i = 0; i < found.list.size(); ++i) {
    Json one = solve_to_json(found.list[i].report, found.list[i].state);
    one["rig"] = fmt::format("{}/rig.toml", i + 1);
    one["distance"] = found.list[i].distance;
    list.push_back(std::move(one));
  }
  return {{"limit", found.limit},
          {"tried", found.tried},
          {"good", found.good},
          {"stopped", found.stopped},
          {"alternatives", std::move(list)}};
}

Result<void> write_alternatives(Session& session, const Alternatives& found, const fs::path& folder) {
  LUM_TRY(const Target* target, session.target());
  std::vector<const LightRig*> rigs;
  for (const Alternative& each : found.list) rigs.push_back(&each.state.rig);
  RigSheet sheet(session, rigs, white_error(*target));
  sheet.add({"painted, and its importance", {target->color, importance_picture(target->importance)}});
  for (std::size_t i = 0; i < found.list.size(); ++i) {
    const Alternative& each = found.list[i];
    LUM_TRY(const Results results, collect_results(session, each.state, *target, each.report));
    LUM_TRY_VOID(write_results(results, folder / std::to_string(i + 1)));
    const std::string apart = i == 0 ? "the best" : fmt::format("{:.2f} from the nearest", each.distance);
    sheet.add(fmt::format("{}: error {:.4f}, {}", i + 1, each.report.error(), apart), results, each.state.rig);
  }
  LUM_TRY_VOID(sheet.write(folder));
  return write_report(alternatives_to_json(found), folder);
}

Json removal_to_json(const RemovalFacts& facts, const SolveReport& report, const ParamState& lights) {
  Json json = solve_to_json(report, lights);
  json["light"] = facts.light;
  json["epsilon_removed"] = facts.epsilon;
  json["black"] = facts.black;
  json["shadow_share"] = facts.shadow_share;
  json["shadows_matter"] = facts.shadows_matter();
  return json;
}

Result<void> write_removal(Session& session, const RemovalFacts& facts, const fs::path& folder) {
  const Solved* solved = session.solved();
  if (!session.has_proposal() || solved == nullptr) {
    return Error{ErrorKind::kNothingToDo, "no light was removed", "", "", "start a removal first"};
  }
  const ParamState& before = session.state();
  const ParamState& after = session.shown();
  ParamState without = before;
  for (Light& light : without.rig.lights) light.muted = light.muted || light.name == facts.light;
  const std::vector<const LightRig*> rigs = {&before.rig, &after.rig};
  RigSheet sheet(session, rigs, white_error(solved->target));
  LUM_TRY(const Results old, collect_results(session, before, solved->target, std::nullopt));
  LUM_TRY(const Results bare, collect_results(session, without, solved->target, std::nullopt));
  LUM_TRY(const Results results, collect_results(session));
  sheet.add("with " + facts.light, old, before.rig);
  sheet.add(fmt::format("without {}: error {:.5f}", facts.light, facts.epsilon), bare, without.rig);
  sheet.add(fmt::format("made up for: error {:.5f}", solved->report.error()), results, after.rig);
  LUM_TRY_VOID(write_results(results, folder));
  LUM_TRY_VOID(sheet.write(folder));
  return write_report(removal_to_json(facts, solved->report, after), folder);
}

Json diet_to_json(const Diet& diet) {
  Json sizes = Json::array();
  for (const DietStep& step : diet.steps) {
    Json names = Json::array();
    for (const Light& light : step.state.rig.lights) names.push_back(light.name);
    sizes.push_back({{"lights", std::move(names)},
                     {"removed", step.removed},
                     {"epsilon_removed", step.epsilon_removed},
                     {"epsilon", step.epsilon},
                     {"share", diet.black > 0.0 ? step.epsilon / diet.black : 0.0},
                     {"on_front", step.on_front},
                     {"within_budget", step.epsilon <= diet.budget},
                     {"rig", size_folder(step) + "/rig.toml"}});
  }
  return {{"budget", diet.budget},
          {"black", diet.black},
          {"chosen", diet.chosen},
          {"stopped", diet.stopped},
          {"sizes", std::move(sizes)}};
}

std::string diet_line(const Diet& diet, std::size_t index) {
  const DietStep& step = diet.steps[index];
  const std::size_t lights = step.state.rig.lights.size();
  std::string line = fmt::format("{} light{}", lights, lights == 1 ? "" : "s");
  if (!step.removed.empty()) {
    const double share = diet.black > 0.0 ? 100.0 * step.epsilon / diet.black : 0.0;
    line += fmt::format(", without {}: error {:.5f} ({:.2g} %)", step.removed, step.epsilon, share);
  }
  if (!step.on_front) line += ", fewer do as well";
  if (index == diet.chosen) line += ", the fewest within the budget";
  return line;
}

Result<void> write_diet(const Session& session, const Diet& diet, const fs::path& folder) {
  std::vector<const LightRig*> rigs;
  for (const DietStep& step : diet.steps) rigs.push_back(&step.state.rig);
  RigSheet sheet(session, rigs, white_error(diet.target));
  for (std::size_t i = 0; i < diet.steps.size(); ++i) {
    const DietStep& step = diet.steps[i];
    LUM_TRY(const Results results, collect_results(session, step.state, diet.target, std::nullopt));
    LUM_TRY_VOID(write_results(results, folder / size_folder(step)));
    sheet.add(diet_line(diet, i), results, step.state.rig);
  }
  LUM_TRY_VOID(sheet.write(folder));
  return write_report(diet_to_json(diet), folder);
}

}  // namespace luminist
