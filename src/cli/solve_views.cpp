// `solve --view` of cli/solve_shared.h.
#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "cli/solve_shared.h"
#include "params/param_text.h"

namespace luminist {
namespace {

const std::vector<std::string> kWords{"camera", "frame", "paint", "weight"};

Error wrong(const std::string& text, const std::string& what) {
  return {ErrorKind::kUsage, what, "", "--view " + text,
          "write it as camera=side,frame=12,paint=strokes.json,weight=2"};
}

Result<std::map<std::string, std::string>> parse_view(const std::string& text) {
  std::map<std::string, std::string> words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) return wrong(text, fmt::format("\"{}\" sets nothing", word));
    const std::string name = word.substr(0, equals);
    if (std::find(kWords.begin(), kWords.end(), name) == kWords.end()) {
      const std::string near = nearest_name(name, kWords);
      return wrong(text, near.empty() ? fmt::format("there is no \"{}\" of a view", name)
                                      : fmt::format("there is no \"{}\"; did you mean \"{}\"?", name, near));
    }
    if (!words.emplace(name, word.substr(equals + 1)).second) return wrong(text, name + " is said twice");
    begin = end + 1;
  }
  return words;
}

Result<double> number_of(const std::map<std::string, std::string>& words, const std::string& name, double fallback,
                         const std::string& text) {
  const auto found = words.find(name);
  if (found == words.end()) return fallback;
  const auto number = parse_number(found->second);
  if (!number) return wrong(text, fmt::format("{} is no number", found->second));
  return *number;
}

/// The words of `solve` as they are for one view.
struct ViewWords {
  SolveWords solve;
  std::string name;
  double weight = 1.0;
};

Result<ViewWords> words_for(const SolveWords& words, const std::string& text, std::size_t index) {
  LUM_TRY(const auto own, parse_view(text));
  ViewWords view{words, fmt::format("view_{}", index + 1), 1.0};
  Shot& shot = view.solve.shot.shot;
  if (own.contains("camera")) shot.camera = own.at("camera");
  LUM_TRY(shot.frame, number_of(own, "frame", shot.frame, text));
  LUM_TRY(view.weight, number_of(own, "weight", 1.0, text));
  if (!(view.weight > 0.0)) return wrong(text, "a weight is above zero");
  if (own.contains("paint")) view.solve.paint.strokes = own.at("paint");
  if (index == 0) return view;
  // Words about lights that only the first session has: their locks come with its rig.
  view.solve.paint.shares_lights = true;
  view.solve.shot.constrain.clear();
  view.solve.locks.ordered.clear();
  return view;
}

}  // namespace

Result<int> solve_views(const SolveWords& words, VerbContext& context) {
  if (!words.paint.strokes.empty() || !words.paint.target.empty()) {
    return Error{ErrorKind::kUsage, "with --view each view has paint of its own", "", "--paint",
                 "write --view frame=12,paint=strokes.json for each"};
  }
  std::vector<ViewWords> all;
  for (std::size_t i = 0; i < words.views.size(); ++i) {
    LUM_TRY(ViewWords view, words_for(words, words.views[i], i));
    LUM_TRY_VOID(check_paint_words(view.solve.paint));
    all.push_back(std::move(view));
  }
  LUM_TRY_VOID(check_folder_output(words.output));
  LUM_TRY(Device device, Device::create_headless());
  Diagnostics diagnostics;
  std::vector<SharedView> views;
  for (const ViewWords& view : all) {
    LUM_TRY(const Shot shot, shot_from(view.solve.shot));
    LUM_TRY(auto session,
            open_task(device, shot, &view.solve.paint, view.solve.shot, view.solve.locks, context, diagnostics));
    views.push_back({view.name, std::move(session), view.weight});
  }
  const bool keyed = !views.front().session->state().rig.keys.empty();
  const double frame = views.front().session->shot().frame;
  if (keyed && std::ranges::any_of(views, [&](const SharedView& v) { return v.session->shot().frame != frame; })) {
    return Error{ErrorKind::kUsage, "lights with keys differ from frame to frame", "", "--view",
                 "solve at one frame after the other with --frame and --key"};
  }
  return solve_shared(views, "views", words, context);
}

}  // namespace luminist
