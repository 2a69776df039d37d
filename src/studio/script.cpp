#include "studio/script.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "image_io/image_io.h"
#include "paint/stroke.h"
#include "studio/constraint_words.h"
#include "studio/paint_layers.h"
#include "studio/script_runner.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

constexpr int kSheetColumn = 320;
const std::vector<std::string> kNone;

}  // namespace

const std::vector<ScriptRunner::Verb>& ScriptRunner::verbs() {
  using R = ScriptRunner;
  static const std::vector<Verb> verbs = {
      {"open",
       {"scene", "project", "camera", "size", "style", "rig", "set", "floor", "wall", "frame", "fps"},
       &R::open},
      {"set", {"path", "value", "values"}, &R::set},
      {"lock", {"pattern"}, &R::lock},
      {"unlock", {"pattern"}, &R::lock},
      {"constrain", {"rules"}, &R::constrain},
      {"set_constraints", {"rules"}, &R::constrain},
      {"add_light", {"type", "name", "group", "from_paint", "lock_others", "dark", "count"}, &R::add_light},
      {"remove_light", {"light"}, &R::remove_light},
      {"mute", {"light", "muted"}, &R::mute},
      {"rename_light", {"light", "name"}, &R::rename_light},
      {"duplicate_light", {"light", "name"}, &R::duplicate_light},
      {"group_lights", {"lights", "group"}, &R::group_lights},
      {"link_light", {"light", "objects"}, &R::link_light},
      {"share_shadows", {"light"}, &R::share_shadows},
      {"load_rig", {"rig"}, &R::load_rig},
      {"style", {"name"}, &R::style},
      {"reframe", {"camera", "size", "frame"}, &R::reframe},
      {"go_to", {"frame"}, &R::go_to},
      {"key", {"pattern", "interpolation"}, &R::key},
      {"remove_key", {"pattern", "frame"}, &R::key},
      {"move_key", {"pattern", "from", "to"}, &R::move_key},
      {"key_interpolation", {"pattern", "frame", "interpolation"}, &R::key_interpolation},
      {"paint", {"strokes", "path", "layer"}, &R::paint},
      {"layer", {"name", "rename", "visible", "opacity", "place"}, &R::layer},
      {"remove_layer", {"name"}, &R::remove_layer},
      {"merge_layer", {"name"}, &R::remove_layer},
      {"edit_stroke", stroke_fields(), &R::edit_stroke},
      {"move_stroke", {"stroke", "by", "layer", "place"}, &R::move_stroke},
      {"delete_stroke", {"stroke"}, &R::delete_stroke},
      {"drag_highlight", {"from", "to", "light", "solver", "seed", "max_evals", "until", "restarts"}, &R::drag},
      {"drag_shadow", {"from", "to", "light", "solver", "seed", "max_evals", "until", "restarts"}, &R::drag},
      {"importance", {"nu", "delta"}, &R::importance},
      {"target", {"image", "importance"}, &R::target},
      {"clear_paint", {"frame", "camera"}, &R::clear_paint},
      {"solve", {"solver", "seed", "max_evals", "until", "restarts", "seconds"}, &R::solve},
      {"solve_frames",
       {"frames", "cameras", "weights", "judge", "solver", "seed", "max_evals", "until", "restarts"},
       &R::solve_frames},
      {"make_up", {"light", "to", "solver", "seed", "max_evals", "until", "restarts"}, &R::make_up},
      {"alternatives", {"count", "within", "tries", "seed", "to", "take"}, &R::alternatives},
      {"diet", {"budget", "fewest", "breadth", "seed", "to", "take"}, &R::diet},
      {"remedy", {"stroke"}, &R::remedy},
      {"accept", kNone, &R::accept},
      {"adopt", kNone, &R::adopt},
      {"revert", kNone, &R::revert},
      {"undo", {"steps"}, &R::step_history},
      {"redo", {"steps"}, &R::step_history},
      {"export", {"to", "label"}, &R::write},
      {"look", {"from", "at", "fov", "size", "to"}, &R::look},
      {"export_pictures", {"to", "pictures", "formats", "sheet", "rig", "scene"}, &R::export_pictures},
      {"contact_sheet", {"to"}, &R::sheet},
      {"save", {"project"}, &R::save},
  };
  return verbs;
}

