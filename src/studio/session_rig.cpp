// The part of a session that turns lights and style by hand.
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "project/paint_document.h"
#include "project/state_document.h"
#include "rig/light_links.h"
#include "studio/constraint_words.h"
#include "studio/session.h"
#include "studio/style_reload.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

Result<Light*> find_light(ParamState& state, const std::string& name) {
  if (Light* light = state.rig.find(name)) return light;
  std::vector<std::string> names;
  for (const Light& light : state.rig.lights) names.push_back(light.name);
  const std::string near = nearest_name(name, names);
  return Error{
      ErrorKind::kUsage, fmt::format("there is no light \"{}\"", name), "", "light",
      near.empty() ? fmt::format("there are: {}", fmt::join(names, ", ")) : fmt::format("did you mean \"{}\"?", near)};
}

Result<void> check_group(const std::string& group) {
  if (group.empty() || is_light_name(group)) return {};
  return Error{ErrorKind::kUsage, fmt::format("\"{}\" is no name for a group", group), "", "group",
               "use 1 to 255 characters, none of them / * = :"};
}

/// "toon" of "toon+outline".
std::string base_of(const std::string& style) {
  return style.substr(0, style.find('+'));
}

/// Values and locks of the parameters that both have: lines go over a style, or away, without changing it.
void keep_values(const ParamBlock& before, ParamBlock& after) {
  for (int param = 0; param < after.schema().size(); ++param) {
    const ParamSpec& spec = after.schema()[param];
    const auto same = before.schema().find(spec.name);
    if (!same || before.schema()[*same].type != spec.type) continue;
    for (int c = 0; c < spec.components(); ++c) after.set(param, c, before.get(*same, c));
    for (int dof = 0; dof < spec.dofs(); ++dof) {
      after.set_locked(spec.first_dof + dof, before.locked_by_hand(before.schema()[*same].first_dof + dof));
    }
  }
}

}  // namespace

Result<void> Session::set(const std::vector<std::string>& assignments) {
  ParamState next = state_;
  for (const std::string& assignment : assignments) LUM_TRY_VOID(set_path(next, assignment));
  warn_of_ranges(next, assignments, stage_->frame, *diagnostics_);
  const std::string label =
      assignments.size() == 1 ? "Set " + assignments.front() : fmt::format("Set {} parameters", assignments.size());
  return commit_state(label, Json{{"do", "set"}, {"values", assignments}}.dump(), std::move(next));
}

Result<int> Session::set_locked(const std::vector<std::string>& patterns, bool locked) {
  ParamState next = state_;
  int count = 0;
  for (const std::string& pattern : patterns) {
    LUM_TRY(const int named, luminist::set_locked(next, pattern, locked));
    count += named;
  }
  const char* verb = locked ? "lock" : "unlock";
  const std::string label = fmt::format("{} {}", locked ? "Lock" : "Unlock", fmt::join(patterns, ", "));
  LUM_TRY_VOID(commit_state(label, Json{{"do", verb}, {"pattern", patterns}}.dump(), std::move(next)));
  locks_chosen_ = true;
  return count;
}

/// From what the lights in force still lack, so that several lights can be added to one painting; if they lack nothing
/// that an estimate could use, from all of the paint.
Result<StartLight> Session::start_light() {
  LUM_TRY(const Canvas* canvas, this->canvas());
  const SurfaceBuffer& surface = stage_->renderer->surface();
  Target lacking = canvas->target();
  LUM_TRY(lacking.before, stage_->renderer->render(state_));
  if (auto start = estimate_start_light(surface, lacking, stage_->frame)) return start;
  return estimate_start_light(surface, canvas->target(), stage_->frame);
}

Result<std::string> Session::add_light(const NewLight& wanted) {
  LUM_TRY_VOID(check_group(wanted.group));
  ParamState next = state_;
  for (Light& light : next.rig.lights) {
    if (wanted.lock_others) light.params.set_param_locked(-1, true);
  }
  const std::string name = next.rig.unused_name(wanted.name);
  LUM_TRY(Light light, make_light(stage_->types, wanted.type, name, stage_->frame));
  light.group = wanted.group;
  if (wanted.dark) {
    if (const auto color = light.params.schema().by_role("color")) light.params.set_vec3(*color, Vec3(0.0F));
  } else if (wanted.from_paint) {
    LUM_TRY(const StartLight start, start_light());
    apply_start_light(start, light);
  }
  next.rig.lights.push_back(std::move(light));
  const Json action = {{"do", "add_light"},
                       {"type", wanted.type},
                       {"name", wanted.name},
                       {"group", wanted.group},
                       {"from_paint", wanted.from_paint},
                       {"dark", wanted.dark},
                       {"lock_others", wanted.lock_others}};
  LUM_TRY_VOID(commit_state("Add light " + name, action.dump(), std::move(next)));
  return name;
}

Result<std::vector<std::string>> Session::add_lights(int count, const NewLight& wanted) {
  LUM_TRY_VOID(check_group(wanted.group));
  LUM_TRY(const Canvas* canvas, this->canvas());
  LUM_TRY(const std::vector<StartLight> starts,
          estimate_start_lights(count, stage_->renderer->surface(), canvas->target(), stage_->frame));
  ParamState next = state_;
  for (Light& light : next.rig.lights) {
    if (wanted.lock_others) light.params.set_param_locked(-1, true);
  }
  std::vector<std::string> names;
  for (const StartLight& start : starts) {
    names.push_back(next.rig.unused_name(wanted.name));
    LUM_TRY(Light light, make_light(stage_->types, wanted.type, names.back(), stage_->frame));
    light.group = wanted.group;
    apply_start_light(start, light);
    next.rig.lights.push_back(std::move(light));
  }
  const Json action = {{"do", "add_light"},     {"type", wanted.type}, {"name", wanted.name},
                       {"group", wanted.group}, {"count", count},      {"lock_others", wanted.lock_others}};
  LUM_TRY_VOID(commit_state(fmt::format("Add {} lights", names.size()), action.dump(), std::move(next)));
  return names;
}

