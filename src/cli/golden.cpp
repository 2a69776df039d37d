#include "studio/golden.h"

#include <CLI/CLI.hpp>
#include <memory>

#include <fmt/format.h>

#include "cli/shot_words.h"

namespace luminist {
namespace {

struct Words {
  std::string style;
  std::string output;
  bool update = false;
};

/// "toon", "styles/toon" and "/elsewhere/styles/toon/" name a style; a folder elsewhere is looked at first.
struct StylePlace {
  std::string name;
  AssetRoots roots;
};

StylePlace place_of(const std::string& words, const AssetRoots& standard) {
  namespace fs = std::filesystem;
  fs::path path = fs::path(words).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(path, error);
  const bool is_folder = fs::exists(folder / "style.toml", error) && folder.parent_path().filename() == "styles";
  if (!is_folder) return {path.filename().string(), standard};
  std::vector<fs::path> roots = standard.folders();
  roots.insert(roots.begin(), folder.parent_path().parent_path());
  return {path.filename().string(), AssetRoots(std::move(roots))};
}

Result<int> golden(const Words& words, VerbContext& context) {
  const StylePlace place = place_of(words.style, context.roots);
  const std::string output = words.output.empty() ? "out/golden/" + place.name : words.output;
  LUM_TRY(const Style style, load_style(place.roots, place.name));
  if (style.golden.empty()) {
    return Error{ErrorKind::kNothingToDo, "the style has no golden pictures", style.folder + "/style.toml", "golden",
                 "add a [[golden]] table"};
  }
  LUM_TRY_VOID(check_folder_output(output));
  LUM_TRY(Device device, Device::create_headless());
  Diagnostics diagnostics;
  std::vector<GoldenOutcome> outcomes;
  int failed = 0;
  for (const GoldenCase& each : style.golden) {
    context.console.progress(each.name);
    LUM_TRY(GoldenOutcome outcome, run_golden(device, place.roots, style, each, output, diagnostics));
    if (words.update && !outcome.passed) {
      LUM_TRY_VOID(accept_golden(style, each, output));
      context.console.result(fmt::format("updated {}: {}", each.name, outcome.verdict));
    } else {
      failed += outcome.passed ? 0 : 1;
      context.console.result(
          fmt::format("{} {}: {}", outcome.passed ? "passed" : "FAILED", each.name, outcome.verdict));
    }
    outcomes.push_back(std::move(outcome));
  }
  context.console.warn(diagnostics);
  LUM_TRY_VOID(write_golden_page(place.name, outcomes, output));
  context.console.result(output + "/index.html");
  return failed == 0 ? 0 : 1;
}

}  // namespace

Verb declare_golden(CLI::App& app) {
  const auto words = std::make_shared<Words>();  // the parser and the returned function both use it
  app.add_option("STYLE", words->style, "A style's folder, as styles/toon")->required();
  app.add_flag("--update", words->update, "Makes the new pictures the references of the cases that differ");
  app.add_option("-o,--output", words->output, "Folder for pictures and the page (default: out/golden/STYLE)");
  app.footer(
      "Examples:\n"
      "  luminist golden styles/toon             then look at out/golden/toon/index.html\n"
      "  luminist golden styles/toon --update    after looking: take the new pictures as references");
  return [words](VerbContext& context) { return golden(*words, context); };
}

}  // namespace luminist