Result<void> ScriptRunner::run(const Action& action) {
  const auto verb =
      std::find_if(verbs().begin(), verbs().end(), [&](const Verb& each) { return each.name == action.verb(); });
  if (verb == verbs().end()) {
    std::vector<std::string> names;
    for (const Verb& each : verbs()) names.push_back(each.name);
    Error error = action.wrong(fmt::format("there is no action \"{}\"", action.verb()), "do");
    const std::string near = nearest_name(action.verb(), names);
    error.hint =
        near.empty() ? fmt::format("there are: {}", fmt::join(names, ", ")) : fmt::format("did you mean \"{}\"?", near);
    return error;
  }
  LUM_TRY_VOID(action.check_fields(verb->fields));
  if (!session_ && action.verb() != "open") return action.wrong("nothing is open yet; begin with \"open\"", "do");
  if (events_.started) events_.started(action.where(), action.verb());
  return (this->*verb->run)(action);
}

Result<void> ScriptRunner::open(const Action& action) {
  if (action.has("project")) {
    LUM_TRY(const std::string name, action.needed_text("project"));
    LUM_TRY(const std::string path, find_input(name, folder_, roots_));
    session_.reset();  // lets go of a lock on the same project
    LUM_TRY(session_, Session::open_project(*device_, roots_, path, Project::Access::kWrite, *diagnostics_));
    return {};
  }
  Shot shot;
  LUM_TRY(shot.scene, action.needed_text("scene"));
  LUM_TRY(const auto camera, action.text("camera"));
  LUM_TRY(const auto size, action.size("size"));
  LUM_TRY(const auto style, action.text("style"));
  LUM_TRY(const auto rig, action.text("rig"));
  LUM_TRY(shot.set, action.texts("set"));
  LUM_TRY(const auto floor, action.flag("floor"));
  LUM_TRY(const auto wall, action.flag("wall"));
  LUM_TRY(const auto frame, action.number("frame"));
  LUM_TRY(const auto fps, action.number("fps"));
  shot.frame = frame.value_or(shot.frame);
  shot.fps = fps.value_or(shot.fps);
  if (!(shot.fps > 0.0)) return action.wrong("frames a second are wanted", "fps");
  shot.camera = camera.value_or("");
  if (size) shot.width = size->first, shot.height = size->second;
  shot.width = std::max(1, static_cast<int>(std::lround(scale_ * shot.width)));
  shot.height = std::max(1, static_cast<int>(std::lround(scale_ * shot.height)));
  shot.style = style.value_or(shot.style);
  shot.rig = rig.value_or("");
  shot.scene_options = {floor.value_or(false), wall.value_or(false)};
  LUM_TRY(session_, Session::open(*device_, roots_, shot, folder_, *diagnostics_));
  return {};
}

Result<void> ScriptRunner::set(const Action& action) {
  LUM_TRY(std::vector<std::string> assignments, action.texts("values"));
  if (action.has("path")) {
    LUM_TRY(const std::string path, action.needed_text("path"));
    LUM_TRY(const std::string value, action.value_text("value"));
    assignments.push_back(path + "=" + value);
  }
  if (assignments.empty()) return action.wrong("\"set\" needs a path and a value", "path");
  return session_->set(assignments);
}

Result<void> ScriptRunner::lock(const Action& action) {
  LUM_TRY(const std::vector<std::string> patterns, action.texts("pattern"));
  if (patterns.empty()) return action.wrong(fmt::format("\"{}\" needs this field", action.verb()), "pattern");
  LUM_TRY_VOID(session_->set_locked(patterns, action.verb() == "lock"));
  return {};
}

