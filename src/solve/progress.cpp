#include "solve/progress.h"

#include <algorithm>
#include <utility>

namespace luminist {

Progress::Progress(const Renderer& renderer, ParamState start, const SolveOptions& options)
    : renderer_(&renderer), options_(options), best_(std::move(start)), work_before_(renderer.work()) {
  const auto lit =
      std::count_if(best_.rig.lights.begin(), best_.rig.lights.end(), [](const Light& light) { return !light.muted; });
  const double lights = std::max<double>(1.0, static_cast<double>(lit));
  picture_work_ = std::max(1.0, 2.0 * static_cast<double>(renderer.surface().pixels()) * lights);
}

void Progress::tally() {
  const WorkCount& now = renderer_->work();
  const double work = now.shades - work_before_.shades + now.shadow_queries - work_before_.shadow_queries;
  report_.render_equivalents = work / picture_work_;
}

void Progress::record(const ParamState& state, double epsilon) {
  record(state, epsilon, penalty_of(state, renderer_->frame()));
}

void Progress::record(const ParamState& state, double epsilon, double penalty) {
  tally();
  ++report_.evals;
  const bool first = report_.evals == 1;
  if (first) {
    report_.epsilon_start = epsilon;
    report_.penalty_start = penalty;
  }
  if (first || epsilon < report_.epsilon) {
    report_.epsilon = epsilon;
    report_.penalty = penalty;
    best_ = state;
    report_.convergence.push_back({report_.render_equivalents, report_.evals, report_.seconds, epsilon});
  }
  if (report_.epsilon <= options_.until) {
    finish(Termination::kTargetReached);
  } else if (report_.evals >= options_.max_evals) {
    finish(Termination::kEvalLimit);
  }
}

void Progress::improve(const ParamState& state, double epsilon) {
  report_.epsilon = epsilon;
  report_.penalty = penalty_of(state, renderer_->frame());
  best_ = state;
  report_.convergence.push_back({report_.render_equivalents, report_.evals, report_.seconds, epsilon});
  if (epsilon <= options_.until) finish(Termination::kTargetReached);
}

void Progress::finish(Termination termination) {
  if (running()) report_.termination = termination;
}

}  // namespace luminist
