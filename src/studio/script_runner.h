#pragma once
// studio/script_runner.h -- the actions of a script, one function each.
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "studio/action.h"
#include "studio/script.h"

namespace luminist {

/// Strokes of an action, and the path that stands for their file.
struct ScriptStrokes {
  StrokeFile strokes;
  std::string path;
};

/// errors kBadContent at the action's line and field.
Result<SolveOptions> solve_options(const Action& action);

/// Runs actions on one session, which "open" makes.
class ScriptRunner {
 public:
  /// folder: where inputs are looked for first; output: where everything is written; scale: of every shot's size.
  ScriptRunner(Device& device, const AssetRoots& roots, std::filesystem::path folder, std::filesystem::path output,
               const ScriptEvents& events, Diagnostics& diagnostics, double scale = 1.0)
      : device_(&device),
        roots_(roots),
        folder_(std::move(folder)),
        output_(std::move(output)),
        events_(events),
        diagnostics_(&diagnostics),
        scale_(scale) {}

  /// errors those of the action; kBadContent for an unknown one (nearest name) or an unknown field.
  Result<void> run(const Action& action);
  /// How many of these actions are one live painting: "paint", what prepares lights for it, "solve". 0: none.
  static std::size_t live_group(std::span<const Action> actions);
  /// Runs such a group: the strokes event by event, then the actions before the solve as recorded.
  Result<void> run_live(std::span<const Action> group, const LiveReplayOptions& options);
  /// Brings a recorded project to its last state and exports it.
  Result<void> replay_project(const std::filesystem::path& folder);

 private:
  struct Verb {
    std::string name;
    std::vector<std::string> fields;
    Result<void> (ScriptRunner::*run)(const Action&);
  };
  static const std::vector<Verb>& verbs();
  static std::vector<std::string> stroke_fields();

  Result<void> open(const Action& action);
  Result<void> set(const Action& action);
  Result<void> lock(const Action& action);
  Result<void> add_light(const Action& action);
  Result<void> remove_light(const Action& action);
  Result<void> constrain(const Action& action);
  Result<void> mute(const Action& action);
  Result<void> rename_light(const Action& action);
  Result<void> duplicate_light(const Action& action);
  Result<void> group_lights(const Action& action);
  Result<void> link_light(const Action& action);
  Result<void> share_shadows(const Action& action);
  Result<void> load_rig(const Action& action);
  Result<void> style(const Action& action);
  Result<void> reframe(const Action& action);
  Result<void> go_to(const Action& action);
  Result<void> key(const Action& action);
  Result<void> move_key(const Action& action);
  Result<void> key_interpolation(const Action& action);
  Result<void> solve_frames(const Action& action);
  Result<ScriptStrokes> strokes_of(const Action& action) const;
  Result<void> paint(const Action& action);
  Result<void> drag(const Action& action);
  Result<void> importance(const Action& action);
  Result<void> target(const Action& action);
  Result<void> clear_paint(const Action& action);
  Result<void> layer(const Action& action);
  Result<void> remove_layer(const Action& action);
  Result<void> edit_stroke(const Action& action);
  Result<void> move_stroke(const Action& action);
  Result<void> delete_stroke(const Action& action);
  Result<void> solve(const Action& action);
  Result<void> make_up(const Action& action);
  Result<void> alternatives(const Action& action);
  Result<void> diet(const Action& action);
  Result<void> remedy(const Action& action);
  Result<void> accept(const Action& action);
  Result<void> adopt(const Action& action);
  Result<void> revert(const Action& action);
  Result<void> step_history(const Action& action);
  Result<void> write(const Action& action);
  Result<void> look(const Action& action);
  Result<void> export_pictures(const Action& action);
  Result<void> sheet(const Action& action);
  Result<void> save(const Action& action);
  Result<void> export_stopped();
  Result<void> export_to(const std::filesystem::path& folder, const std::string& label);

  Device* device_;
  AssetRoots roots_;
  std::filesystem::path folder_;
  std::filesystem::path output_;
  ScriptEvents events_;
  Diagnostics* diagnostics_;
  double scale_;
  std::unique_ptr<Session> session_;
  std::vector<SheetRow> rows_;  ///< what was exported so far
};

}  // namespace luminist
