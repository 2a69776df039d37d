#include <CLI/CLI.hpp>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/shot_words.h"
#include "cli/task_words.h"
#include "params/param_text.h"
#include "studio/results.h"

namespace luminist {
namespace {

struct Words {
  ShotWords shot;
  PaintWords paint;
  LockWords locks;
  std::string solver = "auto";
  std::optional<double> seconds;
  SolveOptions options;
  std::optional<double> until;
  std::string output;
  bool json = false;
};

/// " name=value" of every parameter that was free, to be read: the rig file has all digits.
std::string free_values(const ParamBlock& block) {
  std::string text;
  for (int param = 0; param < block.schema().size(); ++param) {
    const ParamSpec& spec = block.schema()[param];
    bool free = false;
    for (int dof = 0; dof < spec.dofs(); ++dof) free = free || !block.locked(spec.first_dof + dof);
    if (!free) continue;
    text += fmt::format(" {}=", spec.name);
    for (int c = 0; c < spec.components(); ++c) text += fmt::format("{}{:.4g}", c == 0 ? "" : ",", block.get(param, c));
  }
  return text;
}

void print_report(Console& console, const Solved& solved, const ParamState& state) {
  const SolveReport& report = solved.report;
  if (console.json()) {
    console.result(solve_to_json(report, state, solved.verdict).dump());
    return;
  }
  console.result(
      fmt::format("{}: error {:.5f}, was {:.5f}; {} pictures compared, {:.3g} render equivalents, {:.1f} s; {}",
                  report.solver, report.epsilon, report.epsilon_start, report.evals, report.render_equivalents,
                  report.seconds, to_string(report.termination)));
  const std::vector<const ParamBlock*> blocks = state.blocks();
  const std::vector<std::string> paths = state.block_paths();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::string found = free_values(*blocks[b]);
    if (!found.empty()) console.result(paths[b] + ":" + found);
  }
  if (solved.verdict) console.result(*solved.verdict);
}

/// What the solve found, also where an error ended it: the error is the result then.
Result<void> write_proposal(Session& session, const std::string& folder, Result<void> solved) {
  if (!solved && (!session.has_proposal() || session.solved()->report.evals == 0)) return solved;
  auto results = collect_results(session);
  auto written = results ? write_results(*results, folder) : Result<void>(std::move(results).error());
  if (solved) return written;
  Error error = std::move(solved).error();
  if (written) error.hint += fmt::format("{}the best so far is in {}", error.hint.empty() ? "" : "; ", folder);
  return error;
}

Result<int> solve(const Words& words, VerbContext& context) {
  LUM_TRY_VOID(check_paint_words(words.paint));
  LUM_TRY(const Shot shot, shot_from(words.shot));
  LUM_TRY_VOID(check_folder_output(words.output));
  LUM_TRY(Device device, Device::create_headless());
  Console& console = context.console;
  Diagnostics diagnostics;
  LUM_TRY(const auto session,
          open_task(device, shot, &words.paint, words.shot.constrain, words.locks, context, diagnostics));
  const StopSignals::Grace grace(context.signals);
  const Deadline deadline(context.signals, words.seconds);
  auto solved = session->solve(words.options, [&](const SolveReport& report) {
    console.progress(report);
    return deadline.go_on();
  });
  if (solved && context.signals.stopped() == 0) LUM_TRY_VOID(session->judge());
  LUM_TRY_VOID(write_proposal(*session, words.output, std::move(solved)));
  const SolveReport& report = session->solved()->report;
  print_report(console, *session->solved(), session->shown());
  if (!console.json()) console.result(words.output);
  if (context.signals.stopped() != 0) return 128 + context.signals.stopped();
  return words.until && report.epsilon > *words.until ? 1 : 0;
}

void declare_solver(CLI::App& app, Words& words) {
  app.add_option("--solver", words.solver, "auto, fast or simplex")->check(CLI::IsMember({"auto", "fast", "simplex"}));
  require_from_zero(*app.add_option("--seed", words.options.seed, "Of the random restarts (default: 1)"));
  CLI::Option* seconds = declare_seconds(app, words.seconds, "Stops after that time; the best so far is written");
  require_above_zero(
      *app.add_option("--evals", words.options.max_evals, "Compares at most so many full pictures")->excludes(seconds));
  require_from_zero(*app.add_option("--until", words.until, "Stops at that error; status 1 if it is not reached"));
}

}  // namespace

Verb declare_solve(CLI::App& app) {
  const auto words = std::make_shared<Words>();  // the parser and the returned function both use it
  declare_shot(app, words->shot);
  declare_paint_words(app, words->paint);
  declare_lock_words(app, words->locks);
  declare_solver(app, *words);
  app.add_option("-o,--output", words->output,
                 "Folder for picture, target, importance, residual, rig.toml, convergence and verdict")
      ->required();
  app.add_flag("--json", words->json, "Prints one object");
  app.footer(
      "Examples:\n"
      "  luminist solve meshes/still_life/still_life.glb --paint strokes.json --add-light 1 -o out\n"
      "  luminist solve scene.glb --rig out/rig.toml --paint more.json --lock '*' --unlock 'lights/light/barn' -o "
      "out2\n"
      "  luminist solve scene.glb --rig rig.toml --paint strokes.json --constrain 'lights/key on ceiling' "
      "--constrain 'lights/rim same color as lights/key times 0.5' -o out4\n"
      "  luminist solve scene.glb --rig rig.toml --target wanted.exr --until 0.01 --seconds 60 --json -o out3");
  return [words, &app](VerbContext& context) {
    note_lock_order(app, words->locks);
    words->options.until = words->until.value_or(0.0);
    words->options.solver = words->solver == "fast"      ? SolverKind::kFast
                            : words->solver == "simplex" ? SolverKind::kSimplex
                                                         : SolverKind::kAuto;
    return solve(*words, context);
  };
}

}  // namespace luminist
