// One rig for several frames and cameras (studio/shots.h).
#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "params/param_text.h"
#include "project/paint_document.h"
#include "studio/shared_solve.h"
#include "studio/shots.h"
#include "verdict/judge.h"

namespace luminist {
namespace {

/// What a frame looks like and what is painted on it, as if it were looked at.
struct FrameView {
  FrameChoice choice;
  std::shared_ptr<Stage> own;  ///< null: the session's stage shows it
  Renderer* renderer = nullptr;
  Canvas canvas;
};

Error unfit(std::string what, std::string hint) {
  return {ErrorKind::kUsage, std::move(what), "", "frames", std::move(hint)};
}

Result<void> check_choices(std::span<const FrameChoice> frames, const std::vector<PaintedFrame>& painted,
                           std::span<const std::string> cameras) {
  if (frames.size() < 2) return unfit("a rig is shared by two frames or cameras at least", "solve this one by itself");
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string name = vantage_text(frames[i].at, cameras);
    if (!(frames[i].weight > 0.0)) return unfit("a weight is above zero", "leave " + name + " out");
    for (std::size_t k = 0; k < i; ++k) {
      if (frames[k].at == frames[i].at) return unfit(fmt::format("{} is named twice", name), "");
    }
    if (std::ranges::none_of(painted, [&](const PaintedFrame& each) { return each.at == frames[i].at; })) {
      return Error{ErrorKind::kNothingToDo, fmt::format("nothing is painted at {}", name), "", "frames",
                   "paint the light that you want to see there"};
    }
  }
  return {};
}

/// What has keys differs from frame to frame as they say, and is nothing that the frames share.
LightRig with_keys_locked(const LightRig& rig) {
  LightRig shared = rig;
  for (const KeyTrack& track : rig.keys) {
    ParamBlock* block = keyed_block(shared, track.light);
    const auto param = block != nullptr ? block->schema().find(track.param) : std::nullopt;
    if (!param) continue;
    if (track.component < 0) {
      block->set_param_locked(*param, true);
    } else {
      block->set_locked(block->schema()[*param].first_dof + track.component, true);
    }
  }
  return shared;
}

/// Lights that were found, as they stand at a frame, with the locks of the rig that they were found for.
LightRig found_at(LightRig found, const LightRig& given, double frame) {
  pose(found, frame);
  for (Light& light : found.lights) {
    const Light* own = given.find(light.name);
    for (int dof = 0; own != nullptr && dof < light.params.schema().dofs(); ++dof) {
      light.params.set_locked(dof, own->params.locked_by_hand(dof));
    }
  }
  for (int dof = 0; dof < found.ambient.schema().dofs(); ++dof) {
    found.ambient.set_locked(dof, given.ambient.locked_by_hand(dof));
  }
  return found;
}

Result<void> check_shared(const ParamState& given, const LightRig& shared, const SceneFrame& frame) {
  if (!check_free(given, frame) || check_free({shared, given.style, given.materials}, frame)) return {};
  return Error{ErrorKind::kNothingToDo, "all that may change has keys, which say what it is in each frame", "", "keys",
               "unlock something without keys that the frames share, or solve one frame after the other"};
}

/// The stage that shows a vantage; null: the session's. Views that look alike share one.
Result<std::shared_ptr<Stage>> stage_of(SessionData& session, const Vantage& at, std::span<const FrameView> opened) {
  const bool moving = session.stage_->moving != nullptr;
  const auto alike = [&](const Vantage& other) {
    return other.camera == at.camera && (!moving || other.frame == at.frame);
  };
  if (alike(session.vantage())) return std::shared_ptr<Stage>();
  for (const FrameView& view : opened) {
    if (alike(view.choice.at)) return view.own;
  }
  Shot shot = session.shot_;
  shot.camera = at.camera;
  shot.frame = at.frame;
  Diagnostics told_already;
  LUM_TRY(auto stage,
          open_stage(*session.device_, session.roots_, shot, session.folder_, told_already, session.stage_->moving));
  return std::shared_ptr<Stage>(std::move(stage));
}

Result<FrameView> open_view(SessionData& session, const FrameChoice& choice, std::span<const FrameView> opened) {
  LUM_TRY(auto own, stage_of(session, choice.at, opened));
  Renderer& renderer = own ? *own->renderer : *session.stage_->renderer;
  ParamState there = session.state_;
  pose(there.rig, choice.at.frame);
  LUM_TRY(Image picture, renderer.render(there));
  Canvas canvas(renderer.surface(), std::move(picture), {});
  const Document document = at_vantage(session.project_.document(), session.vantage(), choice.at);
  LUM_TRY(CanvasState painted, read_paint(document, session.project_.tiles(), canvas.state()));
  canvas.restore(std::move(painted));
  return FrameView{choice, std::move(own), &renderer, std::move(canvas)};
}

/// What became of one frame; its paint as it is when the lights are accepted.
Result<SolvedFrame> outcome(SharedSolve& solve, std::size_t k, FrameView& view, TileStore& tiles, bool judged) {
  SolvedFrame done{view.choice.at, view.choice.weight, 0.0, 0.0, std::nullopt, {}};
  LUM_TRY(const SharedSolve::Errors errors, solve.errors(k));
  done.start = errors.start;
  done.found = errors.found;
  const ParamState state = solve.state(k);
  LUM_TRY(const Image picture, view.renderer->render(state));
  if (judged) {
    LUM_TRY(done.verdict, judge(*view.renderer, state, view.canvas.target(), picture));
  }
  Canvas rebased = view.canvas;
  rebased.rebase(picture);
  LUM_TRY_VOID(write_paint(rebased.state(), done.accepted, tiles));
  return done;
}

/// Which of the frames is looked at; the first one if none is.
std::size_t place_of(const Vantage& present, std::span<const FrameChoice> frames) {
  const auto found = std::ranges::find(frames, present, &FrameChoice::at);
  return found == frames.end() ? 0 : static_cast<std::size_t>(found - frames.begin());
}

/// Dark lights begin where the paint of the first frame that takes part says.
Result<LightRig> starting_rig(const LightRig& rig, const FrameView& view, const SceneFrame& frame) {
  LightRig start = rig;
  const std::vector<std::string> waiting = waiting_lights(start);
  if (!waiting.empty()) {
    LUM_TRY_VOID(place_lights(waiting, view.renderer->surface(), view.canvas.target(), frame, start));
  }
  return start;
}

}  // namespace

