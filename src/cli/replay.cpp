#include <CLI/CLI.hpp>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/shot_words.h"
#include "studio/script.h"

namespace luminist {
namespace {

struct ReplayWords {
  std::string log;
  std::string output = ".";
  bool json = false;
  bool live = false;
  int slice_ms = 12;
  double live_scale = 1.0;
};

/// "12 ms"
std::string in_ms(double seconds) {
  return fmt::format("{:.0f} ms", 1e3 * seconds);
}
std::string in_ms(const char* what, const Latency& latency) {
  return fmt::format("  {:<22} median {:>7}  95 % {:>7}  most {:>7}", what, in_ms(latency.median), in_ms(latency.p95),
                     in_ms(latency.most));
}

void print_live(Console& console, const LiveMeasure& measure) {
  if (console.json()) {
    console.result(live_to_json(measure).dump());
    return;
  }
  console.result(fmt::format("{}: {} strokes, {} events, {} frames, {} pictures drawn", measure.name, measure.strokes,
                             measure.events, measure.frames, measure.report.evals));
  console.result(in_ms("event to picture", measure.event_to_picture));
  console.result(in_ms("  paint", measure.paint));
  console.result(in_ms("  new target", measure.retarget));
  console.result(in_ms("  solve", measure.solve));
  console.result(in_ms("  picture", measure.picture));
  console.result(in_ms("stroke to improvement", measure.stroke_to_improvement) +
                 fmt::format("  of {} strokes", measure.improved));
  console.result(fmt::format(
      "  after the last event: 95 % of the gain after {}, nothing more after {:.1f} s; "
      "error {:.5f}, then {:.5f}, in the end {:.5f}",
      in_ms(measure.settled_95), measure.settled, measure.error_before, measure.error_event, measure.error));
}

Result<int> replay(const ReplayWords& words, VerbContext& context) {
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
  events.solved = [&](const Solved& solved, const ParamState& state) {
    const SolveReport& report = solved.report;
    if (console.json()) {
      console.result(solve_to_json(report, state, solved.verdict).dump());
      return;
    }
    const bool said = report.solver == "live";  // with the latencies
    if (!said) {
      console.result(fmt::format("{}: error {:.5f}, was {:.5f}; {} pictures compared, {:.1f} s; {}", report.solver,
                                 report.error(), report.error_start(), report.evals, report.seconds,
                                 to_string(report.termination)));
    }
    if (solved.verdict) console.result(*solved.verdict);
  };
  events.written = [&](const std::filesystem::path& file) {
    if (!console.json()) console.result(file.string());
  };
  events.live = [&](const LiveMeasure& measure) { print_live(console, measure); };
  std::optional<LiveReplayOptions> live;
  if (words.live) live = LiveReplayOptions{std::chrono::milliseconds(words.slice_ms), words.live_scale};
  const StopSignals::Grace grace(context.signals);
  auto done = run_script(device, context.roots, path, words.output, events, diagnostics, live);
  console.warn(diagnostics);
  if (!done) return std::move(done).error();
  return 0;
}

}  // namespace

Verb declare_replay(CLI::App& app) {
  const auto words = std::make_shared<ReplayWords>();  // the parser and the returned function both use it
  app.add_option("LOG", words->log, "Action script (JSON lines), or a project: NAME.lum or its log.jsonl")->required();
  app.add_option("-o,--output", words->output, "Folder for everything that is written (default: here)");
  app.add_flag("--json", words->json, "Prints one object for each solve");
  CLI::Option* live = app.add_flag("--live", words->live,
                                   "Paints the strokes of the last paint action before each solve event by event while "
                                   "the lights follow, and says how long each picture took");
  app.add_option("--slice-ms", words->slice_ms, "Time for the solver after each event (default: 12)")
      ->check(CLI::Range(1, 10000))
      ->needs(live);
  app.add_option("--live-scale", words->live_scale, "Paints, solves and shows at that share of the shot's size")
      ->check(CLI::Range(0.05, 1.0))
      ->needs(live);
  app.footer(
      "Examples:\n"
      "  luminist replay meshes/still_life/figure2/workflow.jsonl -o out/figure2\n"
      "  luminist replay meshes/still_life/figure2/workflow.jsonl --live -o out/live\n"
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
      "remedy, adopt, revert,\n"
      "undo, redo. Inputs are looked for beside the script, then where the program's own files are.");
  return [words](VerbContext& context) { return replay(*words, context); };
}

}  // namespace luminist
