// The part of a script that is painted live.
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "studio/script_runner.h"

namespace luminist {
namespace {

/// Names of the lights that `after` has and `before` has not.
std::vector<std::string> added_lights(const LightRig& before, const LightRig& after) {
  std::vector<std::string> names;
  for (const Light& light : after.lights) {
    if (before.find(light.name) == nullptr) names.push_back(light.name);
  }
  return names;
}

}  // namespace

std::size_t ScriptRunner::live_group(std::span<const Action> actions) {
  constexpr std::array<std::string_view, 10> kPreparing{"add_light",       "lock",         "unlock",     "constrain",
                                                        "set_constraints", "set",          "importance", "mute",
                                                        "link_light",      "share_shadows"};
  if (actions.empty() || actions.front().verb() != "paint") return 0;
  for (std::size_t i = 1; i < actions.size(); ++i) {
    if (actions[i].verb() == "solve") return i + 1;
    if (std::find(kPreparing.begin(), kPreparing.end(), actions[i].verb()) == kPreparing.end()) return 0;
  }
  return 0;
}

Result<void> ScriptRunner::run_live(std::span<const Action> group, const LiveReplayOptions& options) {
  if (!session_) return run(group.front());  // which says what is missing
  LUM_TRY(ScriptStrokes given, strokes_of(group.front()));
  LUM_TRY(Canvas canvas, session_->canvas_copy());
  const LightRig before = session_->state().rig;
  // The recorded gestures tell which lights there will be, and what of them is free.
  for (const Action& action : group.first(group.size() - 1)) {
    LUM_TRY_VOID(run(action));
    if (action.verb() != "importance") continue;
    LUM_TRY(const auto nu, action.number("nu"));
    LUM_TRY(const auto delta, action.number("delta"));
    if (nu) given.strokes.nu = static_cast<float>(*nu);
    if (delta) given.strokes.delta = static_cast<float>(*delta);
  }
  const Action& solve = group.back();
  if (events_.started) events_.started(solve.where(), "paint live");
  LivePainting::Options how;
  LUM_TRY(how.solve, solve_options(solve));
  how.slice = options.slice;
  LivePainting painting(session_->stage(), std::move(canvas), session_->state(),
                        added_lights(before, session_->state().rig), how);
  bool stopped = false;
  LUM_TRY(const auto seconds, solve.number("seconds"));
  const auto measured = paint_live(painting, given.strokes, given.path, seconds, [&] {
    SolveReport report;
    report.solver = "live";
    stopped = stopped || (events_.watch && !events_.watch(report));
    return !stopped;
  });
  if (!measured) return stopped ? export_stopped() : std::move(measured).error();
  const LiveMeasure& measure = *measured;
  const SolveReport& report = measure.report;
  LUM_TRY(const Target* target, session_->target());
  session_->propose(painting.best(), {how.solve, report, *target, "Accept a live solve"});
  if (stopped) return export_stopped();
  LUM_TRY_VOID(session_->judge());
  if (events_.live) events_.live(measure);
  if (events_.solved) events_.solved(*session_->solved(), session_->shown());
  return {};
}

}  // namespace luminist
