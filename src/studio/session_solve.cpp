// The part of a session that solves.
#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "project/frame_paint.h"
#include "project/paint_document.h"
#include "project/state_document.h"
#include "studio/session.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

Error no_proposal() {
  return {ErrorKind::kNothingToDo, "there is no solve to accept or revert", "", "", "solve first"};
}

}  // namespace

Result<void> Session::start_solve(const SolveOptions& options) {
  if (!painted()) {
    return Error{ErrorKind::kNothingToDo, "nothing is painted", "", "", "paint the light that you want to see"};
  }
  LUM_TRY(const Canvas* canvas, this->canvas());
  ParamState start = state_;
  if (const std::vector<std::string> waiting = waiting_lights(start.rig); !waiting.empty()) {
    LUM_TRY_VOID(place_lights(waiting, stage_->renderer->surface(), canvas->target(), stage_->frame, start.rig));
  }
  return start_solve(std::move(start), canvas->target(), options, Solved{}.label);
}

Result<void> Session::start_solve(ParamState lights, Target target, const SolveOptions& options,
                                  const std::string& label) {
  LUM_TRY(SolveSession solve,
          SolveSession::create(*stage_->renderer, std::move(lights), target, options, stage_->edges));
  drop_proposal();
  solved_ = Solved{options, solve.report(), std::move(target), label};
  solve_ = std::move(solve);
  return {};
}

void Session::propose(ParamState lights, Solved solved) {
  drop_proposal();
  solved_ = std::move(solved);
  proposed_ = std::move(lights);
}

void Session::drop_proposal() {
  if (has_proposal()) ++dropped_;
  solve_.reset();
  proposed_.reset();
  picture_.reset();
}

Result<bool> Session::continue_solve(std::chrono::milliseconds slice) {
  if (!solve_) return no_proposal();
  picture_.reset();
  solved_->verdict.reset();
  return solve_->run_for(slice);
}

void Session::stop_solve() {
  if (solve_) solve_->stop();
}

Result<void> Session::solve(const SolveOptions& options, const SolveWatch& watch) {
  LUM_TRY_VOID(start_solve(options));
  return finish_solve(watch);
}

Result<void> Session::finish_solve(const SolveWatch& watch) {
  for (bool more = true; more;) {
    LUM_TRY(more, continue_solve(std::chrono::milliseconds(50)));
    if (more && watch && !watch(solve_->report())) {
      stop_solve();
      more = false;
    }
  }
  return {};
}

const Solved* Session::solved() {
  if (solve_) solved_->report = solve_->report();
  return solved_ ? &*solved_ : nullptr;
}

Result<void> Session::accept() {
  if (!has_proposal()) return no_proposal();
  ParamState next = shown();
  follow_with_keys(next.rig, shot_.frame);
  LUM_TRY(Image picture, stage_->renderer->render(next));
  Document document = project_.document();
  write_state(next, document);
  Solved accepted = *solved();
  std::optional<Canvas> rebased;  // unless its paint took no part
  if (accepted.frames.empty() || std::ranges::count(accepted.frames, vantage(), &SolvedFrame::at) > 0) {
    LUM_TRY(const Canvas* canvas, this->canvas());
    rebased = *canvas;
    rebased->rebase(picture);
    LUM_TRY_VOID(write_paint(rebased->state(), document, project_.tiles()));
  }
  for (const SolvedFrame& each : accepted.frames) {
    if (each.at != vantage()) put_frame_paint(document, vantage(), each.at, each.accepted);
  }
  const SolveReport& report = accepted.report;
  const Json action = {{"do", "accept"},
                       {"solver", report.solver},
                       {"seed", accepted.options.seed},
                       {"evals", report.evals},
                       {"epsilon_start", report.epsilon_start},
                       {"epsilon", report.epsilon},
                       {"termination", to_string(report.termination)}};
  const std::string label =
      fmt::format("{}: error {:.4g} to {:.4g}", accepted.label, report.error_start(), report.error());
  LUM_TRY_VOID(commit(label, action.dump(), document));
  solved_ = std::move(accepted);
  state_ = std::move(next);
  canvas_ = std::move(rebased);
  picture_ = std::move(picture);
  return {};
}

Result<void> Session::adopt() {
  if (!has_proposal()) return no_proposal();
  ParamState next = shown();
  return commit_state("Take the lights of a solve", Json{{"do", "adopt"}}.dump(), std::move(next));
}

Result<void> Session::revert() {
  if (!has_proposal()) return no_proposal();
  drop_proposal();
  solved_.reset();
  return {};
}

Result<void> Session::change_shown(const std::function<Result<void>(Session&)>& change) {
  if (!has_proposal()) return change(*this);
  ParamState lights = shown();
  follow_with_keys(lights.rig, shot_.frame);
  ParamState in_force = std::exchange(state_, std::move(lights));
  auto solve = std::exchange(solve_, std::nullopt);
  auto proposed = std::exchange(proposed_, std::nullopt);
  auto solved = std::exchange(solved_, std::nullopt);
  const auto steps = [&] { return std::pair(project_.undo_steps(), project_.redo_steps()); };
  const auto before = steps();
  auto done = change(*this);
  if (!done || (steps() == before && !has_proposal())) {
    state_ = std::move(in_force);
    solve_ = std::move(solve);
    proposed_ = std::move(proposed);
    solved_ = std::move(solved);
    canvas_.reset();  // an unpainted one may show other lights
    return done;
  }
  // What left the lights alone has not recorded them.
  Document next = project_.document();
  write_state(state_, next);
  std::vector<Edit> edits = difference(project_.document(), next);
  if (edits.empty()) return {};
  return project_.execute({"Take the lights of a solve", Json{{"do", "adopt"}}.dump(), std::move(edits)});
}

}  // namespace luminist
