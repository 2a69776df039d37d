#include "cli/solve_styles.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include "cli/solve_shared.h"
#include "studio/results.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

std::vector<std::string> style_words(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

Result<std::vector<Style>> load_styles(const SolveWords& words, const AssetRoots& roots) {
  std::vector<Style> styles;
  for (const std::string& name : style_words(words.shot.style)) {
    const bool twice = std::ranges::any_of(styles, [&](const Style& style) { return style.name == name; });
    if (twice) return Error{ErrorKind::kUsage, fmt::format("\"{}\" is named twice", name), "", "--style", ""};
    LUM_TRY(Style style, load_whole_style(roots, name));
    styles.push_back(std::move(style));
  }
  return styles;
}

/// Whether words as "style/bright=1,1,1" or "style/bright.r" are about a parameter that this style has not, but another
/// has: what no style has stays, for its error.
bool is_for_others(const std::string& text, const Style& style, const std::vector<Style>& all) {
  constexpr std::string_view kPrefix = "style/";
  if (text.rfind(kPrefix, 0) != 0) return false;
  const std::string name = text.substr(kPrefix.size(), text.find_first_of("=.", kPrefix.size()) - kPrefix.size());
  const auto has = [&](const Style& one) { return one.schema->find(name).has_value(); };
  return !has(style) && std::ranges::any_of(all, has);
}

/// The words as they are for one of the styles.
SolveWords words_for(const SolveWords& words, const Style& style, const std::vector<Style>& all) {
  SolveWords result = words;
  result.shot.style = style.name;
  std::erase_if(result.shot.shot.set, [&](const std::string& text) { return is_for_others(text, style, all); });
  std::erase_if(result.locks.ordered, [&](const auto& lock) { return is_for_others(lock.first, style, all); });
  return result;
}

Result<std::unique_ptr<Session>> open_style(Device& device, const SolveWords& words, VerbContext& context,
                                            Diagnostics& diagnostics) {
  LUM_TRY(const Shot shot, shot_from(words.shot));
  return open_task(device, shot, &words.paint, words.shot, words.locks, context, diagnostics);
}

std::string folder_of(const SolveWords& words, const std::string& style) {
  return (std::filesystem::path(words.output) / style).string();
}

Result<int> solve_each(const SolveWords& words, const std::vector<Style>& styles, Device& device,
                       VerbContext& context) {
  Json json = Json::object();
  bool missed = false;
  for (const Style& style : styles) {
    const SolveWords own = words_for(words, style, styles);
    Diagnostics diagnostics;
    LUM_TRY(const auto session, open_style(device, own, context, diagnostics));
    const StopSignals::Grace grace(context.signals);
    LUM_TRY_VOID(solve_into(*session, own, folder_of(words, style.name), context));
    const Solved& solved = *session->solved();
    json["styles"][style.name] = solve_to_json(solved.report, session->shown(), solved.verdict);
    if (!context.console.json()) context.console.result(style.name);
    print_solved(context.console, solved, session->shown());
    missed = missed || (words.until && solved.report.error() > *words.until);
    if (context.signals.stopped() != 0) break;
  }
  context.console.result(context.console.json() ? json.dump() : words.output);
  if (context.signals.stopped() != 0) return 128 + context.signals.stopped();
  return missed ? 1 : 0;
}

/// Sessions on the same shot in all styles. Lights are added in the first one, whose rig is everyone's.
Result<int> solve_together(const SolveWords& words, const std::vector<Style>& styles, Device& device,
                           VerbContext& context) {
  Diagnostics diagnostics;
  std::vector<SharedView> views;
  for (const Style& style : styles) {
    SolveWords own = words_for(words, style, styles);
    if (!views.empty()) {
      // Words about lights that only the first session has: their locks come with its rig.
      own.paint.shares_lights = true;
      own.shot.constrain.clear();
      std::erase_if(own.locks.ordered, [](const auto& lock) { return lock.first.rfind("style/", 0) != 0; });
    }
    LUM_TRY(auto session, open_style(device, own, context, diagnostics));
    views.push_back({style.name, std::move(session)});
  }
  return solve_shared(views, "styles", words, context);
}

}  // namespace

bool several_styles(const SolveWords& words) {
  return words.shot.style.find(',') != std::string::npos;
}

Result<int> solve_styles(const SolveWords& words, VerbContext& context) {
  LUM_TRY(const std::vector<Style> styles, load_styles(words, context.roots));
  LUM_TRY_VOID(check_folder_output(words.output));
  LUM_TRY(Device device, Device::create_headless());
  return words.together ? solve_together(words, styles, device, context) : solve_each(words, styles, device, context);
}

}  // namespace luminist
