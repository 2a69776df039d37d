#include <CLI/CLI.hpp>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/shot_words.h"
#include "cli/task_words.h"
#include "studio/exploration_results.h"

namespace luminist {
namespace {

struct RemoveWords {
  ShotWords shot;
  std::string light;
  LockWords locks;
  SolveOptions options;
  std::optional<double> seconds;
  std::string output;
  bool json = false;
};

void print_report(Console& console, const RemovalFacts& facts, const SolveReport& report) {
  const auto share = [&](double epsilon) { return facts.black > 0.0 ? 100.0 * epsilon / facts.black : 0.0; };
  console.result(fmt::format("without {}: error {:.5f} ({:.2g} % of the picture)", facts.light, facts.epsilon,
                             share(facts.epsilon)));
  console.result(fmt::format("made up for: error {:.5f} ({:.2g} %); {} pictures compared, {:.1f} s; {}", report.error(),
                             share(report.error()), report.evals, report.seconds, to_string(report.termination)));
  console.result(fmt::format("{} % of what {} did is shadow{}", std::lround(100.0 * facts.shadow_share), facts.light,
                             facts.shadows_matter() ? ", which other lights hardly make up for" : ""));
}

Result<int> remove(const RemoveWords& words, VerbContext& context) {
  LUM_TRY(const Shot shot, shot_from(words.shot));
  LUM_TRY_VOID(check_folder_output(words.output));
  LUM_TRY(Device device, Device::create_headless());
  Console& console = context.console;
  Diagnostics diagnostics;
  LUM_TRY(const auto session, open_task(device, shot, nullptr, words.shot, words.locks, context, diagnostics));
  LUM_TRY(const RemovalFacts facts, start_removal(*session, words.light, words.options));
  const StopSignals::Grace grace(context.signals);
  const Deadline deadline(context.signals, words.seconds);
  LUM_TRY_VOID(session->finish_solve([&](const SolveReport& report) {
    console.progress(report);
    return deadline.go_on();
  }));
  LUM_TRY_VOID(write_removal(*session, facts, words.output));
  const SolveReport& report = session->solved()->report;
  if (console.json()) {
    console.result(removal_to_json(facts, report, session->shown()).dump());
  } else {
    print_report(console, facts, report);
    console.result(words.output);
  }
  return context.signals.stopped() != 0 ? 128 + context.signals.stopped() : 0;
}

}  // namespace

Verb declare_remove(CLI::App& app) {
  const auto words = std::make_shared<RemoveWords>();  // the parser and the returned function both use it
  declare_shot(app, words->shot);
  app.add_option("LIGHT", words->light, "Name of the light that goes")->required();
  declare_lock_words(app, words->locks);
  require_from_zero(*app.add_option("--seed", words->options.seed, "Of the random restarts (default: 1)"));
  declare_seconds(app, words->seconds, "Stops after that time; the best so far is written");
  app.add_option("-o,--output", words->output, "Folder for rig.toml, pictures, contact_sheet.png and report.json")
      ->required();
  app.add_flag("--json", words->json, "Prints one object");
  app.footer(
      "The picture to keep is that of all lights; what the rig leaves unlocked makes up for the one that goes.\n"
      "Examples:\n"
      "  luminist remove meshes/bust/bust.glb key --rig meshes/bust/rig.toml -o out\n"
      "  luminist remove scene.glb fill --rig rig.toml --lock '*' --unlock 'lights/*/color' -o out");
  return [words, &app](VerbContext& context) {
    note_lock_order(app, words->locks);
    return remove(*words, context);
  };
}

}  // namespace luminist