Result<void> Shots::solve(std::span<const FrameChoice> wanted, const SolveOptions& options, bool judged,
                          const Session::SolveWatch& watch, const Look& look) {
  Session& session = *session_;
  std::vector<FrameChoice> choices(wanted.begin(), wanted.end());
  for (FrameChoice& each : choices) {
    LUM_TRY(each.at, known(each.at));
  }
  const std::span<const FrameChoice> frames = choices;
  LUM_TRY_VOID(check_choices(frames, painted(), session.stage_->camera_names));
  std::vector<FrameView> own;
  std::vector<View> views;
  for (const FrameChoice& choice : frames) {
    LUM_TRY(FrameView view, open_view(session, choice, own));
    LightRig there = session.state_.rig;
    LUM_TRY(const bool moves,
            pose_lights(there, *session.stage_, view.own ? *view.own : *session.stage_, choice.at.frame));
    if (moves) {
      return unfit("lights of the scene that move differ from frame to frame",
                   "move them by hand, so that they stay, or solve one frame after the other");
    }
    own.push_back(std::move(view));
  }
  for (const FrameView& view : own) {
    const auto& [at, weight] = view.choice;
    const auto keys_at = session.state_.rig.keys.empty() ? std::nullopt : std::optional(at.frame);
    views.push_back(
        {view.renderer, view.canvas.target(), session.state_.style, weight, session.state_.materials, keys_at});
  }
  const LightRig shared = with_keys_locked(session.state_.rig);
  LUM_TRY_VOID(check_shared(session.state_, shared, session.stage_->frame));
  LUM_TRY(const LightRig rig, starting_rig(shared, own.front(), session.stage_->frame));
  LUM_TRY(SharedSolve solve, SharedSolve::create(std::move(views), rig, options));
  const std::size_t here = place_of(present(), frames);
  bool stopped = false;
  double shown = std::numeric_limits<double>::infinity();
  for (bool more = true; more && !stopped;) {
    LUM_TRY(more, solve.run_for(std::chrono::milliseconds(50)));
    stopped = more && watch && !watch(solve.report());
    if (!look || !(solve.report().epsilon < shown)) continue;
    shown = solve.report().epsilon;
    ParamState seen = solve.state(here);
    seen.rig = found_at(std::move(seen.rig), session.state_.rig, session.shot_.frame);
    LUM_TRY_VOID(look(seen));
  }
  if (stopped) solve.stop();
  LUM_TRY(const Target* target, session.target());
  Solved solved{options, solve.report(), *target, fmt::format("Accept a solve of {} pictures", frames.size())};
  for (std::size_t k = 0; k < own.size(); ++k) {
    const bool may_judge = judged && !stopped;
    LUM_TRY(SolvedFrame done, outcome(solve, k, own[k], session.project_.tiles(), may_judge));
    if (done.at == present()) solved.verdict = done.verdict;
    solved.frames.push_back(std::move(done));
    stopped = stopped || (watch && !watch(solve.report()));
  }
  ParamState found = solve.state(0);
  found.rig = found_at(std::move(found.rig), session.state_.rig, session.shot_.frame);
  session.propose(std::move(found), std::move(solved));
  return {};
}

}  // namespace luminist
