#include "studio/workbench.h"

#include <unistd.h>

#include <charconv>
#include <utility>

#include <fmt/format.h>

namespace luminist {
namespace {

namespace fs = std::filesystem;

/// Copies of a stroke are looked for beside the file that it came from.
std::string file_in(const fs::path& folder) {
  return (folder / "strokes.json").string();
}

float number_at(const Document& document, std::string_view path, float usual) {
  const std::string_view text = document.get(path);
  float value = usual;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

Workbench::Workbench(Device& device, AssetRoots roots, fs::path unsaved)
    : device_(&device), roots_(std::move(roots)), unsaved_(std::move(unsaved)) {}

Result<void> Workbench::open(const Shot& shot, const fs::path& folder) {
  LUM_TRY(auto session, Session::open(*device_, roots_, shot, folder, diagnostics_));
  return adopt_session(std::move(session));
}

Result<void> Workbench::open_project(const fs::path& folder) {
  std::error_code error;
  if (session_ && fs::equivalent(folder, this->folder(), error)) {
    return Error{ErrorKind::kNothingToDo, "this project is open already", folder.string(), "", ""};
  }
  LUM_TRY(auto session, Session::open_project(*device_, roots_, folder, Project::Access::kWrite, diagnostics_));
  return adopt_session(std::move(session));
}

Result<void> Workbench::adopt_session(std::unique_ptr<Session> session) {
  live_painting_.reset();  // it looks at the stage of the session before
  quick_painting_.reset();
  quick_stage_.reset();
  canvas_.reset();
  stroke_.reset();
  trial_.reset();
  solo_.clear();
  offers_.reset();
  style_files_.reset();
  session_ = std::move(session);
  solving_ = resting_ = proposal_put_ = false;
  follow_again_ = session_->painted();  // a proposal is in no log: it is looked for again
  unanswered_ = session_->painted() ? 1 : 0;
  facts_of_ = 0;
  labels_.clear();
  undo_seen_ = session_->project().undo_steps();
  forget_pictures();
  return keep_unsaved();
}

Result<void> Workbench::keep_unsaved() {
  if (!session_->project().folder().empty() || unsaved_.empty()) return {};
  LUM_TRY_VOID(make_folder(unsaved_));
  std::error_code error;
  for (int number = 1;; ++number) {
    const fs::path folder = unsaved_ / fmt::format("untitled-{}-{}.lum", ::getpid(), number);
    if (!fs::exists(folder, error)) return session_->save_as(folder);
  }
}

Result<void> Workbench::save_as(const fs::path& folder) {
  const fs::path before = this->folder();
  LUM_TRY_VOID(session_->save_as(folder));
  std::error_code error;
  if (before.parent_path() == unsaved_ && before != folder) fs::remove_all(before, error);
  return {};
}

bool Workbench::can_follow() const {
  return live_ && check_free(session_->shown(), session_->stage().frame).has_value();
}

std::uint32_t Workbench::strokes() const {
  return static_cast<std::uint32_t>(number_at(session_->project().document(), "paint/strokes", 0.0F));
}

StrokeFile Workbench::file_of(const Stroke& stroke) const {
  const StrokeFile usual;
  const Document& document = session_->project().document();
  return {number_at(document, "paint/nu", usual.nu), number_at(document, "paint/delta", usual.delta), {stroke}};
}

/// Lights follow from what is shown now.
Result<void> Workbench::follow() {
  LUM_TRY(Canvas canvas, session_->canvas_copy());
  const ParamState& start = session_->shown();
  live_painting_.emplace(session_->stage(), std::move(canvas), start, waiting_lights(start.rig),
                         LivePainting::Options{});
  proposal_put_ = false;
  start_epsilon_ = live_painting_->error_of(live_painting_->target().before);
  return {};
}

Result<void> Workbench::hand_canvas() {
  if (canvas_) return {};
  LUM_TRY(canvas_, session_->canvas_copy());
  return {};
}

Result<void> Workbench::begin_stroke(const Stroke& stroke, const fs::path& folder) {
  auto begun = open_stroke(stroke, folder);
  if (!begun) drop_stroke();  // half of it may be on a canvas
  return begun;
}

Result<void> Workbench::open_stroke(const Stroke& stroke, const fs::path& folder) {
  if (stroke_) LUM_TRY_VOID(finish_stroke());
  trial_.reset();
  if (std::exchange(solving_, false)) session_->stop_solve();
  const bool follows = can_follow();
  const bool quick = follows && quick_stage_ != nullptr;
  const bool live = follows && !quick;
  if (quick) {
    LUM_TRY_VOID(begin_quick(stroke, folder));
  } else if (live) {
    if (!live_painting_) LUM_TRY_VOID(follow());
    LUM_TRY(const LiveEvent event, live_painting_->begin(stroke, folder.string()));
    live_epsilon_ = event.epsilon;
  } else {
    LUM_TRY_VOID(put_proposal());
    live_painting_.reset();
    LUM_TRY_VOID(hand_canvas());
    LUM_TRY_VOID(canvas_->begin_stroke(stroke, folder.string()));
  }
  stroke_ = {stroke, folder, live, quick};
  proposal_put_ = follow_again_ = false;
  if (unanswered_ == 0) unanswered_ = strokes() + 1;
  painted_.reset();
  if (!quick || quick_painting_->has_lights()) picture_.reset();
  return {};
}

/// The full canvas takes the stroke for the eye, the small one for the lights.
Result<void> Workbench::begin_quick(const Stroke& stroke, const fs::path& folder) {
  LUM_TRY_VOID(put_proposal());
  live_painting_.reset();
  LUM_TRY_VOID(hand_canvas());
  const ParamState& start = session_->shown();
  LUM_TRY(LivePainting painting,
          quick_stage_->paint(canvas_->state(), session_->state(), start, waiting_lights(start.rig)));
  LUM_TRY_VOID(canvas_->begin_stroke(stroke, folder.string()));
  LUM_TRY(const LiveEvent event, painting.begin(stroke, folder.string()));
  live_epsilon_ = event.epsilon;
  quick_painting_ = std::move(painting);
  return {};
}

/// What the small pictures found is the proposal from which the full ones go on.
void Workbench::end_quick() {
  if (quick_painting_ && quick_painting_->has_lights()) {
    SolveReport report;
    report.solver = "live";
    report.epsilon_start = start_epsilon_;
    report.epsilon = live_epsilon_;
    session_->propose(quick_painting_->best(), {{}, report, canvas_->target(), "Accept a live solve"});
  }
  quick_painting_.reset();
  follow_again_ = true;
}

Result<void> Workbench::extend_stroke(std::span<const StrokePoint> points) {
  if (!stroke_ || points.empty()) return {};
  // First, so that what is recorded is what the canvas got, whatever becomes of the lights.
  stroke_->stroke.points.insert(stroke_->stroke.points.end(), points.begin(), points.end());
  if (stroke_->live) {
    LUM_TRY(const LiveEvent event, live_painting_->extend(points));
    live_epsilon_ = event.epsilon;
  } else {
    LUM_TRY_VOID(canvas_->extend_stroke(points));
  }
  if (stroke_->quick) {
    LUM_TRY(const LiveEvent event, quick_painting_->extend(points));
    live_epsilon_ = event.epsilon;
  }
  painted_.reset();
  if (!stroke_->quick || quick_painting_->has_lights()) picture_.reset();
  return {};
}

Result<void> Workbench::end_stroke() {
  ++strokes_taken_;
  return finish_stroke();
}

Result<void> Workbench::finish_stroke() {
  if (!stroke_) return {};
  const HeldStroke held = *std::exchange(stroke_, std::nullopt);
  auto done = held.live ? live_painting_->end() : canvas_->end_stroke();
  if (done) done = session_->paint(file_of(held.stroke), file_in(held.folder));
  if (!done) {
    drop_stroke();
    return done;
  }
  resting_ = held.live;
  painted_.reset();
  if (held.quick) {
    end_quick();  // its picture stays until there is a full one
  } else {
    picture_.reset();
  }
  note_history();
  return {};
}

void Workbench::cancel_stroke() {
  ++strokes_taken_;
  drop_stroke();
}

void Workbench::drop_stroke() {
  stroke_.reset();
  live_painting_.reset();
  quick_painting_.reset();
  canvas_.reset();
  follow_again_ = session_->painted();
  if (unanswered_ > strokes()) unanswered_ = 0;
  forget_pictures();
}

Result<void> Workbench::lay(const Stroke& stroke, const fs::path& folder) {
  if (stroke_) LUM_TRY_VOID(finish_stroke());
  if (std::exchange(solving_, false)) session_->stop_solve();
  trial_.reset();
  ++strokes_taken_;
  const std::uint32_t first = strokes() + 1;
  if (can_follow() && quick_stage_ == nullptr) {
    if (!live_painting_) LUM_TRY_VOID(follow());
    LUM_TRY(const LiveEvent event, live_painting_->bucket(stroke, folder.string()));
    live_epsilon_ = event.epsilon;
    resting_ = true;
  } else {
    LUM_TRY_VOID(put_proposal());
    live_painting_.reset();
    canvas_.reset();
    follow_again_ = can_follow();
  }
  const auto shown = session_->has_proposal() ? std::optional(session_->shown()) : std::nullopt;
  const Solved* solved = session_->solved();
  const auto before = shown && solved != nullptr ? std::optional(*solved) : std::nullopt;
  if (auto done = session_->paint(file_of(stroke), file_in(folder)); !done) {
    drop_stroke();
    return done;
  }
  if (shown && before && !live_painting_) session_->propose(*shown, *before);  // the lights go on from there
  proposal_put_ = false;
  if (unanswered_ == 0) unanswered_ = first;
  forget_pictures();
  note_history();
  return {};
}

Result<void> Workbench::preview(const std::vector<std::string>& assignments) {
  LUM_TRY_VOID(put_proposal());
  ParamState trial = session_->shown();
  for (const std::string& assignment : assignments) LUM_TRY_VOID(set_path(trial, assignment));
  keep_constraints(trial.rig);
  trial_ = std::move(trial);
  picture_.reset();
  return {};
}

/// The lights that the brush found become the session's proposal.
Result<void> Workbench::put_proposal() {
  if (!live_painting_ || !live_painting_->has_lights() || proposal_put_ || stroke_) return {};
  SolveReport report;
  report.solver = "live";
  report.termination = live_painting_->termination();
  report.evals = live_painting_->pictures();
  report.epsilon_start = live_painting_->error_of(live_painting_->target().before);
  report.epsilon = live_painting_->error_of(live_painting_->picture());
  session_->propose(live_painting_->best(), {{}, report, live_painting_->target(), "Accept a live solve"});
  proposal_put_ = true;
  return {};
}

Result<void> Workbench::act(const Task& task, After after) {
  if (stroke_) LUM_TRY_VOID(finish_stroke());
  LUM_TRY_VOID(put_proposal());
  const Project& project = session_->project();
  const auto marks = [&] { return std::pair(project.undo_steps(), project.redo_steps()); };
  const auto before = marks();
  const bool proposed = session_->has_proposal();
  const auto done = task(*session_);
  const Solved* solved = session_->solved();
  const bool started = session_->has_proposal() && solved != nullptr &&
                       solved->report.termination == Termination::kRunning && solved->report.solver != "live";
  const bool changed = marks() != before || session_->has_proposal() != proposed || started != solving_;
  if (!changed && !trial_) return done;
  trial_.reset();
  live_painting_.reset();
  canvas_.reset();
  resting_ = proposal_put_ = false;
  solving_ = started;
  follow_again_ = after == After::kFollow && live_ && !solving_ && session_->painted();
  unanswered_ = session_->painted() && !session_->has_proposal() ? 1 : 0;
  forget_pictures();
  note_history();
  return done;
}

Result<void> Workbench::change(const Task& task, After after) {
  return act(
      [&](Session& session) -> Result<void> {
        if (session.has_proposal()) LUM_TRY_VOID(session.adopt());
        return task(session);
      },
      after);
}

void Workbench::set_live(bool live) {
  live_ = live;
  if (!session_ || stroke_) return;
  if (live) {
    follow_again_ = session_->painted() && !live_painting_;
  } else if (put_proposal()) {
    live_painting_.reset();
    follow_again_ = resting_ = false;
    forget_pictures();
  }
}

Result<void> Workbench::start_solve(const SolveOptions& options) {
  return act([&](Session& session) -> Result<void> {
    if (!session.has_proposal()) return session.start_solve(options);
    LUM_TRY(const Target* target, session.target());
    return session.start_solve(session.shown(), *target, options, Solved{}.label);
  });
}

void Workbench::stop() {
  if (std::exchange(solving_, false)) session_->stop_solve();
  resting_ = follow_again_ = false;
}

Result<void> Workbench::judge() {
  if (std::exchange(solving_, false)) session_->stop_solve();
  resting_ = follow_again_ = false;  // other lights would need another verdict
  LUM_TRY_VOID(put_proposal());
  LUM_TRY_VOID(session_->judge());
  return {};
}

Result<bool> Workbench::step(std::chrono::milliseconds slice) {
  if (!session_ || stroke_) return false;
  if (solving_) {
    auto more = session_->continue_solve(slice);
    if (!more || !*more) solving_ = false;
    unanswered_ = 0;
    constexpr std::chrono::milliseconds kBetweenPictures{200};  // a picture costs as much as several slices
    const auto now = std::chrono::steady_clock::now();
    if (!solving_ || now - solve_shown_ > kBetweenPictures) picture_.reset(), solve_shown_ = now;
    return more;
  }
  if (std::exchange(follow_again_, false) && can_follow()) {
    LUM_TRY_VOID(follow());
    resting_ = true;
  }
  if (!live_painting_ || !resting_) return false;
  LUM_TRY(const LiveEvent event, live_painting_->rest());
  resting_ = event.more;
  live_epsilon_ = event.epsilon;
  if (event.changed) picture_.reset(), proposal_put_ = false;
  const Shot& shot = session_->shot();
  if (picture_ && picture_->width != shot.width && live_painting_->has_lights()) picture_.reset();
  if (live_painting_->has_lights() && (event.changed || !event.more)) unanswered_ = 0;
  return resting_;
}

}  // namespace luminist
