#include <CLI/CLI.hpp>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/solve_shared.h"
#include "cli/solve_styles.h"
#include "cli/solve_words.h"
#include "studio/results.h"

namespace luminist {
namespace {

/// Keys for every parameter of a light that the solver may turn, at the session's frame.
Result<void> key_free_params(Session& session) {
  const ParamState state = session.state();
  const std::vector<const ParamBlock*> blocks = state.blocks();
  const std::vector<std::string> paths = state.block_paths();
  for (std::size_t b = 0; b <= state.rig.lights.size(); ++b) {
    for (const ParamSpec& spec : blocks[b]->schema().specs()) {
      bool free = false;
      for (int dof = 0; dof < spec.dofs(); ++dof) free = free || !blocks[b]->locked(spec.first_dof + dof);
      if (free) LUM_TRY_VOID(session.set_keys(paths[b] + "/" + spec.name, KeyInterpolation::kSmooth));
    }
  }
  return {};
}

Result<int> solve(const SolveWords& words, VerbContext& context) {
  if (words.keys && (!words.views.empty() || several_styles(words))) {
    return Error{ErrorKind::kUsage, "keys are set by a solve at one frame in one style", "", "--key", ""};
  }
  if (words.together && !words.views.empty()) {
    return Error{ErrorKind::kUsage, "views are solved together anyway", "", "--together", "leave it out"};
  }
  if (!words.views.empty()) {
    if (several_styles(words)) {
      return Error{ErrorKind::kUsage, "several views have one style", "", "--style", "name one style"};
    }
    return solve_views(words, context);
  }
  LUM_TRY_VOID(check_paint_words(words.paint));
  if (several_styles(words)) return solve_styles(words, context);
  if (words.together) {
    return Error{ErrorKind::kUsage, "there is only one style", "", "--together", "name several, as --style toon,ramp"};
  }
  LUM_TRY(const Shot shot, shot_from(words.shot));
  LUM_TRY_VOID(check_folder_output(words.output));
  LUM_TRY(Device device, Device::create_headless());
  Console& console = context.console;
  Diagnostics diagnostics;
  LUM_TRY(const auto session, open_task(device, shot, &words.paint, words.shot, words.locks, context, diagnostics));
  if (words.keys) LUM_TRY_VOID(key_free_params(*session));
  const StopSignals::Grace grace(context.signals);
  LUM_TRY_VOID(solve_into(*session, words, words.output, context));
  const Solved& solved = *session->solved();
  if (console.json()) {
    console.result(solve_to_json(solved.report, session->shown(), solved.verdict).dump());
  } else {
    print_solved(console, solved, session->shown());
    console.result(words.output);
  }
  if (context.signals.stopped() != 0) return 128 + context.signals.stopped();
  return words.until && solved.report.error() > *words.until ? 1 : 0;
}

void declare_solver(CLI::App& app, SolveWords& words) {
  app.add_option("--solver", words.solver, "auto, fast or simplex")->check(CLI::IsMember({"auto", "fast", "simplex"}));
  require_from_zero(*app.add_option("--seed", words.options.seed, "Of the random restarts (default: 1)"));
  CLI::Option* seconds =
      declare_seconds(app, words.seconds, "Stops after that time, each style for itself; the best so far is written");
  require_above_zero(
      *app.add_option("--evals", words.options.max_evals, "Compares at most so many full pictures")->excludes(seconds));
  require_from_zero(*app.add_option("--until", words.until, "Stops at that error; status 1 if it is not reached"));
}

}  // namespace

Verb declare_solve(CLI::App& app) {
  const auto words = std::make_shared<SolveWords>();  // the parser and the returned function both use it
  declare_shot(app, words->shot);
  declare_paint_words(app, words->paint);
  declare_lock_words(app, words->locks);
  declare_solver(app, *words);
  app.add_option("-o,--output", words->output,
                 "Folder for picture, target, importance, residual, rig.toml, convergence and verdict")
      ->required();
  app.add_flag(
      "--together", words->together,
      "Of several styles: one rig for all of them, instead of one for each. Each style keeps parameters of its "
      "own, and their errors are averaged");
  app.add_option("--view", words->views,
                 "Another picture that the same rig has to make, with paint of its own; may be repeated: "
                 "camera=C,frame=F,paint=STROKES,weight=W. Each has a folder view_1, view_2...")
      ->allow_extra_args(false)
      ->type_name("WORDS");
  app.add_flag(
      "--key", words->keys,
      "What the solver turned becomes keys at --frame in the rig that is written, and stays as it was at other "
      "frames with keys");
  app.add_flag("--json", words->json, "Prints one object");
  app.footer(
      "Examples:\n"
      "  luminist solve meshes/still_life/still_life.glb --paint strokes.json --add-light 1 -o out\n"
      "  luminist solve scene.glb --rig out/rig.toml --paint more.json --lock '*' --unlock 'lights/light/barn' -o "
      "out2\n"
      "  luminist solve scene.glb --rig rig.toml --paint strokes.json --constrain 'lights/key on ceiling' "
      "--constrain 'lights/rim same color as lights/key times 0.5' -o out4\n"
      "  luminist solve scene.glb --rig rig.toml --paint strokes.json --style toon,ramp,cinematic --together -o out5\n"
      "  luminist solve scene.glb --rig rig.toml --frame 12 --paint f12.json --unlock lights/key --key -o keyed\n"
      "  luminist solve scene.glb --rig rig.toml --view frame=4,paint=f4.json --view frame=8,paint=f8.json -o out6\n"
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
