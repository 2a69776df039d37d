#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/shot_words.h"
#include "image_io/image_io.h"
#include "params/param_text.h"
#include "studio/results.h"

namespace luminist {
namespace {

struct Words {
  ShotWords shot;
  std::string strokes;
  std::string target;
  std::string importance;
  int new_lights = 0;
  NewLight light;
  std::vector<std::string> unlock;
  std::vector<std::string> lock;
  std::vector<std::pair<std::string, bool>> locks;  ///< both, in the order in which they were given
  std::string solver = "auto";
  std::optional<double> seconds;
  SolveOptions options;
  std::optional<double> until;
  std::string output;
  bool json = false;
};

Result<void> check_words(const Words& words) {
  const auto usage = [](const char* what, const char* field, const char* hint) {
    return Error{ErrorKind::kUsage, what, "", field, hint};
  };
  if (words.strokes.empty() && words.target.empty()) {
    return usage("there is nothing to match", "--paint", "give strokes with --paint, or a picture with --target");
  }
  if (!words.importance.empty() && words.target.empty()) {
    return usage("an importance map goes with a picture", "--importance", "paint importance into the strokes instead");
  }
  return {};
}

Result<void> put_target(Session& session, const Words& words, const AssetRoots& roots) {
  if (!words.strokes.empty()) {
    LUM_TRY(const std::string path, find_input(words.strokes, ".", roots));
    LUM_TRY(const StrokeFile strokes, load_strokes(path));
    return session.paint(strokes, path);
  }
  LUM_TRY(const std::string path, find_input(words.target, ".", roots));
  LUM_TRY(const Image color, read_image(path));
  std::optional<Image> importance;
  if (!words.importance.empty()) {
    LUM_TRY(const std::string importance_path, find_input(words.importance, ".", roots));
    LUM_TRY(importance, read_image(importance_path, Encoding::kLinear));
  }
  return session.set_target(color, importance);
}

Result<void> free_parameters(Session& session, const Words& words) {
  if (words.new_lights == 1) LUM_TRY_VOID(session.add_light(words.light));
  if (words.new_lights > 1) LUM_TRY_VOID(session.add_lights(words.new_lights, words.light));
  for (const auto& [pattern, locked] : words.locks) LUM_TRY_VOID(session.set_locked(pattern, locked));
  return {};
}

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

void print_report(Console& console, const SolveReport& report, const ParamState& state) {
  if (console.json()) {
    console.result(solve_to_json(report, state).dump());
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
  using Clock = std::chrono::steady_clock;
  LUM_TRY_VOID(check_words(words));
  LUM_TRY(const Shot shot, shot_from(words.shot));
  LUM_TRY_VOID(check_folder_output(words.output));
  LUM_TRY(Device device, Device::create_headless());
  Console& console = context.console;
  Diagnostics diagnostics;
  auto opened = Session::open(device, context.roots, shot, ".", diagnostics);
  auto prepared = opened ? put_target(**opened, words, context.roots) : Result<void>(opened.error());
  console.warn(diagnostics);
  LUM_TRY_VOID(std::move(prepared));
  const std::unique_ptr<Session> session = std::move(*opened);
  LUM_TRY_VOID(free_parameters(*session, words));
  const StopSignals::Grace grace(context.signals);
  const auto start = Clock::now();
  auto solved = session->solve(words.options, [&](const SolveReport& report) {
    console.progress(report);
    const bool late = words.seconds && std::chrono::duration<double>(Clock::now() - start).count() >= *words.seconds;
    return !late && context.signals.stopped() == 0;
  });
  LUM_TRY_VOID(write_proposal(*session, words.output, std::move(solved)));
  const SolveReport& report = session->solved()->report;
  print_report(console, report, session->shown());
  if (!console.json()) console.result(words.output);
  if (context.signals.stopped() != 0) return 128 + context.signals.stopped();
  return words.until && report.epsilon > *words.until ? 1 : 0;
}

/// CLI::PositiveNumber lets "nan" and "inf" through.
CLI::Validator finite_number() {
  return {
      [](const std::string& text) { return parse_number(text) ? "" : fmt::format("\"{}\" is no finite number", text); },
      ""};
}

/// --lock and --unlock as they were mixed: "--lock '*' --unlock lights/key/color" frees that colour only.
void note_lock_order(const CLI::App& app, Words& words) {
  const CLI::Option* unlock = app.get_option("--unlock");
  const CLI::Option* lock = app.get_option("--lock");
  std::size_t unlocked = 0;
  std::size_t locked = 0;
  for (const CLI::Option* option : app.parse_order()) {
    if (option == unlock) words.locks.emplace_back(words.unlock[unlocked++], false);
    if (option == lock) words.locks.emplace_back(words.lock[locked++], true);
  }
}

void declare_solver(CLI::App& app, Words& words) {
  app.add_option("--solver", words.solver, "auto, fast or simplex")->check(CLI::IsMember({"auto", "fast", "simplex"}));
  app.add_option("--seed", words.options.seed, "Of the random restarts (default: 1)");
  CLI::Option* seconds = app.add_option("--seconds", words.seconds, "Stops after that time; the best so far is written")
                             ->check(CLI::PositiveNumber)
                             ->check(finite_number());
  app.add_option("--evals", words.options.max_evals, "Compares at most so many full pictures")
      ->check(CLI::PositiveNumber)
      ->excludes(seconds);
  app.add_option("--until", words.until, "Stops at that error; status 1 if it is not reached")
      ->check(CLI::NonNegativeNumber)
      ->check(finite_number());
}

}  // namespace

Verb declare_solve(CLI::App& app) {
  const auto words = std::make_shared<Words>();  // the parser and the returned function both use it
  declare_shot(app, words->shot);
  CLI::Option* strokes = app.add_option("--paint", words->strokes, "Stroke file: what you want to see");
  app.add_option("--target", words->target, "Picture of what you want to see, .exr or .png")->excludes(strokes);
  app.add_option(
      "--importance", words->importance,
      "How much each pixel of --target counts, 0 not at all: importance.exr of a result, or a linear image (the "
      "importance.png of a result is a view, black where it counts)");
  app.add_option("--add-light", words->new_lights, "Adds so many lights where the paint wants them; locks the others")
      ->check(CLI::Range(0, 16));
  app.add_option("--light-type", words->light.type, "Type of the lights that are added (default: cinematic)");
  app.add_option("--unlock", words->unlock, "Lets the solver turn what matches, as lights/key/color or lights/*/barn")
      ->allow_extra_args(false)
      ->type_name("PATTERN");
  app.add_option("--lock", words->lock, "Keeps what matches; later --lock and --unlock win over earlier ones")
      ->allow_extra_args(false)
      ->type_name("PATTERN");
  declare_solver(app, *words);
  app.add_option("-o,--output", words->output,
                 "Folder for picture, target, importance, residual, rig.toml and convergence")
      ->required();
  app.add_flag("--json", words->json, "Prints one object");
  app.footer(
      "Examples:\n"
      "  luminist solve meshes/still_life/still_life.glb --paint strokes.json --add-light 1 -o out\n"
      "  luminist solve scene.glb --rig out/rig.toml --paint more.json --lock '*' --unlock 'lights/light/barn' -o "
      "out2\n"
      "  luminist solve scene.glb --rig rig.toml --target wanted.exr --until 0.01 --seconds 60 --json -o out3");
  return [words, &app](VerbContext& context) {
    note_lock_order(app, *words);
    words->options.until = words->until.value_or(0.0);
    words->options.solver = words->solver == "fast"      ? SolverKind::kFast
                            : words->solver == "simplex" ? SolverKind::kSimplex
                                                         : SolverKind::kAuto;
    return solve(*words, context);
  };
}

}  // namespace luminist
