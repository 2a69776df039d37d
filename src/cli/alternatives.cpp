#include <CLI/CLI.hpp>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/shot_words.h"
#include "cli/task_words.h"
#include "studio/exploration_results.h"

namespace luminist {
namespace {

struct AlternativesWords {
  ShotWords shot;
  PaintWords paint;
  LockWords locks;
  AlternativesOptions options;
  std::optional<double> seconds;
  std::string output;
  bool json = false;
};

void print_report(Console& console, const Alternatives& found, const AlternativesWords& words) {
  if (console.json()) {
    console.result(alternatives_to_json(found).dump());
    return;
  }
  for (std::size_t i = 0; i < found.list.size(); ++i) {
    const Alternative& each = found.list[i];
    console.result(fmt::format("{}/{}: error {:.5f}{}", words.output, i + 1, each.report.error(),
                               i == 0 ? "" : fmt::format(", {:.2f} from the nearest", each.distance)));
  }
  console.result(fmt::format("{} of {} found; {} of {} solutions were within {:.5f}", found.list.size(),
                             words.options.count, found.good, found.tried + 1, found.limit));
  console.result(words.output + "/contact_sheet.png");
}

Result<int> alternatives(const AlternativesWords& words, VerbContext& context) {
  LUM_TRY_VOID(check_paint_words(words.paint));
  LUM_TRY(const Shot shot, shot_from(words.shot));
  LUM_TRY_VOID(check_folder_output(words.output));
  LUM_TRY(Device device, Device::create_headless());
  Console& console = context.console;
  Diagnostics diagnostics;
  LUM_TRY(const auto session, open_task(device, shot, &words.paint, words.shot, words.locks, context, diagnostics));
  const StopSignals::Grace grace(context.signals);
  const Deadline deadline(context.signals, words.seconds);
  LUM_TRY(const Alternatives found, find_alternatives(*session, words.options, [&](const ExploreProgress& progress) {
            console.progress(fmt::format("{}  error {:.5f}", progress.doing, progress.epsilon));
            return deadline.go_on();
          }));
  LUM_TRY_VOID(write_alternatives(*session, found, words.output));
  print_report(console, found, words);
  return context.signals.stopped() != 0 ? 128 + context.signals.stopped() : 0;
}

}  // namespace

Verb declare_alternatives(CLI::App& app) {
  const auto words = std::make_shared<AlternativesWords>();  // the parser and the returned function both use it
  declare_shot(app, words->shot);
  declare_paint_words(app, words->paint);
  declare_lock_words(app, words->locks);
  app.add_option("--count", words->options.count, "How many are wanted, the best one included (default: 4)")
      ->check(CLI::Range(2, 64));
  app.add_option("--within", words->options.factor, "Error of what is offered, over the best one's (default: 1.25)")
      ->check(CLI::Range(1.0, 100.0));
  app.add_option("--tries", words->options.tries, "Solves from other lights (default: 8 for each that is wanted)")
      ->check(CLI::Range(1, 10000));
  require_from_zero(
      *app.add_option("--seed", words->options.seed, "Of the places where lights are tried (default: 1)"));
  declare_seconds(app, words->seconds, "Stops after that time; what was found is written");
  app.add_option("-o,--output", words->output,
                 "Folder for 1, 2... with rig and pictures, contact_sheet.png, report.json")
      ->required();
  app.add_flag("--json", words->json, "Prints one object");
  app.footer(
      "Fewer than --count are found where the paint leaves no choice.\n"
      "Example:\n"
      "  luminist alternatives meshes/still_life/still_life.glb --paint strokes.json --add-light 1 -o out");
  return [words, &app](VerbContext& context) {
    note_lock_order(app, words->locks);
    return alternatives(*words, context);
  };
}

}  // namespace luminist
