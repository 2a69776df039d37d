#pragma once
// studio/session.h -- everything a lighter can do, as plain calls. The command line and the window are two faces of it.
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "project/paint_document.h"
#include "solve/start_light.h"
#include "studio/new_light.h"
#include "studio/session_data.h"

namespace luminist {

/// One shot under work.
///
/// Every call that changes something is one gesture: it is recorded as one command with what it did and what was asked
/// for, or it fails and nothing has changed. A solve only proposes: accepting it is the command, and any other gesture
/// drops the proposal. Painting puts the target beside the picture; the lights change by hand or by a solve.
///
/// thread the device's. Calls that render cost a picture, others little, unless they say so.
class Session : private SessionData {
 public:
  /// Loads a shot; device and diagnostics outlive the session. Paths are looked for below folder, then the asset roots.
  /// errors those of open_stage() and starting_state().
  static Result<std::unique_ptr<Session>> open(Device& device, const AssetRoots& roots, const Shot& shot,
                                               const std::filesystem::path& folder, Diagnostics& diagnostics);
  /// errors those of Project::open() and open_stage().
  static Result<std::unique_ptr<Session>> open_project(Device& device, const AssetRoots& roots,
                                                       const std::filesystem::path& folder, Project::Access access,
                                                       Diagnostics& diagnostics);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  [[nodiscard]] const Shot& shot() const { return shot_; }
  [[nodiscard]] const Stage& stage() const { return *stage_; }
  [[nodiscard]] const Project& project() const { return project_; }
  /// The lights in force, and those to be seen: the proposal's while there is one.
  [[nodiscard]] const ParamState& state() const { return state_; }
  [[nodiscard]] const ParamState& shown() const { return solve_ ? solve_->best() : proposed_ ? *proposed_ : state_; }
  /// The picture of shown(). Valid until the next call. errors the renderer's.
  Result<const Image*> picture();
  /// What is painted on, to go on with beside the session (studio/live_painting.h), which outlives it. errors the same.
  Result<Canvas> canvas_copy();
  Result<const Target*> target();  ///< What is painted, until the next call. errors the renderer's; a tile is gone.
  [[nodiscard]] bool painted() const { return has_paint(project_.document()); }
  ShotView view();  ///< camera, size, and the shot from anywhere (studio/shot_view.h)

  // Lights and style -----------------------------------------------------------------------------------------------
  /// Assignments as "lights/key/barn=0.3,0.3,0.1", all or none; constraints then move what they must. errors kUsage.
  Result<void> set(const std::vector<std::string>& assignments);
  /// returns how many degrees of freedom the patterns name. errors kUsage if one names none.
  Result<int> set_locked(const std::string& pattern, bool locked) { return set_locked(std::vector{pattern}, locked); }
  Result<int> set_locked(const std::vector<std::string>& patterns, bool locked);
  [[nodiscard]] bool locks_chosen() const { return locks_chosen_; }  ///< since the session was opened
  /// Locks the other lights unless told otherwise. returns its name. errors kNothingToDo without light paint, kUsage.
  Result<std::string> add_light(const NewLight& wanted);
  /// Several at once, by the paint's places, colours and strengths; fewer if it has fewer kinds. returns their names.
  Result<std::vector<std::string>> add_lights(int count, const NewLight& wanted);
  /// Its constraints, and those that name it, are dropped with a warning.
  Result<void> remove_light(const std::string& name);
  /// What holds of lights from now on; they go where it holds. errors kUsage for what no rig can keep (find_fault()).
  Result<void> set_constraints(std::vector<Constraint> constraints);
  /// Adds constraints in words (parse_constraint()); one replaces that of its light and kind. errors as both.
  Result<void> constrain(const std::vector<std::string>& words);
  LightList light_list();  ///< names, groups, copies of lights (studio/light_list.h)
  Result<void> set_muted(const std::string& name, bool muted);
  /// That light, or all of "group:NAME", lights only the objects that match; none: all. errors those of link_light().
  Result<void> link_light(const std::string& name, const std::vector<std::string>& patterns);
  /// All lights use that light's shadow map; "" for each its own.
  Result<void> share_shadows(const std::string& name);
  /// Replaces the lights by those of a file. errors those of find_input() and load_rig().
  Result<void> load_rig(const std::string& path, const std::filesystem::path& folder);
  /// Looks at another frame: what moves is moved, the lights are as their keys say, those of the scene that are where
  /// it has them go with it (pose_lights()), and the paint of the frame that is left stays with it. cost reading
  /// nothing, drawing the scene anew where something moves. errors kUsage for a number that is not finite.
  Result<void> go_to(double frame);
  /// Keys at this frame for the parameters of lights that a pattern names (render/param_state.h), whatever their
  /// locks. From then on what is changed at a frame, by hand or by an accepted solve, is a key there.
  /// returns how many. errors kUsage if the pattern names none.
  Result<int> set_keys(const std::string& pattern, KeyInterpolation interpolation);
  /// Takes the keys at this frame away; a parameter without keys keeps its value. returns and errors as above.
  Result<int> remove_keys(const std::string& pattern);
  /// Looks at the same shot in another style. cost compiling it. errors kStyle, kMissing.
  Result<void> restyle(const std::string& name);
  /// Its files were written anew. errors kStyle, kMissing: the last good version stays.
  Result<void> reload_style();

