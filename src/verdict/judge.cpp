#include "verdict/judge.h"

#include <chrono>

#include "render/metric.h"
#include "verdict/stroke_case.h"
#include "verdict/watched_renderer.h"

namespace luminist {
namespace {

constexpr double kBetter = 0.97;  // of epsilon: better lights

Result<std::optional<Rival>> find_rival(Evidence& evidence, std::vector<ParamState> starts, double epsilon) {
  if (starts.empty()) return std::optional<Rival>();
  LUM_TRY(Reached reached, evidence.rival(std::move(starts)));
  if (reached.error > kBetter * evidence.total_now()) return std::optional<Rival>();
  LUM_TRY(const double better, evidence.epsilon(reached.state));
  if (better > kBetter * epsilon) return std::optional<Rival>();
  return std::optional(Rival{std::move(reached.state), better});
}

}  // namespace

Result<Verdict> judge(Renderer& engine, const ParamState& state, const Target& target, const Image& picture,
                      const JudgeOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  Verdict verdict;
  WatchedRenderer renderer(engine, options.go_on);
  const StyleMetric& metric = renderer.style().metric;
  const Target wanted = as_compared(target, metric);
  const Image shown = as_compared(picture, metric);
  verdict.epsilon = picture_error(picture, target, metric);
  LUM_TRY(Evidence evidence, Evidence::create(renderer, state, wanted, shown, options.new_light));
  std::vector<StrokeCase> cases;
  std::vector<ParamState> starts;
  std::vector<int> unmet;
  std::vector<std::size_t> open;
  for (int r = 0; r < static_cast<int>(evidence.regions().size()); ++r) {
    if (evidence.regions()[static_cast<std::size_t>(r)].stroke == 0) continue;
    cases.emplace_back(evidence, renderer.frame(), wanted, verdict.epsilon, r);
    if (!cases.back().open()) continue;
    LUM_TRY_VOID(cases.back().try_alone());
    if (const ParamState* alone = cases.back().alone()) starts.push_back(*alone);
    open.push_back(cases.size() - 1);
    unmet.push_back(r);
  }
  LUM_TRY(const std::optional<Rival> rival, find_rival(evidence, std::move(starts), verdict.epsilon));
  for (const std::size_t k : open) LUM_TRY_VOID(cases[k].decide(rival));
  for (StrokeCase& each : cases) verdict.strokes.push_back(each.take());
  if (!unmet.empty()) {
    LUM_TRY(const AttainableColors* attainable, evidence.attainable());
    if (attainable != nullptr) verdict.least_epsilon = attainable->least_error(wanted, {});
    LUM_TRY(verdict.estimated_epsilon, evidence.estimated_epsilon(verdict.epsilon, unmet));
  }
  verdict.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return verdict;
}

}  // namespace luminist
