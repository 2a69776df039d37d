// The actions of a script that move through time.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "studio/script_runner.h"
#include "studio/shots.h"

namespace luminist {
namespace {

Result<KeyInterpolation> interpolation_of(const Action& action) {
  LUM_TRY(const auto word, action.text("interpolation"));
  const std::span<const std::string> words = key_interpolation_words();
  const auto found = std::find(words.begin(), words.end(), word.value_or("smooth"));
  if (found != words.end()) return static_cast<KeyInterpolation>(found - words.begin());
  return action.wrong(fmt::format("use one of {}", fmt::join(words, ", ")), "interpolation");
}

Result<std::vector<std::string>> patterns_of(const Action& action) {
  LUM_TRY(std::vector<std::string> patterns, action.texts("pattern"));
  if (patterns.empty()) return action.wrong(fmt::format("\"{}\" needs this field", action.verb()), "pattern");
  return patterns;
}

Result<double> needed_number(const Action& action, const char* field) {
  LUM_TRY(const auto number, action.number(field));
  if (!number) return action.wrong(fmt::format("\"{}\" needs this field", action.verb()), field);
  return *number;
}

Result<std::vector<FrameChoice>> choices_of(const Action& action, const Vantage& present) {
  LUM_TRY(std::vector<double> frames, action.numbers("frames"));
  LUM_TRY(const std::vector<std::string> cameras, action.texts("cameras"));
  if (frames.empty()) frames.assign(cameras.size(), present.frame);
  LUM_TRY(const std::vector<double> weights, action.numbers("weights"));
  if (frames.empty()) return action.wrong("the frames that take part are wanted, as [0, 12], or the cameras", "frames");
  if (!weights.empty() && weights.size() != frames.size()) {
    return action.wrong("a weight for each frame is wanted, or none", "weights");
  }
  if (!cameras.empty() && cameras.size() != frames.size()) {
    return action.wrong("a camera for each frame is wanted, or none", "cameras");
  }
  std::vector<FrameChoice> choices;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string& camera = cameras.empty() ? present.camera : cameras[i];
    choices.push_back({{camera, frames[i]}, weights.empty() ? 1.0 : weights[i]});
  }
  return choices;
}

}  // namespace

Result<void> ScriptRunner::go_to(const Action& action) {
  LUM_TRY(const double frame, needed_number(action, "frame"));
  return session_->go_to(frame);
}

Result<void> ScriptRunner::key(const Action& action) {
  LUM_TRY(const std::vector<std::string> patterns, patterns_of(action));
  LUM_TRY(const KeyInterpolation interpolation, interpolation_of(action));
  LUM_TRY(const auto frame, action.number("frame"));
  for (const std::string& pattern : patterns) {
    LUM_TRY_VOID(action.verb() == "key"
                     ? session_->set_keys(pattern, interpolation)
                     : Shots(*session_).remove_keys(pattern, frame.value_or(session_->shot().frame)));
  }
  return {};
}

Result<void> ScriptRunner::move_key(const Action& action) {
  LUM_TRY(const std::vector<std::string> patterns, patterns_of(action));
  LUM_TRY(const double from, needed_number(action, "from"));
  LUM_TRY(const double to, needed_number(action, "to"));
  for (const std::string& pattern : patterns) LUM_TRY_VOID(Shots(*session_).move_keys(pattern, from, to));
  return {};
}

Result<void> ScriptRunner::key_interpolation(const Action& action) {
  LUM_TRY(const std::vector<std::string> patterns, patterns_of(action));
  LUM_TRY(const double frame, needed_number(action, "frame"));
  LUM_TRY(const KeyInterpolation interpolation, interpolation_of(action));
  for (const std::string& pattern : patterns) {
    LUM_TRY_VOID(Shots(*session_).interpolate_keys(pattern, frame, interpolation));
  }
  return {};
}

Result<void> ScriptRunner::clear_paint(const Action& action) {
  LUM_TRY(const auto frame, action.number("frame"));
  LUM_TRY(const auto camera, action.text("camera"));
  const Vantage present = Shots(*session_).present();
  return Shots(*session_).clear_paint({camera.value_or(present.camera), frame.value_or(present.frame)});
}

Result<void> ScriptRunner::solve_frames(const Action& action) {
  LUM_TRY(const std::vector<FrameChoice> choices, choices_of(action, Shots(*session_).present()));
  LUM_TRY(const SolveOptions options, solve_options(action));
  LUM_TRY(const auto judge, action.flag("judge"));
  bool cancelled = false;
  LUM_TRY_VOID(Shots(*session_).solve(choices, options, judge.value_or(true), [&](const SolveReport& report) {
    cancelled = events_.watch && !events_.watch(report);
    return !cancelled;
  }));
  if (cancelled) return export_stopped();
  if (events_.solved) events_.solved(*session_->solved(), session_->shown());
  return {};
}

}  // namespace luminist
