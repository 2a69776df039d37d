#include <CLI/CLI.hpp>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/shot_words.h"
#include "studio/script.h"

namespace luminist {
namespace {

struct Words {
  std::string log;
  std::string output = ".";
  bool json = false;
};

Result<int> replay(const Words& words, VerbContext& context) {
  Console& console = context.console;
  LUM_TRY(const std::string path, find_input(words.log, ".", context.roots));
  LUM_TRY_VOID(check_folder_output(words.output));
  LUM_TRY(Device device, Device::create_headless());
  Diagnostics diagnostics;
  ScriptEvents events;
  events.started = [&](const std::string& line, const std::string& verb) {
    console.progress(fmt::format("{} {}", line, verb));
  };
  events.watch = [&](const SolveReport& report) {
    console.progress(report);
    return context.signals.stopped() == 0;
  };
  events.solved = [&](const SolveReport& report, const ParamState& state) {
    console.result(console.json() ? solve_to_json(report, state).dump()
                                  : fmt::format("{}: error {:.5f}, was {:.5f}; {} pictures compared, {:.1f} s; {}",
                                                report.solver, report.epsilon, report.epsilon_start, report.evals,
                                                report.seconds, to_string(report.termination)));
  };
  events.written = [&](const std::filesystem::path& file) {
    if (!console.json()) console.result(file.string());
  };
  const StopSignals::Grace grace(context.signals);
  auto done = run_script(device, context.roots, path, words.output, events, diagnostics);
  console.warn(diagnostics);
  if (!done) return std::move(done).error();
  return 0;
}

}  // namespace

Verb declare_replay(CLI::App& app) {
  const auto words = std::make_shared<Words>();  // the parser and the returned function both use it
  app.add_option("LOG", words->log, "Action script (JSON lines), or a project: NAME.lum or its log.jsonl")->required();
  app.add_option("-o,--output", words->output, "Folder for everything that is written (default: here)");
  app.add_flag("--json", words->json, "Prints one object for each solve");
  app.footer(
      "Examples:\n"
      "  luminist replay meshes/still_life/figure2/workflow.jsonl -o out/figure2\n"
      "  luminist replay shot.lum -o out       the last state of a project, exported\n"
      "A line of a script is an action:\n"
      "  {\"do\": \"open\", \"scene\": \"meshes/still_life/still_life.glb\", \"size\": [640, 480]}\n"
      "  {\"do\": \"paint\", \"strokes\": \"1_key.json\"}\n"
      "  {\"do\": \"add_light\", \"name\": \"key\"}\n"
      "  {\"do\": \"unlock\", \"pattern\": \"lights/key/shadow_density\"}\n"
      "  {\"do\": \"solve\", \"solver\": \"auto\", \"seed\": 1, \"max_evals\": 200}\n"
      "  {\"do\": \"accept\"}\n"
      "  {\"do\": \"export\", \"to\": \"step1\", \"label\": \"key light\"}\n"
      "  {\"do\": \"contact_sheet\", \"to\": \"sheet.png\"}\n"
      "  {\"do\": \"save\", \"project\": \"x.lum\"}\n"
      "others: set, lock, remove_light, mute, share_shadows, load_rig, style, importance, target, clear_paint, "
      "revert,\n"
      "undo, redo. Inputs are looked for beside the script, then where the program's own files are.");
  return [words](VerbContext& context) { return replay(*words, context); };
}

}  // namespace luminist
