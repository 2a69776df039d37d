#pragma once
// studio/script.h -- action scripts: whatever a hand can do, a log can do too.
#include <filesystem>
#include <functional>
#include <string>

#include "studio/live_replay.h"
#include "studio/results.h"

namespace luminist {

/// Who runs a script hears about it here; any of these may be empty.
struct ScriptEvents {
  std::function<void(const std::string& line, const std::string& verb)> started;  ///< "script.jsonl:3", "paint"
  Session::SolveWatch watch;                                     ///< false: stop the solve and the script
  std::function<void(const Solved&, const ParamState&)> solved;  ///< judged, too
  std::function<void(const std::filesystem::path&)> written;
  std::function<void(const LiveMeasure&)> live;  ///< a painting was painted live
};

/// Runs the lines of a script, or brings a recorded project (NAME.lum, or its log.jsonl) to its last state.
///
/// A line is a JSON object with "do": open, set, lock, unlock, constrain, set_constraints, add_light, remove_light,
/// mute, rename_light, duplicate_light, group_lights, link_light, share_shadows, load_rig, style, reframe (another
/// camera or size), go_to, key, remove_key, move_key, key_interpolation, paint, drag_highlight and drag_shadow (paint
/// and a solve), importance, target, clear_paint (of this frame and camera or others), layer (chosen; added if it is
/// not there), remove_layer, merge_layer, edit_stroke, move_stroke, delete_stroke, solve, solve_frames (one rig for
/// several), make_up (a light goes, the others make up for it), alternatives, diet, remedy, accept, adopt, revert,
/// undo, redo, export, export_pictures (those that are chosen), contact_sheet, look (a picture from anywhere), save.
/// The three that look further propose what "take" says: the number of an alternative, or true for the fewest lights
/// within the budget. Empty lines and lines that begin with # are skipped. Inputs are looked for beside the script,
/// then below the asset roots; outputs go below `output`. A project is replayed by its recorded effects and exported to
/// `output`. live: what is painted for a solve, with nothing between the two but lights that are added, locks,
/// constraints, values and importance, is painted live (studio/live_replay.h); what that found takes the place of the
/// solve. Projects have no strokes to paint again. errors those of the actions, at script:line with the field;
/// kCancelled if watch said so, after the best so far was exported to output/stopped.
Result<void> run_script(Device& device, const AssetRoots& roots, const std::filesystem::path& path,
                        const std::filesystem::path& output, const ScriptEvents& events, Diagnostics& diagnostics,
                        const std::optional<LiveReplayOptions>& live = {});

}  // namespace luminist