  // Paint ----------------------------------------------------------------------------------------------------------
  /// Strokes, with their nu and delta; path is their file's, for messages and copies. errors those of Canvas::apply().
  Result<void> paint(const StrokeFile& strokes, const std::string& path);
  Result<void> set_importance(float nu, float delta);
  /// A target made elsewhere, in place of paint; other sizes are scaled, what is not finite does not count (both with a
  /// warning). Without an importance map every pixel counts 1. errors kBadContent.
  Result<void> set_target(const Image& color, const std::optional<Image>& importance);
  Result<void> clear_paint();  ///< Its layers, too. errors kNothingToDo
  PaintLayers layers();        ///< and the strokes in them, to be changed (studio/paint_layers.h)

  // Solving --------------------------------------------------------------------------------------------------------
  /// Dark lights begin where the paint says. errors kNothingToDo: nothing painted, everything locked, nothing counts.
  Result<void> start_solve(const SolveOptions& options);
  /// The same from other lights than those in force, for another target than what is painted.
  Result<void> start_solve(ParamState lights, Target target, const SolveOptions& options, const std::string& label);
  /// Goes on for about that long. returns false when there is nothing more to do. errors those of SolveSession.
  Result<bool> continue_solve(std::chrono::milliseconds slice);
  void stop_solve();
  using SolveWatch = std::function<bool(const SolveReport&)>;
  /// Until there is nothing more to do, or watch says false: asked about every 50 ms.
  Result<void> finish_solve(const SolveWatch& watch);
  Result<void> solve(const SolveOptions& options, const SolveWatch& watch);
  [[nodiscard]] std::size_t dropped() const { return dropped_; }  ///< proposals that made way for something else
  [[nodiscard]] bool has_proposal() const { return solve_ || proposed_; }
  void propose(ParamState lights, Solved solved);  ///< lights that were found elsewhere
  /// What became of each stroke of the proposal; kept in solved(). errors kCancelled as soon as go_on says false.
  Result<const Verdict*> judge(const std::function<bool()>& go_on = {});
  Result<void> apply_remedy(std::uint32_t stroke);  ///< what the verdict advises; errors kNothingToDo
  /// The proposal becomes the lights in force, its picture what is painted on if that took part. errors kNothingToDo.
  Result<void> accept();
  Result<void> adopt();  ///< The lights only: the paint stays for another solve. errors kNothingToDo.
  Result<void> revert();
  /// A change by hand of what is shown: a proposal's lights come in force with it. Nothing changes if it fails.
  Result<void> change_shown(const std::function<Result<void>(Session&)>& change);
  /// The proposal's, or that of the last accepted solve; null if there is none.
  [[nodiscard]] const Solved* solved();

  // History --------------------------------------------------------------------------------------------------------
  Result<void> undo();  ///< errors those of Project; redo's too
  Result<void> redo();
  Result<void> save() { return project_.save(); }
  Result<void> sync_if_due() { return project_.sync_if_due(); }
  Result<void> save_as(const std::filesystem::path& folder) { return project_.save_as(folder); }

 private:
  friend class PaintLayers;
  friend class Shots;  ///< the same session beyond its frame (studio/shots.h)
  friend class LightList;
  friend class ShotView;
  explicit Session(SessionData data) : SessionData(std::move(data)) {}
  Result<Canvas*> canvas();
  Result<StartLight> start_light();
  Result<void> commit(const std::string& label, const std::string& action, const Document& next);
  Result<void> commit_state(const std::string& label, const std::string& action, ParamState next);
  Result<void> commit_canvas(const std::string& label, const std::string& action, const CanvasState& next);
  Result<void> reload();
  void drop_proposal();
  Result<void> step_history(bool back);
};

}  // namespace luminist
