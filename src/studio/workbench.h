#pragma once
// studio/workbench.h -- a session under the hand: gestures event by event, lights that follow, pictures to show.
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "studio/exploration.h"
#include "studio/workbench_data.h"

namespace luminist {

/// What a window does with a session, in one thread and without a clock of its own: whoever drives it calls step() as
/// long as that says there is more.
///
/// The hand's strokes go event by event to a copy of the canvas, and to the session as one command when the hand is
/// done. Lights follow while `live` is set and some of them are free; what they come to is the session's proposal.
/// A session that was never saved is kept in a project below `unsaved`, so that a crash loses nothing.
///
/// thread the device's. Errors leave everything as it was; without a session they are kNothingToDo.
class Workbench : private WorkbenchData {
 public:
  using Task = std::function<Result<void>(Session&)>;
  /// How lights go on after a task: they stay as they are, or follow the paint again.
  enum class After { kStay, kFollow };

  Workbench(Device& device, AssetRoots roots, std::filesystem::path unsaved);

  Result<void> open(const Shot& shot, const std::filesystem::path& folder);
  Result<void> open_project(const std::filesystem::path& folder);
  [[nodiscard]] bool has_session() const { return session_ != nullptr; }
  [[nodiscard]] Session& session() { return *session_; }  ///< to look at; what changes it is a task
  [[nodiscard]] std::filesystem::path folder() const { return session_ ? session_->project().folder() : ""; }

  /// A stroke of the hand, of which nothing is recorded until it is ended; each is ended, cancelled or laid at once (a
  /// bucket), and counted then. errors Canvas's.
  Result<void> begin_stroke(const Stroke& stroke, const std::filesystem::path& folder);
  Result<void> extend_stroke(std::span<const StrokePoint> points);
  Result<void> end_stroke();
  void cancel_stroke();
  Result<void> lay(const Stroke& stroke, const std::filesystem::path& folder);
  [[nodiscard]] bool stroke_open() const { return stroke_.has_value(); }

  /// Shows the lights as they would be; nothing is recorded until the same assignments go to Session::set().
  Result<void> preview(const std::vector<std::string>& assignments);
  /// Anything else that a session does. Before it the lights that the brush found become the session's proposal.
  Result<void> act(const Task& task, After after = After::kStay);
  /// The same, where the task changes lights by hand: a proposal's lights come in force with it, so that what is shown
  /// is what is changed.
  Result<void> change(const Task& task, After after = After::kStay);
  /// The same, where the task changes what is painted: the lights found so far stay the proposal and go on from there.
  Result<void> repaint(const Task& task);
  Result<void> save_as(const std::filesystem::path& folder);
  Result<void> sync_if_due() { return session_ ? session_->sync_if_due() : Result<void>(); }

  /// Only these lights are in the picture that is shown; nothing is recorded. None: all.
  void set_solo(std::vector<std::string> lights);
  void set_live(bool live);
  Result<void> start_solve(const SolveOptions& options);
  void stop();
  /// errors kCancelled as soon as go_on says false: the lights stay the proposal, without a verdict.
  Result<void> judge(const std::function<bool()>& go_on = {});
  /// Done once, when the solve that runs has come to its end; not if it is stopped, or anything else is done first.
  void after_solve(Task task);

  // What there is beyond one solve; an offer that is taken becomes the proposal.
  Result<void> offer_alternatives(const ExploreWatch& watch);  ///< other lights for the paint. cost minutes
  Result<void> offer_diet(const ExploreWatch& watch);          ///< the same picture with fewer lights. cost minutes
  Result<void> take_offer(std::size_t offer);

  /// On a machine without a graphics processor: gets a smaller stage ready for pictures while the brush moves, one of
  /// QuickStage::kSizes each time; then what the next stroke would wait for. errors those of QuickStage::open(). cost
  /// seconds, three times a shot.
  Result<void> prepare();
  /// Reads the style again if its files were written since the last call. returns whether they were.
  /// errors at the author's line; what is shown stays.
  Result<bool> refresh_style();

  /// Whether nobody waits: where the processor draws, the search for lights that follow at rest is given up as soon as
  /// it says false, and begins again afterwards from what it found.
  void give_way_unless(std::function<bool()> undisturbed) { undisturbed_ = std::move(undisturbed); }
  /// A slice of what goes on by itself. returns false when there is nothing more to do. errors the renderer's.
  Result<bool> step(std::chrono::milliseconds slice);
  /// What there is to show; version counts from here.
  Result<std::shared_ptr<const StudioSnapshot>> snapshot();
  std::vector<std::string> take_warnings();  ///< since the last call, "where: what"

 private:
  Result<void> adopt_session(std::unique_ptr<Session> session);
  Result<void> keep_unsaved();
  [[nodiscard]] Result<void> need_session() const;
  void end_solve();
  void want_full_picture();
  [[nodiscard]] bool can_follow() const;
  Result<bool> follow_at_rest();
  Result<void> add_offer(std::vector<Offer>& offers, std::string title, const ParamState& lights, SolveReport report);
  [[nodiscard]] StrokeFile file_of(const Stroke& stroke) const;
  Result<void> follow();
  Result<void> hand_canvas();
  Result<void> open_stroke(const Stroke& stroke, const std::filesystem::path& folder);
  Result<void> begin_quick(const Stroke& stroke, const std::filesystem::path& folder);
  [[nodiscard]] const QuickStage& quick_stage() const;
  void drop_quick_stages();
  Result<void> open_quick();
  Result<void> go_on_quick();
  [[nodiscard]] bool wants_other_quick() const;
  Result<void> prepare_stroke();
  void prepare_shadows();
  void make_quick_ready();
  void end_quick();
  /// The picture shown is a small one.
  [[nodiscard]] bool shows_quick() const { return stroke_ && stroke_->quick && quick_painting_->has_lights(); }
  void note_event(const LiveEvent& event, double paint);
  Result<void> finish_stroke();
  Result<void> record(const Task& task);
  void drop_stroke();
  Result<void> put_proposal();
  void keep_proposal();
  [[nodiscard]] const KeptProposal* put_back_proposal();
  void forget_pictures();
  [[nodiscard]] std::uint32_t strokes() const;
  Result<void> refresh_pictures(StudioSnapshot& next);
  Result<void> tell_layers(StudioSnapshot& next);
  void note_history();
  void tell_history(StudioSnapshot& next);
  void tell_solve(StudioSnapshot& next);
  [[nodiscard]] ShotFacts facts() const;
  [[nodiscard]] const ParamState& shown_lights() const;
  [[nodiscard]] const Target* shown_target() const;
};

}  // namespace luminist
