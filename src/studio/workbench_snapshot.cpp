// The part of a workbench that says what there is to show.
#include <algorithm>
#include <utility>

#include "project/layer_document.h"
#include "rig/light_list.h"
#include "studio/paint_layers.h"
#include "studio/workbench.h"

namespace luminist {
namespace {

constexpr std::size_t kLabels = 60;  // commands that a list shows

}  // namespace

void Workbench::forget_pictures() {
  picture_.reset();
  painted_.reset();
  painted_buffers_.note_all();
  layers_.reset();
}

/// Labels of commands that were replaced by others are read again.
void Workbench::note_history() {
  const std::size_t undo = session_->project().undo_steps();
  if (session_->project().redo_steps() == 0 && undo != undo_seen_) {
    labels_.erase(labels_.lower_bound(std::min(undo, undo_seen_)), labels_.end());
  }
  undo_seen_ = undo;
}

void Workbench::tell_history(StudioSnapshot& next) {
  const Project& project = session_->project();
  HistoryFacts& history = next.history;
  history.undo_steps = project.undo_steps();
  history.redo_steps = project.redo_steps();
  const std::size_t end = history.undo_steps + std::min<std::size_t>(history.redo_steps, kLabels / 2);
  history.first = end > kLabels ? end - kLabels : 0;
  for (std::size_t i = history.first; i < end; ++i) {
    const auto known = labels_.find(i);
    if (known != labels_.end()) {
      history.labels.push_back(known->second);
      continue;
    }
    const auto command = project.command(i);
    history.labels.push_back(labels_[i] = command ? command->label : "?");
  }
  history.folder = project.folder();
  history.unsaved = history.folder.empty() || history.folder.parent_path() == unsaved_;
  history.writable = project.writable();
}

ShotFacts Workbench::facts() const {
  const Stage& stage = session_->stage();
  ShotFacts facts{session_->shot(),   stage.camera, stage.frame,         stage.renderer->surface(), stage.style.doc,
                  stage.style.metric, {},           stage.types.names(), stage.camera_names,        stage.bounds};
  for (const std::string& name : style_names(roots_)) {
    if (const auto style = load_style(roots_, name); style && style->shades()) facts.styles.push_back(name);
  }
  return facts;
}

const ParamState& Workbench::shown_lights() const {
  if (trial_) return *trial_;
  if (shows_quick()) return quick_painting_->best();
  return live_painting_ && live_painting_->has_lights() ? live_painting_->best() : session_->shown();
}

void Workbench::set_solo(std::vector<std::string> lights) {
  solo_ = std::move(lights);
  picture_.reset();
}

/// What is painted as it is under the hand; null: as the session has it.
const Target* Workbench::shown_target() const {
  return live_painting_ ? &live_painting_->target() : canvas_ ? &canvas_->target() : nullptr;
}

/// errors the renderer's.
Result<void> Workbench::refresh_pictures(StudioSnapshot& next) {
  const bool lights = live_painting_ && live_painting_->has_lights();
  if (!picture_) {
    if (trial_ || !solo_.empty()) {
      ParamState shown = shown_lights();
      solo_lights(shown.rig, solo_);
      LUM_TRY(Image picture, session_->stage().renderer->render(shown));
      picture_ = std::make_shared<const Image>(std::move(picture));
    } else if (shows_quick()) {
      picture_ = quick_painting_->shared_picture();
    } else if (lights) {
      picture_ = live_painting_->shared_picture();
    } else {
      LUM_TRY(const Image* picture, session_->picture());
      picture_ = std::make_shared<const Image>(*picture);
    }
  }
  if (!painted_) {
    const Target* target = shown_target();
    if (target == nullptr) {
      LUM_TRY(target, session_->target());
    }
    painted_ = painted_buffers_.show(*target);
    if (live_painting_ && !stroke_) error_before_ = live_painting_->error_of(live_painting_->target().before);
  }
  next.picture = picture_;
  next.painted = painted_;
  return {};
}

/// errors those of read_stack().
Result<void> Workbench::tell_layers(StudioSnapshot& next) {
  if (!layers_) {
    LUM_TRY(LayerStack stack, session_->layers().stack());
    layers_ = std::make_shared<const LayerStack>(std::move(stack));
  }
  next.layers = layers_;
  next.ground = has_ground(session_->project().document());
  return {};
}

void Workbench::tell_solve(StudioSnapshot& next) {
  const bool lights = live_painting_ && live_painting_->has_lights();
  const bool quick = shows_quick();
  next.proposal = session_->has_proposal() || lights || quick;
  next.solving = solving_ || follow_again_ || (live_painting_ && resting_);
  if (quick) {
    next.report = quick_painting_->report();
  } else if (lights && !proposal_put_) {
    next.report = live_painting_->report_from(error_before_, session_->state());
  } else if (const Solved* solved = session_->solved(); solved != nullptr && session_->has_proposal()) {
    next.report = solved->report;
    next.verdict = solved->verdict;
  }
}

Result<std::shared_ptr<const StudioSnapshot>> Workbench::snapshot() {
  const auto since = std::chrono::steady_clock::now();
  auto next = std::make_shared<StudioSnapshot>();
  next->cost = cost_;
  next->layers = std::make_shared<const LayerStack>();
  next->version = ++version_;
  next->live = live_;
  next->strokes_taken = strokes_taken_;
  next->points_taken = stroke_ ? stroke_->stroke.points.size() : 0;
  next->solo = solo_;
  next->offers = offers_;
  if (!session_) return std::shared_ptr<const StudioSnapshot>(next);
  if (facts_of_ != session_->stage().id) {
    facts_ = std::make_shared<const ShotFacts>(facts());
    facts_of_ = session_->stage().id;
  }
  next->facts = facts_;
  LUM_TRY_VOID(refresh_pictures(*next));
  const ParamState& shown = shown_lights();
  next->shown = std::make_shared<const ParamState>(shown);
  next->waiting = waiting_lights(shown.rig);
  const std::vector<const ParamBlock*> blocks = shown.blocks();
  next->free_dofs = UnitMap::create(blocks, session_->stage().frame).dofs();
  const StrokeFile importance = file_of({});
  next->nu = importance.nu;
  next->delta = importance.delta;
  next->any_paint = session_->painted() || stroke_.has_value();
  next->unanswered = unanswered_;
  tell_solve(*next);
  LUM_TRY_VOID(tell_layers(*next));
  tell_history(*next);
  cost_.snapshot = std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
  return std::shared_ptr<const StudioSnapshot>(next);
}

std::vector<std::string> Workbench::take_warnings() {
  std::vector<std::string> lines;
  const auto& all = diagnostics_.warnings();
  for (; warnings_told_ < all.size(); ++warnings_told_) {
    const Diagnostics::Warning& warning = all[warnings_told_];
    lines.push_back(warning.where.empty() ? warning.what : warning.where + ": " + warning.what);
  }
  return lines;
}

}  // namespace luminist
