// What is said of a drag when its solve is over (studio/drag_goal.h).
#include <algorithm>

#include <fmt/format.h>

#include "studio/constraint_words.h"
#include "studio/drag_goal.h"

namespace luminist {
namespace {

constexpr float kNear = 0.03F;   // picture heights
constexpr float kUnlit = 0.05F;  // of the brightest spot: the light does not come there

/// What would bring the highlight nearer.
std::string advice(const Session& session, const DragOutcome& outcome, const std::string& light) {
  const auto& constraints = session.shown().rig.constraints;
  const auto held = std::ranges::find_if(constraints, [&](const Constraint& each) {
    const auto* range = std::get_if<Between>(&each.rule);
    if (range != nullptr && !range->param.starts_with("position")) return false;
    return each.light == light && !std::holds_alternative<SameColor>(each.rule);
  });
  if (held != constraints.end()) {
    const Stage& stage = session.stage();
    return fmt::format("it stays {}; take that from it, or drag where it can reach",
                       rule_words(*held, stage.renderer->surface(), stage.bounds));
  }
  if (outcome.reaches < kUnlit) return "the light does not reach that place; drag to one that nothing shades";
  return "drag it on from there, in a shorter step";
}

}  // namespace

Result<std::string> drag_words(Session& session, const Drag& drag, const std::string& light) {
  if (drag.what != Drag::What::kHighlight) return std::string();
  LUM_TRY(const DragOutcome outcome, highlight_outcome(session, drag, light));
  if (outcome.distance <= kNear) return std::string();
  return fmt::format("the highlight of {} ended {:.2f} of the height off: {}", light, outcome.distance,
                     advice(session, outcome, light));
}

}  // namespace luminist
