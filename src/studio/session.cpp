#include "studio/session.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "project/paint_document.h"
#include "project/state_document.h"

namespace luminist {

using Json = nlohmann::json;

Result<std::unique_ptr<Session>> Session::open(Device& device, const AssetRoots& roots, const Shot& shot,
                                               const std::filesystem::path& folder, Diagnostics& diagnostics) {
  LUM_TRY(auto stage, open_stage(device, roots, shot, folder, diagnostics));
  LUM_TRY(ParamState state, starting_state(*stage, roots, shot, folder));
  warn_of_ranges(state, shot.set, stage->frame, diagnostics);
  Shot portable = shot;
  LUM_TRY(const std::string scene, find_input(shot.scene, folder, roots));
  portable.scene = portable_path(scene, roots);
  Document document;
  write_shot(portable, document);
  write_state(state, document);
  const Json action = {{"do", "open"},
                       {"scene", portable.scene},
                       {"camera", shot.camera},
                       {"size", {shot.width, shot.height}},
                       {"style", shot.style},
                       {"rig", shot.rig},
                       {"set", shot.set},
                       {"frame", shot.frame},
                       {"fps", shot.fps},
                       {"floor", shot.scene_options.floor},
                       {"wall", shot.scene_options.wall}};
  return std::unique_ptr<Session>(new Session({&device,
                                               roots,
                                               &diagnostics,
                                               folder,
                                               Project::start(std::move(document), action.dump()),
                                               std::move(portable),
                                               std::move(stage),
                                               std::move(state),
                                               {},
                                               {},
                                               {},
                                               {},
                                               {}}));
}

Result<std::unique_ptr<Session>> Session::open_project(Device& device, const AssetRoots& roots,
                                                       const std::filesystem::path& folder, Project::Access access,
                                                       Diagnostics& diagnostics) {
  LUM_TRY(Project project, Project::open(folder, access));
  LUM_TRY(Shot shot, read_shot(project.document()));
  LUM_TRY(auto stage, open_stage(device, roots, shot, folder.parent_path(), diagnostics));
  LUM_TRY(ParamState state, read_state(project.document(), stage->types, stage->style, stage->frame, stage->materials));
  for (const std::string& name : missing_materials(project.document(), state)) {
    diagnostics.warn("materials/" + name,
                     "the scene has no material of that name now; the project keeps what it was set to");
  }
  return std::unique_ptr<Session>(new Session({&device,
                                               roots,
                                               &diagnostics,
                                               folder.parent_path(),
                                               std::move(project),
                                               std::move(shot),
                                               std::move(stage),
                                               std::move(state),
                                               {},
                                               {},
                                               {},
                                               {},
                                               {}}));
}

Result<const Image*> Session::picture() {
  if (!picture_) {
    LUM_TRY(picture_, stage_->renderer->render(shown()));
  }
  return &*picture_;
}

/// Records what the document becomes; nothing at all if that is what it is.
Result<void> Session::commit(const std::string& label, const std::string& action, const Document& next) {
  std::vector<Edit> edits = difference(project_.document(), next);
  if (!edits.empty()) LUM_TRY_VOID(project_.execute({label, action, std::move(edits)}));
  if (has_proposal()) solved_.reset();
  drop_proposal();
  return {};
}

Result<void> Session::commit_state(const std::string& label, const std::string& action, ParamState next) {
  keep_constraints(next.rig);
  follow_with_keys(next.rig, shot_.frame);
  Document document = project_.document();
  write_state(next, document);
  LUM_TRY_VOID(commit(label, action, document));
  state_ = std::move(next);
  canvas_.reset();  // an unpainted one shows the new picture; a painted one copies shadows of the new lights
  return {};
}

Result<void> Session::step_history(bool back) {
  LUM_TRY(const std::vector<Edit> edits, back ? project_.undo() : project_.redo());
  if (auto loaded = reload(); !loaded) {
    // The document and what is on the stage stay together.
    LUM_TRY_VOID(back ? project_.redo() : project_.undo());
    return loaded;
  }
  return {};
}

Result<void> Session::undo() {
  return step_history(true);
}
Result<void> Session::redo() {
  return step_history(false);
}

Result<void> Session::reload() {
  LUM_TRY(Shot shot, read_shot(project_.document()));
  std::unique_ptr<Stage> stage;
  Shot seen = shot;
  if (!stage_->moving) seen.frame = shot_.frame, seen.fps = shot_.fps;  // nothing moves: every frame looks the same
  if (!same_stage(seen, shot_)) {
    const bool same_file = shot.scene == shot_.scene && shot.scene_options == shot_.scene_options;
    LUM_TRY(stage, open_stage(*device_, roots_, shot, folder_, *diagnostics_, same_file ? stage_->moving : nullptr));
  }
  const Stage& next = stage ? *stage : *stage_;
  LUM_TRY(ParamState state, read_state(project_.document(), next.types, next.style, next.frame, next.materials));
  drop_proposal();
  solved_.reset();
  canvas_.reset();
  if (stage) stage_ = std::move(stage);
  shot_ = std::move(shot);
  state_ = std::move(state);
  return {};
}

}  // namespace luminist
