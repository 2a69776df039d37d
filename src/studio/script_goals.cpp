// The actions of a script that drag what is seen, and that write chosen pictures.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "studio/drag_goal.h"
#include "studio/picture_export.h"
#include "studio/script_runner.h"

namespace luminist {

Result<void> ScriptRunner::drag(const Action& action) {
  Drag drag;
  drag.what = action.verb() == "drag_shadow" ? Drag::What::kShadow : Drag::What::kHighlight;
  LUM_TRY(const std::vector<double> from, action.numbers("from", 2));
  LUM_TRY(const std::vector<double> to, action.numbers("to", 2));
  LUM_TRY(const auto light, action.text("light"));
  drag.from = Vec2(from[0], from[1]);
  drag.to = Vec2(to[0], to[1]);
  drag.light = light.value_or("");
  LUM_TRY(const SolveOptions options, solve_options(action));
  LUM_TRY(const std::string name, start_drag(*session_, drag, options));
  bool cancelled = false;
  LUM_TRY_VOID(session_->finish_solve([&](const SolveReport& report) {
    cancelled = events_.watch && !events_.watch(report);
    return !cancelled;
  }));
  if (cancelled) return export_stopped();
  LUM_TRY(std::string words, drag_words(*session_, drag, name));
  if (!words.empty()) diagnostics_->warn(action.where(), std::move(words));
  if (events_.solved) events_.solved(*session_->solved(), session_->shown());
  return {};
}

Result<void> ScriptRunner::export_pictures(const Action& action) {
  LUM_TRY(const std::string name, action.needed_text("to"));
  LUM_TRY(const std::vector<std::string> pictures, action.texts("pictures"));
  LUM_TRY(const std::vector<std::string> formats, action.texts("formats"));
  LUM_TRY(const auto sheet, action.flag("sheet"));
  LUM_TRY(const auto rig, action.flag("rig"));
  LUM_TRY(const auto scene, action.flag("scene"));
  const auto unknown = [](const std::vector<std::string>& words, std::span<const std::string> known) {
    return std::ranges::any_of(words,
                               [&](const std::string& word) { return std::ranges::find(known, word) == known.end(); });
  };
  static const std::array<std::string, 2> kFormats = {"png", "exr"};
  if (unknown(pictures, picture_words())) {
    return action.wrong(fmt::format("use some of {}", fmt::join(picture_words(), ", ")), "pictures");
  }
  if (unknown(formats, kFormats)) return action.wrong("use png, exr, or both", "formats");
  const auto named = [](const std::vector<std::string>& words, const char* word, bool usual) {
    return words.empty() ? usual : std::ranges::find(words, word) != words.end();
  };
  PictureChoice choice;
  choice.light = named(pictures, "light", choice.light);
  choice.paint = named(pictures, "paint", choice.paint);
  choice.importance = named(pictures, "importance", choice.importance);
  choice.residual = named(pictures, "residual", choice.residual);
  choice.each_light = named(pictures, "each_light", choice.each_light);
  choice.png = named(formats, "png", choice.png);
  choice.exr = named(formats, "exr", choice.exr);
  choice.sheet = sheet.value_or(false);
  choice.rig = rig.value_or(true);
  choice.scene = scene.value_or(false);
  LUM_TRY(const auto written, luminist::export_pictures(*session_, choice, output_ / name));
  if (events_.written) events_.written(output_ / name);
  return {};
}

}  // namespace luminist