/// "constrain" adds rules, "set_constraints" puts them in place of all there are.
Result<void> ScriptRunner::constrain(const Action& action) {
  LUM_TRY(const std::vector<std::string> rules, action.texts("rules"));
  if (action.verb() == "constrain") return session_->constrain(rules);
  LightRig rig = session_->state().rig;
  rig.constraints.clear();
  const Stage& stage = session_->stage();
  LUM_TRY_VOID(add_constraints(rig, rules, stage.renderer->surface(), stage.bounds));
  return session_->set_constraints(rig.constraints);
}

Result<void> ScriptRunner::style(const Action& action) {
  LUM_TRY(const std::string name, action.needed_text("name"));
  return session_->restyle(name);
}

Result<ScriptStrokes> ScriptRunner::strokes_of(const Action& action) const {
  if (const auto inline_strokes = action.object("strokes")) {
    LUM_TRY(StrokeFile strokes, parse_strokes(*inline_strokes, action.where()));
    return ScriptStrokes{std::move(strokes), (folder_ / "strokes").string()};
  }
  LUM_TRY(const std::string name, action.needed_text("strokes"));
  LUM_TRY(std::string path, find_input(name, folder_, roots_));
  LUM_TRY(StrokeFile strokes, load_strokes(path));
  return ScriptStrokes{std::move(strokes), std::move(path)};
}

Result<void> ScriptRunner::paint(const Action& action) {
  LUM_TRY(const ScriptStrokes given, strokes_of(action));
  LUM_TRY(const auto layer, action.text("layer"));
  if (layer) LUM_TRY_VOID(session_->layers().choose(*layer));
  return session_->paint(given.strokes, given.path);
}

Result<void> ScriptRunner::importance(const Action& action) {
  LUM_TRY(const auto nu, action.number("nu"));
  LUM_TRY(const auto delta, action.number("delta"));
  if (!nu || !delta) return action.wrong("\"importance\" needs nu and delta", nu ? "delta" : "nu");
  return session_->set_importance(static_cast<float>(*nu), static_cast<float>(*delta));
}

Result<void> ScriptRunner::target(const Action& action) {
  LUM_TRY(const std::string name, action.needed_text("image"));
  LUM_TRY(const std::string path, find_input(name, folder_, roots_));
  LUM_TRY(const Image color, read_image(path));
  LUM_TRY(const auto importance_name, action.text("importance"));
  std::optional<Image> importance;
  if (importance_name) {
    LUM_TRY(const std::string importance_path, find_input(*importance_name, folder_, roots_));
    LUM_TRY(importance, read_image(importance_path, Encoding::kLinear));
  }
  return session_->set_target(color, importance);
}

Result<void> ScriptRunner::accept(const Action&) {
  return session_->accept();
}
Result<void> ScriptRunner::adopt(const Action&) {
  return session_->adopt();
}
Result<void> ScriptRunner::revert(const Action&) {
  return session_->revert();
}

Result<void> ScriptRunner::step_history(const Action& action) {
  LUM_TRY(const auto steps, action.number("steps"));
  const double count = steps.value_or(1.0);
  if (!(count >= 1.0 && count <= 1e9 && count == std::floor(count))) {
    return action.wrong("a whole number from 1 is wanted", "steps");
  }
  for (int i = 0; i < static_cast<int>(count); ++i) {
    LUM_TRY_VOID(action.verb() == "undo" ? session_->undo() : session_->redo());
  }
  return {};
}

Result<void> ScriptRunner::sheet(const Action& action) {
  LUM_TRY(const std::string name, action.needed_text("to"));
  if (rows_.empty()) return action.wrong("nothing was exported yet", "do");
  const fs::path path = output_ / name;
  LUM_TRY_VOID(make_folder(path.parent_path()));
  LUM_TRY_VOID(write_image(path.string(),
                           contact_sheet({"painted", "importance (black counts)", "solved"}, rows_, kSheetColumn)));
  if (events_.written) events_.written(path);
  return {};
}

Result<void> ScriptRunner::save(const Action& action) {
  LUM_TRY(const auto project, action.text("project"));
  if (!project) return session_->save();
  LUM_TRY_VOID(session_->save_as(output_ / *project));
  if (events_.written) events_.written(output_ / *project);
  return {};
}

}  // namespace luminist
