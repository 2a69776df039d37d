#include "studio/golden.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "cli/shot_words.h"

namespace luminist {
namespace {

struct GoldenWords {
  std::string style;
  std::string output;
  std::vector<std::string> cases;
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
  return {folder.filename().string(), AssetRoots(std::move(roots))};
}

/// The cases of that name; all if none is named.
Result<std::vector<GoldenCase>> chosen(const Style& style, const std::vector<std::string>& names) {
  if (names.empty()) return style.golden;
  std::vector<std::string> known;
  for (const GoldenCase& each : style.golden) known.push_back(each.name);
  std::vector<GoldenCase> cases;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end()) {
      return Error{ErrorKind::kUsage, fmt::format("the style has no golden picture \"{}\"", name), "", "--case",
                   fmt::format("it has {}", fmt::join(known, ", "))};
    }
    cases.push_back(style.golden[static_cast<std::size_t>(found - known.begin())]);
  }
  return cases;
}

Result<int> golden(const GoldenWords& words, VerbContext& context) {
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
  LUM_TRY(const std::vector<GoldenCase> cases, chosen(style, words.cases));
  for (const GoldenCase& each : cases) {
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
  LUM_TRY_VOID(write_outcomes(style, outcomes, output));
  return failed == 0 ? 0 : 1;
}

}  // namespace

Verb declare_golden(CLI::App& app) {
  const auto words = std::make_shared<GoldenWords>();  // the parser and the returned function both use it
  app.add_option("STYLE", words->style, "A style's folder, as styles/toon")->required();
  app.add_flag("--update", words->update, "Makes the new pictures the references of the cases that differ");
  app.add_option("--case", words->cases, "Only the case of that name; may be repeated");
  app.add_option("-o,--output", words->output, "Folder for pictures and outcomes.json (default: out/golden/STYLE)");
  app.footer(
      "Examples:\n"
      "  luminist golden styles/toon                          pictures and outcomes.json in out/golden/toon\n"
      "  tools/golden.py toon                                 the same, and a page to look at\n"
      "  luminist golden styles/toon --case creature --update after looking: take the new picture as reference");
  return [words](VerbContext& context) { return golden(*words, context); };
}

}  // namespace luminist
