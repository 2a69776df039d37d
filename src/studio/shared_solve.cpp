#include "studio/shared_solve.h"

#include "base/check.h"

namespace luminist {

Result<SharedSolve> SharedSolve::create(std::span<Session* const> sessions, std::span<const double> weights,
                                        const SolveOptions& options) {
  LUM_CHECK(!sessions.empty() && weights.size() == sessions.size(), "somebody shares the rig, with a weight each");
  std::vector<View> views;
  for (std::size_t k = 0; k < sessions.size(); ++k) {
    Session* session = sessions[k];
    if (!session->painted()) {
      return Error{ErrorKind::kNothingToDo, "nothing is painted", session->stage().style.name, "",
                   "paint the light that you want to see"};
    }
    LUM_TRY(const Target* target, session->target());
    const ParamState& state = session->state();
    views.push_back({session->stage().renderer.get(), *target, state.style, weights[k], state.materials});
  }
  return create(std::move(views), sessions.front()->state().rig, options);
}

Result<SharedSolve> SharedSolve::create(std::vector<View> views, const LightRig& rig, const SolveOptions& options) {
  LUM_TRY(std::unique_ptr<Views> joined, Views::create(std::move(views)));
  ParamState start = joined->joint(rig);
  SharedSolve shared(std::move(joined), std::move(start));
  LUM_TRY(shared.solve_, SolveSession::create(*shared.views_, shared.start_, shared.views_->target(), options));
  return shared;
}

ParamState SharedSolve::state(std::size_t session) const {
  return views_->state_of(solve_->best(), static_cast<int>(session));
}

Result<SharedSolve::Errors> SharedSolve::errors(std::size_t session) {
  Errors errors;
  LUM_TRY(errors.start, views_->error_of(start_, static_cast<int>(session)));
  LUM_TRY(errors.found, views_->error_of(solve_->best(), static_cast<int>(session)));
  return errors;
}

}  // namespace luminist
