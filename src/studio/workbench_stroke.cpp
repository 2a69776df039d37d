// The part of a workbench that paints.
#include <algorithm>
#include <utility>

#include "raster/raster_renderer.h"
#include "studio/workbench.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

/// Copies of a stroke are looked for beside the file that it came from.
std::string file_in(const fs::path& folder) {
  return (folder / "strokes.json").string();
}

}  // namespace

/// Lights follow from what is shown now.
Result<void> Workbench::follow() {
  LUM_TRY(Canvas canvas, session_->canvas_copy());
  const ParamState& start = session_->shown();
  painted_buffers_.note_change(shown_target(), canvas.target());
  live_painting_.emplace(session_->stage(), std::move(canvas), start, waiting_lights(start.rig),
                         LivePainting::Options{});
  proposal_put_ = false;
  error_before_ = live_painting_->error_of(live_painting_->target().before);
  return {};
}

Result<void> Workbench::hand_canvas() {
  if (canvas_) return {};
  painted_buffers_.note_all();
  LUM_TRY(canvas_, session_->canvas_copy());
  return {};
}

Result<void> Workbench::begin_stroke(const Stroke& stroke, const fs::path& folder) {
  LUM_TRY_VOID(need_session());
  auto begun = open_stroke(stroke, folder);
  if (!begun) drop_stroke();  // half of it may be on a canvas
  return begun;
}

Result<void> Workbench::open_stroke(const Stroke& stroke, const fs::path& folder) {
  if (stroke_) LUM_TRY_VOID(finish_stroke());
  if (std::exchange(trial_, std::nullopt)) picture_.reset();
  end_solve();
  LUM_TRY_VOID(put_proposal());
  const bool follows = can_follow();
  const bool quick = follows && !quick_stages_.empty();
  const bool live = follows && !quick;
  if (quick) {
    LUM_TRY_VOID(begin_quick(stroke, folder));
  } else if (live) {
    canvas_.reset();  // the stroke is not on it
    if (!live_painting_) LUM_TRY_VOID(follow());
    LUM_TRY(const LiveEvent event, live_painting_->begin(stroke, folder.string()));
    note_event(event, 0.0);
  } else {
    live_painting_.reset();
    quick_painting_.reset();
    LUM_TRY_VOID(hand_canvas());
    LUM_TRY(const PixelBox box, canvas_->begin_stroke(stroke, folder.string()));
    painted_buffers_.note(box);
  }
  stroke_ = {stroke, folder, live, quick};
  proposal_put_ = follow_again_ = false;
  if (unanswered_ == 0) unanswered_ = strokes() + 1;
  painted_.reset();
  if (!quick || shows_quick()) picture_.reset();
  return {};
}

/// The largest that is quick enough, or else the smallest that is ready.
const QuickStage& Workbench::quick_stage() const {
  constexpr double kNearEnough = 1.3;  // there are three sizes
  const auto fits = [&](const auto& stage) { return stage->pixels() <= kNearEnough * quick_size_.pixels(); };
  const auto found = std::ranges::find_if(quick_stages_, fits);
  return found == quick_stages_.end() ? *quick_stages_.back() : **found;
}

void Workbench::drop_quick_stages() {
  quick_painting_.reset();
  quick_stages_.clear();
}

/// The hand's canvas and a small painting go on from what is shown.
Result<void> Workbench::go_on_quick() {
  live_painting_.reset();
  LUM_TRY_VOID(hand_canvas());
  const ParamState& start = session_->shown();
  constexpr double kMuchTooLarge = 2.0;  // what only does better in another size waits until the hand rests
  const bool much_too_large = quick_painting_ && quick_of_->pixels() > kMuchTooLarge * quick_size_.pixels();
  if (quick_painting_ && (!much_too_large || quick_of_ == &quick_stage())) {
    quick_painting_->go_on_from(start, waiting_lights(start.rig));
  } else {
    LUM_TRY_VOID(open_quick());
  }
  return {};
}

/// The full canvas takes the stroke for the eye, the small one for the lights.
Result<void> Workbench::begin_quick(const Stroke& stroke, const fs::path& folder) {
  LUM_TRY_VOID(go_on_quick());
  LUM_TRY(const PixelBox box, canvas_->begin_stroke(stroke, folder.string()));
  painted_buffers_.note(box);
  LUM_TRY([[maybe_unused]] const LiveEvent event, quick_painting_->begin(stroke, folder.string()));
  return {};
}

