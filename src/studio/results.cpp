#include "studio/results.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "image_io/image_io.h"
#include "params/param_text.h"
#include "render/metric.h"
#include "studio/heat_map.h"
#include "studio/plot.h"

namespace luminist {

using Json = nlohmann::json;

namespace {

/// Those that are not as the scene has them, and those that a solve may turn.
Json materials_to_json(const ParamState& state) {
  Json materials = Json::object();
  for (const auto& [name, params] : state.materials) {
    bool listed = !turn_of(params).nothing();
    for (int dof = 0; dof < params.schema().dofs(); ++dof) listed = listed || !params.locked(dof);
    if (listed) materials[name] = block_to_json(params);
  }
  return materials;
}

/// The rig as accepting the lights would leave it: with keys at this frame.
Results results_of(const Image& picture, const ParamState& lights, double frame, const Target& target,
                   const std::optional<SolveReport>& report) {
  LightRig rig = lights.rig;
  follow_with_keys(rig, frame);
  const Json materials = materials_to_json(lights);
  return {picture,
          target.color,
          target.importance,
          residual_map(picture, target),
          rig_to_toml(rig),
          block_to_json(lights.style).dump(2) + "\n",
          report,
          std::nullopt,
          materials.empty() ? "" : materials.dump(2) + "\n"};
}

}  // namespace

Result<Results> collect_results(Session& session) {
  const Solved* solved = session.solved();
  const bool for_solve = solved != nullptr && (session.has_proposal() || !session.painted());
  LUM_TRY(const Target* target, session.target());
  if (for_solve) target = &solved->target;
  LUM_TRY(const Image* picture, session.picture());
  Results results = results_of(*picture, session.shown(), session.shot().frame, *target,
                               solved != nullptr ? std::optional(solved->report) : std::nullopt);
  if (solved != nullptr) results.verdict = solved->verdict;
  return results;
}

Result<Results> collect_results(const Session& session, const ParamState& lights, const Target& target,
                                const std::optional<SolveReport>& report) {
  LUM_TRY(const Image picture, session.stage().renderer->render(lights));
  return results_of(picture, lights, session.shot().frame, target, report);
}

Image importance_picture(const Image& importance) {
  Image picture(importance.width, importance.height, 3);
  for (std::size_t pixel = 0; pixel < importance.pixels(); ++pixel) {
    const float lightness = 1.0F - std::clamp(importance.data[pixel], 0.0F, 1.0F);
    picture.set_rgb(pixel, Vec3(linear_from_srgb(lightness)));
  }
  return picture;
}

Result<void> write_results(const Results& results, const std::filesystem::path& folder) {
  LUM_TRY_VOID(make_folder(folder));
  LUM_TRY_VOID(write_file_atomic(folder / "rig.toml", results.rig));
  LUM_TRY_VOID(write_file_atomic(folder / "style.json", results.style_params));
  const std::filesystem::path materials = folder / "materials.json";
  if (results.materials.empty()) {
    std::error_code none;
    std::filesystem::remove(materials, none);  // an earlier solve may have turned some
  } else {
    LUM_TRY_VOID(write_file_atomic(materials, results.materials));
  }
  // A few bright pixels must not darken the rest of the map.
  const float white = std::max(quantile(results.residual, 0.995), 1e-6F);
  const Image importance = importance_picture(results.importance);
  const Image residual = heat_map_with_scale(results.residual, white);
  Image plot;
  const auto in_folder = [&](const char* name) { return (folder / name).string(); };
  std::vector<ImageFile> files = {
      {in_folder("picture.exr"), &results.picture},       {in_folder("picture.png"), &results.picture},
      {in_folder("target.exr"), &results.target},         {in_folder("target.png"), &results.target},
      {in_folder("importance.exr"), &results.importance}, {in_folder("importance.png"), &importance},
      {in_folder("residual.exr"), &results.residual},     {in_folder("residual.png"), &residual}};
  if (results.report) {
    LUM_TRY_VOID(write_file_atomic(folder / "convergence.jsonl", convergence_lines(*results.report)));
    plot = convergence_plot(*results.report);
    files.push_back({in_folder("convergence.png"), &plot});
  }
  if (results.verdict) {
    LUM_TRY_VOID(write_file_atomic(folder / "verdict.json", verdict_to_json(*results.verdict).dump(2) + "\n"));
  }
  return write_images(files);
}

Json solve_to_json(const SolveReport& report, const ParamState& state, const std::optional<Verdict>& verdict) {
  Json lights = Json::array();
  for (const Light& light : state.rig.lights) {
    Json unlocked = Json::array();
    for (const ParamSpec& spec : light.params.schema().specs()) {
      for (int dof = 0; dof < spec.dofs(); ++dof) {
        if (!light.params.locked(spec.first_dof + dof)) unlocked.push_back(dof_name(spec, dof));
      }
    }
    lights.push_back({{"name", light.name},
                      {"type", light.type},
                      {"group", light.group},
                      {"muted", light.muted},
                      {"objects", light.objects},
                      {"unlocked", std::move(unlocked)},
                      {"params", block_to_json(light.params)}});
  }
  Json json = {{"epsilon_start", report.epsilon_start},
               {"epsilon", report.epsilon},
               {"penalty_start", report.penalty_start},
               {"penalty", report.penalty},
               {"evals", report.evals},
               {"render_equivalents", report.render_equivalents},
               {"seconds", report.seconds},
               {"solver", report.solver},
               {"termination", to_string(report.termination)},
               {"lights", std::move(lights)},
               {"ambient", block_to_json(state.rig.ambient)},
               {"style", block_to_json(state.style)}};
  if (Json materials = materials_to_json(state); !materials.empty()) json["materials"] = std::move(materials);
  if (verdict) json["verdict"] = verdict_to_json(*verdict);
  return json;
}

std::string convergence_lines(const SolveReport& report) {
  std::string lines;
  for (const ConvergencePoint& point : report.convergence) {
    const Json line = {{"render_equivalents", point.render_equivalents},
                       {"evals", point.evals},
                       {"seconds", point.seconds},
                       {"epsilon", point.epsilon}};
    lines += line.dump() + "\n";
  }
  return lines;
}

}  // namespace luminist
