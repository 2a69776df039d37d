#include <CLI/CLI.hpp>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/shot_words.h"
#include "cli/task_words.h"
#include "studio/exploration_results.h"

namespace luminist {
namespace {

struct DietWords {
  ShotWords shot;
  LockWords locks;
  std::string budget = "5%";
  DietOptions options;
  std::optional<double> seconds;
  std::string output;
  bool json = false;
};

void print_report(Console& console, const Diet& diet) {
  if (console.json()) {
    console.result(diet_to_json(diet).dump());
    return;
  }
  for (std::size_t i = 0; i < diet.steps.size(); ++i) console.result(diet_line(diet, i));
}

Result<int> diet(const DietWords& words, VerbContext& context) {
  DietOptions options = words.options;
  LUM_TRY(options.budget, parse_budget(words.budget));
  LUM_TRY(const Shot shot, shot_from(words.shot));
  LUM_TRY_VOID(check_folder_output(words.output));
  LUM_TRY(Device device, Device::create_headless());
  Console& console = context.console;
  Diagnostics diagnostics;
  LUM_TRY(const auto session, open_task(device, shot, nullptr, words.shot, words.locks, context, diagnostics));
  const StopSignals::Grace grace(context.signals);
  const Deadline deadline(context.signals, words.seconds);
  LUM_TRY(const Diet found, find_diet(*session, options, [&](const ExploreProgress& progress) {
            console.progress(fmt::format("{} of {}  {}  error {:.5f}", progress.done + 1, progress.planned,
                                         progress.doing, progress.epsilon));
            return deadline.go_on();
          }));
  LUM_TRY_VOID(write_diet(*session, found, words.output));
  print_report(console, found);
  if (!console.json()) console.result(words.output + "/contact_sheet.png");
  return context.signals.stopped() != 0 ? 128 + context.signals.stopped() : 0;
}

}  // namespace

Verb declare_diet(CLI::App& app) {
  const auto words = std::make_shared<DietWords>();  // the parser and the returned function both use it
  declare_shot(app, words->shot);
  declare_lock_words(app, words->locks);
  app.add_option("--budget", words->budget,
                 "How far the picture may go: 5% of what a black picture would be off, or an error as 0.002 "
                 "(default: 5%)");
  app.add_option("--fewest", words->options.fewest, "Goes down to so many lights (default: 1)")
      ->check(CLI::Range(1, 10000));
  app.add_option("--breadth", words->options.breadth,
                 "Removals at each size that are tried with everything free (default: 2)")
      ->check(CLI::Range(1, 10000));
  require_from_zero(*app.add_option("--seed", words->options.seed, "Of the solves (default: 1)"));
  declare_seconds(app, words->seconds, "Stops after that time; the sizes found so far are written");
  app.add_option("-o,--output", words->output,
                 "Folder for N_lights with rig and pictures of each size, contact_sheet.png and report.json")
      ->required();
  app.add_flag("--json", words->json, "Prints one object");
  app.footer(
      "Example:\n"
      "  luminist diet meshes/bust/bust.glb --rig meshes/bust/rig.toml --size 256x256 --budget 5% -o out");
  return [words, &app](VerbContext& context) {
    note_lock_order(app, words->locks);
    return diet(*words, context);
  };
}

}  // namespace luminist