/// A small painting of what is on the hand's canvas.
Result<void> Workbench::open_quick() {
  const QuickStage& stage = quick_stage();
  const ParamState& start = session_->shown();
  LUM_TRY(quick_painting_, stage.paint(canvas_->state(), session_->state(), start, waiting_lights(start.rig)));
  quick_of_ = &stage;
  return {};
}

/// There is none for the next stroke, or one of another size would do better.
bool Workbench::wants_other_quick() const {
  if (stroke_ || quick_stages_.empty() || !can_follow()) return false;
  return !quick_painting_ || quick_of_ != &quick_stage();
}

/// What the next stroke would wait for.
Result<void> Workbench::prepare_stroke() {
  if (!wants_other_quick()) return {};
  LUM_TRY_VOID(put_proposal());
  LUM_TRY_VOID(hand_canvas());
  LUM_TRY_VOID(open_quick());
  return quick_painting_->get_ready();
}

/// What the shadow brush copies, so that its first stroke need not wait for two pictures. Copies of the session's
/// canvas share it: it is of the lights in force, which change seldom. Given up for a hand, and made another time then.
void Workbench::prepare_shadows() {
  constexpr PaintTool kBrush = PaintTool::kShadow;
  RasterRenderer* raster = session_->stage().raster;  // a traced picture takes long, and nothing gives it up
  if (stroke_ || raster == nullptr || unshadowed_ == session_->stage().id) return;
  const bool known = canvas_ && canvas_->has_shadows(kBrush);
  if (known && (!quick_painting_ || quick_painting_->has_shadows(kBrush))) return;
  auto ready = hand_canvas();
  if (undisturbed_) raster->ask(undisturbed_);
  if (ready) ready = canvas_->ready_shadows(kBrush);
  raster->ask({});
  if (ready && quick_painting_) ready = quick_painting_->ready_shadows(kBrush);
  if (!ready && ready.error().kind != ErrorKind::kCancelled) unshadowed_ = session_->stage().id;  // the stroke says why
}

/// Where it fails strokes are answered by full pictures, late.
void Workbench::make_quick_ready() {
  const auto ready = prepare_stroke();
  if (ready) return;
  diagnostics_.warn(ready.error().where, ready.error().what);
  unprepared_ = session_->stage().id;  // it would fail again
  drop_quick_stages();
}

/// What the event took; paint: on a full canvas beside the small one, in seconds, or 0.
void Workbench::note_event(const LiveEvent& event, double paint) {
  const double snapshot = cost_.snapshot;
  cost_ = paint > 0.0 ? EventCost{paint, event.paint, event.retarget, event.solve, event.picture, snapshot}
                      : EventCost{event.paint, 0.0, event.retarget, event.solve, event.picture, snapshot};
  if (paint > 0.0) {
    quick_size_.note(cost_.paint + cost_.solve, cost_.preview + cost_.retarget + cost_.picture,
                     static_cast<double>(quick_painting_->target().color.pixels()));
  } else {
    painted_buffers_.note(event.painted);
  }
}

/// What the small pictures found is the proposal from which the full ones go on.
void Workbench::end_quick() {
  if (quick_painting_ && quick_painting_->has_lights()) {
    const double before = quick_painting_->error_of(quick_painting_->target().before);
    const SolveReport report = quick_painting_->report_from(before, session_->state());
    session_->propose(quick_painting_->best(), {{}, report, canvas_->target(), "Accept a live solve"});
  }
  follow_again_ = true;
}

Result<void> Workbench::extend_stroke(std::span<const StrokePoint> points) {
  if (!stroke_ || points.empty()) return {};
  // First, so that what is recorded is what the canvas got, whatever becomes of the lights.
  stroke_->stroke.points.insert(stroke_->stroke.points.end(), points.begin(), points.end());
  double paint = 0.0;
  bool changed = false;
  painted_.reset();
  if (stroke_->live) {
    const auto event = live_painting_->extend(points);
    if (!event) {
      painted_buffers_.note_all();  // whatever became of the lights, the points may be on the canvas
      return event.error();
    }
    note_event(*event, 0.0);
    changed = event->changed;
  } else {
    const auto since = std::chrono::steady_clock::now();
    LUM_TRY(const PixelBox box, canvas_->extend_stroke(points));
    painted_buffers_.note(box);
    paint = std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
  }
  if (stroke_->quick) {
    LUM_TRY(const LiveEvent event, quick_painting_->extend(points));
    note_event(event, std::max(paint, 1e-9));
    changed = event.changed;
  }
  if (changed) picture_.reset();
  return {};
}

