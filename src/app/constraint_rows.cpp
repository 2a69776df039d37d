// What holds of a light whoever moves it: where it may stand, its ranges, and what it has of others, as a list to be
// ticked.
#include <algorithm>

#include <fmt/format.h>

#include "app/icons.h"
#include "app/lights_panel.h"
#include "studio/constraint_words.h"

namespace luminist {
namespace {

/// In the units of the widgets.
std::string range_words(const Desk& desk, const std::string& name, const Between& range) {
  const Light* light = desk.now->shown->rig.find(name);
  const auto numbers = light != nullptr ? limited_numbers(*light, range.param) : std::nullopt;
  if (!numbers) return range.param;
  const ParamSpec& spec = light->params.schema()[numbers->param];
  const SceneFrame& frame = desk.now->facts->frame;
  return fmt::format("{} {:.4g} to {:.4g}", range.param, spec.written(numbers->first, range.low, frame),
                     spec.written(numbers->first, range.high, frame));
}

/// As short as a list can say it.
std::string short_words(const Desk& desk, const Constraint& constraint) {
  if (const auto* at = std::get_if<AtDistance>(&constraint.rule))
    return fmt::format("at distance {:.3g}", at->distance);
  if (const auto* range = std::get_if<Between>(&constraint.rule)) return range_words(desk, constraint.light, *range);
  if (const auto* mirror = std::get_if<MirrorOf>(&constraint.rule)) return "mirror of " + mirror->light;
  if (const auto* same = std::get_if<SameColor>(&constraint.rule)) return "colour of " + same->light;
  return rule_words(constraint, desk.now->facts->surface, desk.now->facts->bounds);
}

void constrain(Desk& desk, const std::string& words) {
  desk.studio->change(
      "constrain a light", [words](Session& session) { return session.constrain({words}); }, Workbench::After::kFollow);
}

void release(Desk& desk, const Constraint& gone) {
  desk.studio->change(
      "free a light",
      [gone](Session& session) {
        std::vector<Constraint> kept = session.state().rig.constraints;
        std::erase_if(kept, [&](const Constraint& each) { return same_kind(each, gone); });
        return session.set_constraints(std::move(kept));
      },
      Workbench::After::kFollow);
}

/// A line of the list: ticked where something like it holds. words: what a tick says of the light.
void line(Desk& desk, const std::string& label, const Constraint* held, const std::string& words,
          const char* tip_text) {
  bool on = held != nullptr;
  if (ImGui::Checkbox(label.c_str(), &on)) {
    on ? constrain(desk, words) : release(desk, *held);
  }
  tip(desk.theme, tip_text);
}

/// The first constraint of the light for which it is true.
template <class Holds>
const Constraint* find(const LightRig& rig, const Light& light, const Holds& holds) {
  const auto found = std::ranges::find_if(
      rig.constraints, [&](const Constraint& each) { return each.light == light.name && holds(each); });
  return found == rig.constraints.end() ? nullptr : &*found;
}

void places(Desk& desk, const Light& light) {
  const LightRig& rig = desk.now->shown->rig;
  const std::string path = light_path(light.name);
  ImGui::TextDisabled("Stands on");
  for (const char* name : kPlaneNames) {
    const std::string rule = std::string("on ") + name;
    const Constraint* held = find(rig, light, [&](const Constraint& each) {
      return rule_words(each, desk.now->facts->surface, desk.now->facts->bounds) == rule;
    });
    line(desk, name, held, path + " " + rule,
         "It goes to this side of the scene, as the camera sees it, and stays on it. Of all sides the last one holds.");
  }
  ImGui::TextDisabled("Stays");
  const Constraint* held =
      find(rig, light, [](const Constraint& each) { return std::holds_alternative<AtDistance>(each.rule); });
  const Vec3 center = desk.now->facts->bounds.center();
  const std::string from = light.params.schema().by_role("direction")
                               ? std::string("aim")
                               : fmt::format("{:.5g},{:.5g},{:.5g}", center.x, center.y, center.z);
  line(desk, "as far away as now", held, path + " at distance present from " + from,
       "It keeps its distance from what it shines at, or from the middle of the scene, and may go around that.");
}

void ranges(Desk& desk, const Light& light) {
  ImGui::TextDisabled("Stays in a range");
  bool any = false;
  for (const Constraint& each : desk.now->shown->rig.constraints) {
    if (each.light != light.name || !std::holds_alternative<Between>(each.rule)) continue;
    any = true;
    line(desk, short_words(desk, each), &each, "", "Without the tick it is free again.");
  }
  if (!any) ImGui::TextDisabled("right click a number's name");
}

void others(Desk& desk, const Light& light) {
  const LightRig& rig = desk.now->shown->rig;
  const std::string path = light_path(light.name);
  if (rig.lights.size() > 1) ImGui::TextDisabled("Follows");
  for (const Light& other : rig.lights) {
    if (other.name == light.name) continue;
    ImGui::PushID(other.name.c_str());
    const Constraint* mirror = find(rig, light, [&](const Constraint& each) {
      const auto* rule = std::get_if<MirrorOf>(&each.rule);
      return rule != nullptr && rule->light == other.name;
    });
    line(desk, "mirror image of " + other.name, mirror, path + " mirror of lights/" + other.name + " across middle",
         "It is the other light's image across the middle of the scene, and has all else of it, too.");
    const Constraint* color = find(rig, light, [&](const Constraint& each) {
      const auto* rule = std::get_if<SameColor>(&each.rule);
      return rule != nullptr && rule->light == other.name;
    });
    line(desk, "colour of " + other.name, color, path + " same color as lights/" + other.name,
         "It has the other light's colour, whatever that becomes.");
    ImGui::PopID();
  }
}

}  // namespace

void constraint_list(Desk& desk, const Light& light) {
  std::string now;
  for (const Constraint& constraint : desk.now->shown->rig.constraints) {
    if (constraint.light == light.name) now += (now.empty() ? "" : ", ") + short_words(desk, constraint);
  }
  row_label(desk.theme, "Holds",
            "What is so whoever turns the lights, you or a solve: where this one may stand, in what range a number is, "
            "what it has of another.");
  ImGui::SetNextItemWidth(-1.0F);
  if (!ImGui::BeginCombo("##holds", now.empty() ? "nothing" : now.c_str(), ImGuiComboFlags_HeightLargest)) return;
  if (light.params.schema().by_role("position")) places(desk, light);
  ranges(desk, light);
  others(desk, light);
  ImGui::EndCombo();
}

}  // namespace luminist