Result<void> Session::remove_light(const std::string& name) {
  ParamState next = state_;
  LUM_TRY_VOID(find_light(next, name));
  const std::vector<Constraint> gone = luminist::remove_light(next.rig, name);
  LUM_TRY_VOID(
      commit_state("Remove light " + name, Json{{"do", "remove_light"}, {"light", name}}.dump(), std::move(next)));
  for (const Constraint& constraint : gone) diagnostics_->warn(name, "dropped with the light: " + to_text(constraint));
  return {};
}

Result<void> Session::set_constraints(std::vector<Constraint> constraints) {
  ParamState next = state_;
  next.rig.constraints = std::move(constraints);
  LUM_TRY_VOID(check_constraints(next.rig));
  std::vector<std::string> words;
  for (const Constraint& constraint : next.rig.constraints) words.push_back(to_text(constraint));
  const std::string label =
      words.empty() ? "Drop all constraints" : fmt::format("Constrain {}", fmt::join(words, "; "));
  return commit_state(label, Json{{"do", "set_constraints"}, {"rules", words}}.dump(), std::move(next));
}

Result<void> Session::constrain(const std::vector<std::string>& words) {
  if (words.empty()) return {};
  ParamState next = state_;
  LUM_TRY_VOID(add_constraints(next.rig, words, stage_->renderer->surface(), stage_->bounds));
  return commit_state(fmt::format("Constrain {}", fmt::join(words, "; ")),
                      Json{{"do", "constrain"}, {"rules", words}}.dump(), std::move(next));
}

Result<void> Session::set_muted(const std::string& name, bool muted) {
  ParamState next = state_;
  LUM_TRY(Light * light, find_light(next, name));
  light->muted = muted;
  return commit_state(fmt::format("{} {}", muted ? "Mute" : "Unmute", name),
                      Json{{"do", "mute"}, {"light", name}, {"muted", muted}}.dump(), std::move(next));
}

Result<void> Session::link_light(const std::string& name, const std::vector<std::string>& patterns) {
  ParamState next = state_;
  LUM_TRY_VOID(luminist::link_light(next.rig, name, patterns, stage_->object_names()));
  const std::string label = patterns.empty() ? fmt::format("{} lights everything", name)
                                             : fmt::format("{} lights only {}", name, fmt::join(patterns, ", "));
  return commit_state(label, Json{{"do", "link_light"}, {"light", name}, {"objects", patterns}}.dump(),
                      std::move(next));
}

Result<void> Session::share_shadows(const std::string& name) {
  ParamState next = state_;
  if (!name.empty()) LUM_TRY_VOID(find_light(next, name));
  next.rig.shadow_light = name;
  return commit_state(name.empty() ? "Each light its own shadow" : "Share the shadow of " + name,
                      Json{{"do", "share_shadows"}, {"light", name}}.dump(), std::move(next));
}

Result<void> Session::load_rig(const std::string& path, const std::filesystem::path& folder) {
  ParamState next = state_;
  LUM_TRY(const std::string file, find_input(path, folder, roots_));
  LUM_TRY(next.rig, luminist::load_rig(file, stage_->types, stage_->frame));
  LUM_TRY_VOID(check_links(next.rig, stage_->object_names(), file));
  pose(next.rig, shot_.frame);
  return commit_state("Load the rig " + path, Json{{"do", "load_rig"}, {"rig", path}}.dump(), std::move(next));
}

Result<void> Session::restyle(const std::string& name) {
  if (name == shot_.style) return {};
  Shot shot = shot_;
  shot.style = name;
  LUM_TRY(auto stage, open_stage(*device_, roots_, shot, folder_, *diagnostics_, stage_->moving));
  ParamState next{state_.rig, initial_state(stage->types, stage->style, stage->frame).style,
                  carried_materials(state_.materials, *stage)};
  if (base_of(name) == base_of(shot_.style)) keep_values(state_.style, next.style);
  Document document = project_.document();
  document.erase_below("style/");
  document.erase_below("locks/style/");
  write_shot(shot, document);
  write_state(next, document);
  LUM_TRY_VOID(commit("Style " + name, Json{{"do", "style"}, {"name", name}}.dump(), document));
  solved_.reset();
  canvas_.reset();
  stage_ = std::move(stage);
  shot_ = std::move(shot);
  state_ = std::move(next);
  return {};
}

Result<void> Session::reload_style() {
  Result<ParamState> reloaded = luminist::reload_style(*stage_, roots_, state_);
  std::unique_ptr<Stage> stage;
  if (!reloaded && reloaded.error().kind == ErrorKind::kUsage) {
    LUM_TRY(stage, open_stage(*device_, roots_, shot_, folder_, *diagnostics_, stage_->moving));
    reloaded = carried_over(state_, stage->style, stage->frame);
    reloaded->materials = carried_materials(state_.materials, *stage);
  }
  LUM_TRY(ParamState next, std::move(reloaded));
  free_view_.reset();
  drop_proposal();
  solved_.reset();
  canvas_.reset();
  if (stage) stage_ = std::move(stage);
  state_ = std::move(next);
  Document document = project_.document();
  document.erase_below("style/");
  document.erase_below("locks/style/");
  write_state(state_, document);
  return commit("New version of the style " + shot_.style, Json{{"do", "style"}, {"name", shot_.style}}.dump(),
                document);
}

}  // namespace luminist
