#include "cli/solve_shared.h"

#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "params/param_text.h"
#include "studio/results.h"
#include "studio/shared_solve.h"
#include "verdict/judge.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

std::string folder_of(const SolveWords& words, const SharedView& view) {
  return (std::filesystem::path(words.output) / view.name).string();
}

/// The rig as it was found, with keys at the frames that were looked at.
LightRig keyed_rig(const SharedSolve& solve, const std::vector<SharedView>& views) {
  LightRig rig = solve.rig();
  for (const SharedView& view : views) follow_with_keys(rig, view.session->shot().frame);
  return rig;
}

Result<void> write_shared(const SharedSolve& solve, const std::vector<SharedView>& views,
                          const std::vector<std::optional<Verdict>>& verdicts, const SolveWords& words) {
  LUM_TRY_VOID(
      write_file_atomic(std::filesystem::path(words.output) / "rig.toml", rig_to_toml(keyed_rig(solve, views))));
  LUM_TRY_VOID(
      write_file_atomic(std::filesystem::path(words.output) / "convergence.jsonl", convergence_lines(solve.report())));
  for (std::size_t k = 0; k < views.size(); ++k) {
    LUM_TRY(const Target* target, views[k].session->target());
    LUM_TRY(Results results, collect_results(*views[k].session, solve.state(k), *target, std::nullopt));
    results.verdict = verdicts[k];
    LUM_TRY_VOID(write_results(results, folder_of(words, views[k])));
  }
  return {};
}

Result<void> print_shared(SharedSolve& solve, const std::vector<SharedView>& views,
                          const std::vector<std::optional<Verdict>>& verdicts, const std::string& noun,
                          Console& console) {
  Json json = solve_to_json(solve.report(), solve.state(0));
  json.erase("style");
  if (!console.json()) {
    console.result(report_line(solve.report()));
    print_free_values(console, solve.state(0), true);
  }
  for (std::size_t k = 0; k < views.size(); ++k) {
    LUM_TRY(const SharedSolve::Errors errors, solve.errors(k));
    Json& own = json[noun][views[k].name];
    own = {{"epsilon_start", errors.start}, {"epsilon", errors.found}, {"style", block_to_json(solve.state(k).style)}};
    if (verdicts[k]) own["verdict"] = verdict_to_json(*verdicts[k]);
    if (console.json()) continue;
    console.result(fmt::format("{}: error {:.5f}, was {:.5f}", views[k].name, errors.found, errors.start));
    ParamState style_only = solve.state(k);
    style_only.rig.lights.clear();
    style_only.materials.clear();
    style_only.rig.ambient.set_param_locked(-1, true);
    print_free_values(console, style_only, false);
    if (verdicts[k]) console.result(*verdicts[k]);
  }
  if (console.json()) console.result(json.dump());
  return {};
}

/// What became of the strokes of each picture, by itself: a stroke that only the other pictures stand against is
/// missed there.
Result<std::vector<std::optional<Verdict>>> judge_all(const SharedSolve& solve, const std::vector<SharedView>& views,
                                                      const StopSignals& signals) {
  std::vector<std::optional<Verdict>> verdicts(views.size());
  for (std::size_t k = 0; k < views.size() && signals.stopped() == 0; ++k) {
    LUM_TRY(const Target* target, views[k].session->target());
    Renderer& renderer = *views[k].session->stage().renderer;
    const ParamState state = solve.state(k);
    LUM_TRY(const Image picture, renderer.render(state));
    auto verdict = judge(renderer, state, *target, picture, {nullptr, [&] { return signals.stopped() == 0; }});
    if (verdict) verdicts[k] = std::move(verdict).value();
    if (!verdict && verdict.error().kind != ErrorKind::kCancelled) return std::move(verdict).error();
  }
  return verdicts;
}

}  // namespace

Result<int> solve_shared(const std::vector<SharedView>& views, const std::string& noun, const SolveWords& words,
                         VerbContext& context) {
  std::vector<Session*> sessions;
  std::vector<double> weights;
  for (const SharedView& view : views) {
    sessions.push_back(view.session.get());
    weights.push_back(view.weight);
  }
  LUM_TRY(SharedSolve solve, SharedSolve::create(sessions, weights, words.options));
  const StopSignals::Grace grace(context.signals);
  const Deadline deadline(context.signals, words.seconds);
  for (bool more = true; more;) {
    LUM_TRY(more, solve.run_for(std::chrono::milliseconds(50)));
    context.console.progress(solve.report());
    if (more && !deadline.go_on()) {
      solve.stop();
      more = false;
    }
  }
  LUM_TRY(const auto verdicts, judge_all(solve, views, context.signals));
  LUM_TRY_VOID(write_shared(solve, views, verdicts, words));
  LUM_TRY_VOID(print_shared(solve, views, verdicts, noun, context.console));
  if (!context.console.json()) context.console.result(words.output);
  if (context.signals.stopped() != 0) return 128 + context.signals.stopped();
  return words.until && solve.report().error() > *words.until ? 1 : 0;
}

}  // namespace luminist