Result<void> Workbench::end_stroke() {
  ++strokes_taken_;
  return session_ ? finish_stroke() : Result<void>();
}

Result<void> Workbench::finish_stroke() {
  if (!stroke_) return {};
  const HeldStroke held = *std::exchange(stroke_, std::nullopt);
  auto done = held.live ? live_painting_->end() : canvas_->end_stroke();
  if (done) {
    done = record([&](Session& session) { return session.paint(file_of(held.stroke), file_in(held.folder)); });
  }
  if (!done) {
    drop_stroke();
    return done;
  }
  resting_ = held.live;
  if (held.live) error_before_ = live_painting_->error_of(live_painting_->target().before);
  painted_.reset();
  if (held.quick) {
    if (!quick_painting_->end()) quick_painting_.reset();  // so small that its gradient met no surface
    end_quick();                                           // its picture stays until there is a full one
  } else {
    picture_.reset();
  }
  return {};
}

/// What paints is recorded; the lights that were found for what was painted before stay a proposal.
Result<void> Workbench::record(const Task& task) {
  keep_proposal();
  const Project& project = session_->project();
  const std::size_t before = project.undo_steps();
  const Solved* solved = session_->solved();
  std::optional<ParamState> lights;
  std::optional<Solved> report;
  if (session_->has_proposal() && solved != nullptr) lights = session_->shown(), report = *solved;
  LUM_TRY_VOID(task(*session_));
  if (project.undo_steps() != before) kept_.erase(kept_.lower_bound(before + 1), kept_.end());
  if (lights && (session_->painted() || !report->frames.empty()) && !session_->has_proposal()) {
    report->verdict.reset();  // it was of other paint
    session_->propose(std::move(*lights), std::move(*report));
  }
  proposal_put_ = false;
  layers_.reset();
  note_history();
  return {};
}

Result<void> Workbench::repaint(const Task& task) {
  LUM_TRY_VOID(need_session());
  if (stroke_) LUM_TRY_VOID(finish_stroke());
  end_solve();
  LUM_TRY_VOID(put_proposal());
  const std::size_t before = session_->project().undo_steps();
  layers_.reset();  // one layer may be chosen in place of another
  auto done = record(task);
  if (session_->project().undo_steps() == before) {
    follow_again_ = follow_again_ || std::exchange(resting_, false);
    live_painting_.reset();
    quick_painting_.reset();
    canvas_.reset();
    painted_buffers_.note_all();
    return done;
  }
  trial_.reset();
  live_painting_.reset();
  quick_painting_.reset();
  canvas_.reset();
  resting_ = false;
  follow_again_ = live_ && session_->painted();
  unanswered_ = session_->painted() ? 1 : 0;
  forget_pictures();
  return done;
}

void Workbench::cancel_stroke() {
  ++strokes_taken_;
  if (session_) drop_stroke();
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
  LUM_TRY_VOID(need_session());
  if (stroke_) LUM_TRY_VOID(finish_stroke());
  end_solve();
  trial_.reset();
  ++strokes_taken_;
  const std::uint32_t first = strokes() + 1;
  LUM_TRY_VOID(put_proposal());
  const bool quick = can_follow() && !quick_stages_.empty();
  if (quick) {
    LUM_TRY_VOID(go_on_quick());
    const auto box = canvas_->apply(stroke, folder.string());
    if (!box) {
      drop_stroke();
      return box.error();
    }
    painted_buffers_.note(*box);
    const auto event = quick_painting_->bucket(stroke, folder.string());
    if (!event) quick_painting_.reset();
  } else if (can_follow()) {
    canvas_.reset();  // the stroke is not on it
    if (!live_painting_) LUM_TRY_VOID(follow());
    const auto event = live_painting_->bucket(stroke, folder.string());
    if (!event) {
      drop_stroke();
      return event.error();
    }
    note_event(*event, 0.0);
    resting_ = true;
  } else {
    live_painting_.reset();
    quick_painting_.reset();
    canvas_.reset();
  }
  auto done = record([&](Session& session) { return session.paint(file_of(stroke), file_in(folder)); });
  if (!done) {
    drop_stroke();
    return done;
  }
  if (quick) end_quick();
  if (unanswered_ == 0) unanswered_ = first;
  picture_.reset();
  painted_.reset();
  if (!quick) painted_buffers_.note_all();
  return {};
}

}  // namespace luminist
