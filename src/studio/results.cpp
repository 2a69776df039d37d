#include "studio/results.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "image_io/image_io.h"
#include "params/param_text.h"
#include "render/metric.h"
#include "studio/heat_map.h"
#include "studio/plot.h"

namespace luminist {

using Json = nlohmann::json;

Result<Results> collect_results(Session& session) {
  Results results;
  const Solved* solved = session.solved();
  const bool for_solve = solved != nullptr && (session.has_proposal() || !session.painted());
  if (solved != nullptr) results.report = solved->report;
  LUM_TRY(const Target* target, session.target());
  if (for_solve) target = &solved->target;
  results.target = target->color;
  results.importance = target->importance;
  LUM_TRY(const Image* picture, session.picture());
  results.picture = *picture;
  results.residual = residual_map(results.picture, *target);
  results.rig = rig_to_toml(session.shown().rig);
  return results;
}

Image importance_picture(const Image& importance) {
  Image picture(importance.width, importance.height, 3);
  for (std::size_t pixel = 0; pixel < importance.pixels(); ++pixel) {
    const float lightness = 1.0F - std::clamp(importance.data[pixel], 0.0F, 1.0F);
    picture.set_rgb(pixel, Vec3(linear_from_srgb(lightness)));
  }
  return picture;
}

Result<void> write_all(const std::vector<ImageFile>& files) {
  // Most of the time goes into starting the helper process, so that two at a time are worth a thread.
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  Result<void> outcome;
  const auto work = [&] {
    for (std::size_t i = next++; i < files.size(); i = next++) {
      auto written = write_image(files[i].path.string(), files[i].image);
      const std::lock_guard lock(mutex);
      if (!written && outcome) outcome = std::move(written);
    }
  };
  try {
    const std::jthread helper(work);
    work();
  } catch (const std::system_error&) {
    work();  // no thread to be had
  }
  return outcome;
}

Result<void> write_results(const Results& results, const std::filesystem::path& folder) {
  LUM_TRY_VOID(make_folder(folder));
  LUM_TRY_VOID(write_file_atomic(folder / "rig.toml", results.rig));
  // A few bright pixels must not darken the rest of the map.
  const float white = std::max(quantile(results.residual, 0.995), 1e-6F);
  std::vector<ImageFile> files = {{folder / "picture.exr", results.picture},
                                  {folder / "picture.png", results.picture},
                                  {folder / "target.exr", results.target},
                                  {folder / "target.png", results.target},
                                  {folder / "importance.exr", results.importance},
                                  {folder / "importance.png", importance_picture(results.importance)},
                                  {folder / "residual.exr", results.residual},
                                  {folder / "residual.png", heat_map(results.residual, white)}};
  if (results.report) {
    LUM_TRY_VOID(write_file_atomic(folder / "convergence.jsonl", convergence_lines(*results.report)));
    files.push_back({folder / "convergence.png", convergence_plot(*results.report)});
  }
  return write_all(files);
}

Json solve_to_json(const SolveReport& report, const ParamState& state) {
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
                      {"unlocked", std::move(unlocked)},
                      {"params", block_to_json(light.params)}});
  }
  return {{"epsilon_start", report.epsilon_start},           {"epsilon", report.epsilon},  {"evals", report.evals},
          {"render_equivalents", report.render_equivalents}, {"seconds", report.seconds},  {"solver", report.solver},
          {"termination", to_string(report.termination)},    {"lights", std::move(lights)}};
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
