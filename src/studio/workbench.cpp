#include "studio/workbench.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "raster/raster_renderer.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostKept = 200;  // places of the history whose proposals are known

float number_at(const Document& document, std::string_view path, float usual) {
  const std::string_view text = document.get(path);
  float value = usual;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

Workbench::Workbench(Device& device, AssetRoots roots, fs::path unsaved) {
  device_ = &device;
  roots_ = std::move(roots);
  unsaved_ = std::move(unsaved);
}

Result<void> Workbench::need_session() const {
  if (session_) return {};
  return Error{ErrorKind::kNothingToDo, "nothing is open", "", "", "open a scene or a project first"};
}

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
  drop_quick_stages();
  quick_size_ = {};  // rounds take another time there
  canvas_.reset();
  stroke_.reset();
  trial_.reset();
  solo_.clear();
  offers_.reset();
  style_files_.reset();
  session_ = std::move(session);
  solving_ = resting_ = proposal_put_ = false;
  after_solve_ = {};
  follow_again_ = session_->painted();  // a proposal is in no log: it is looked for again
  unanswered_ = session_->painted() ? 1 : 0;
  facts_of_ = 0;
  labels_.clear();
  kept_.clear();
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
  LUM_TRY_VOID(need_session());
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

Result<void> Workbench::preview(const std::vector<std::string>& assignments) {
  LUM_TRY_VOID(need_session());
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
  const SolveReport report = live_painting_->report_from(error_before_, session_->state());
  session_->propose(live_painting_->best(), {{}, report, live_painting_->target(), "Accept a live solve"});
  proposal_put_ = true;
  return {};
}

/// What is proposed at this place of the history is known when the lighter comes back to it.
void Workbench::keep_proposal() {
  const std::size_t place = session_->project().undo_steps();
  const Solved* solved = session_->has_proposal() ? session_->solved() : nullptr;
  kept_.erase(place);
  if (solved != nullptr)
    kept_.emplace(place,
                  KeptProposal{session_->shown(), solved->options, solved->report, solved->label, solved->frames});
  if (kept_.size() > kMostKept) {  // the farthest from here goes
    const bool first = place - std::min(place, kept_.begin()->first) > std::max(place, kept_.rbegin()->first) - place;
    kept_.erase(first ? kept_.begin() : std::prev(kept_.end()));
  }
}

/// The proposal that was here, or null.
const KeptProposal* Workbench::put_back_proposal() {
  const auto kept = kept_.find(session_->project().undo_steps());
  if (kept == kept_.end() || session_->has_proposal()) return nullptr;
  if (!session_->painted() && kept->second.frames.empty()) return nullptr;
  const auto target = session_->target();
  if (!target) return nullptr;
  const KeptProposal& known = kept->second;
  session_->propose(known.lights, {known.options, known.report, **target, known.label, std::nullopt, known.frames});
  return &known;
}

Result<void> Workbench::act(const Task& task, After after) {
  LUM_TRY_VOID(need_session());
  if (stroke_) LUM_TRY_VOID(finish_stroke());
  LUM_TRY_VOID(put_proposal());
  keep_proposal();
  const Project& project = session_->project();
  const auto marks = [&] { return std::pair(project.undo_steps(), project.redo_steps()); };
  const auto before = marks();
  const std::size_t newest = project.newest();
  const std::pair proposal(session_->has_proposal(), session_->dropped());
  const std::uint64_t stage = session_->stage().id;
  const auto done = task(*session_);
  if (session_->stage().id != stage) {  // what is small, and what is watched, was of the stage before
    drop_quick_stages();
    style_files_.reset();
    offers_.reset();  // their style blocks may be of another schema
  }
  const bool moved = marks().first != before.first && project.newest() == newest;  // by undo or redo
  const Solved* solved = session_->solved();
  const bool started = session_->has_proposal() && solved != nullptr &&
                       solved->report.termination == Termination::kRunning && solved->report.solver != "live";
  const bool changed = session_->stage().id != stage || marks() != before || started != solving_ ||
                       std::pair(session_->has_proposal(), session_->dropped()) != proposal;
  if (!changed && !trial_) return done;
  const KeptProposal* back = nullptr;
  if (moved) {
    back = put_back_proposal();
  } else if (marks() != before) {
    kept_.erase(kept_.lower_bound(std::min(before.first + 1, marks().first)), kept_.end());
  }
  if (!session_->has_proposal()) kept_.erase(project.undo_steps());
  trial_.reset();
  live_painting_.reset();
  quick_painting_.reset();
  canvas_.reset();
  resting_ = proposal_put_ = false;
  solving_ = started;
  after_solve_ = {};
  const bool found = back != nullptr && !back->goes_on();
  follow_again_ = after == After::kFollow && live_ && !solving_ && session_->painted() && !found;
  unanswered_ = session_->painted() && !session_->has_proposal() ? 1 : 0;
  forget_pictures();
  note_history();
  return done;
}

Result<void> Workbench::change(const Task& task, After after) {
  return act([&](Session& session) { return session.change_shown(task); }, after);
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

/// What it found until now stays the proposal, and is shown.
void Workbench::end_solve() {
  if (!std::exchange(solving_, false)) return;
  session_->stop_solve();
  picture_.reset();
}

void Workbench::stop() {
  end_solve();
  resting_ = follow_again_ = false;
  after_solve_ = {};
  want_full_picture();
}

/// What stands still is shown at its full size.
void Workbench::want_full_picture() {
  if (picture_ && session_ && picture_->width != session_->shot().width) picture_.reset();
}

void Workbench::after_solve(Task task) {
  if (solving_) after_solve_ = std::move(task);
}

Result<void> Workbench::judge(const std::function<bool()>& go_on) {
  LUM_TRY_VOID(need_session());
  end_solve();
  const bool followed = std::exchange(resting_, false) || follow_again_;
  follow_again_ = false;  // other lights would need another verdict
  want_full_picture();
  LUM_TRY_VOID(put_proposal());
  auto judged = session_->judge(go_on);
  if (judged) return {};
  if (judged.error().kind == ErrorKind::kCancelled) follow_again_ = followed;
  return std::move(judged).error();
}

Result<bool> Workbench::step(std::chrono::milliseconds slice) {
  if (!session_ || stroke_) return false;
  if (solving_) {
    auto more = session_->continue_solve(slice);
    if (!more || !*more) solving_ = false;
    const Task after = solving_ ? Task() : std::exchange(after_solve_, {});
    unanswered_ = 0;
    constexpr std::chrono::milliseconds kBetweenPictures{200};  // a picture costs as much as several slices
    const auto now = std::chrono::steady_clock::now();
    if (!solving_ || now - solve_shown_ > kBetweenPictures) picture_.reset(), solve_shown_ = now;
    if (more && after) LUM_TRY_VOID(after(*session_));
    return more;
  }
  if (follow_again_ && wants_other_quick()) {  // now, so that the next stroke need not wait for it
    make_quick_ready();
    return true;
  }
  if (std::exchange(follow_again_, false) && can_follow()) {
    LUM_TRY_VOID(follow());
    return resting_ = true;
  }
  RasterRenderer* raster = undisturbed_ && !quick_stages_.empty() ? session_->stage().raster : nullptr;
  if (raster == nullptr) return follow_at_rest();
  raster->ask(undisturbed_);
  auto more = follow_at_rest();
  raster->ask({});
  if (more || more.error().kind != ErrorKind::kCancelled) return more;
  LUM_TRY_VOID(put_proposal());
  live_painting_.reset();
  resting_ = false;
  follow_again_ = true;
  return true;
}

/// The lights that follow the paint go on while the hand rests. returns whether there is more to gain.
Result<bool> Workbench::follow_at_rest() {
  if (!live_painting_ || !resting_) return false;
  LUM_TRY(const LiveEvent event, live_painting_->rest());
  resting_ = event.more;
  if (event.changed) picture_.reset(), proposal_put_ = false;
  const Shot& shot = session_->shot();
  if (picture_ && picture_->width != shot.width && live_painting_->has_lights()) picture_.reset();
  if (live_painting_->has_lights() && (event.error < event.error_before || !event.more)) unanswered_ = 0;
  return resting_;
}

}  // namespace luminist
