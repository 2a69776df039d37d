// The part of a session that judges a solve and does what the verdict advises.
#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "studio/paint_layers.h"
#include "verdict/judge.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

Error nothing_judged() {
  return {ErrorKind::kNothingToDo, "there is no solve to judge", "", "", "solve first"};
}

}  // namespace

Result<const Verdict*> Session::judge(const std::function<bool()>& go_on) {
  if (!has_proposal() || solved() == nullptr) return nothing_judged();
  if (!solved_->verdict) {
    LUM_TRY(const Image* picture, this->picture());
    const NewLight usual;
    LUM_TRY(const Light added, make_light(stage_->types, usual.type, usual.name, stage_->frame));
    Target target = solved_->target;
    sanitize(target);
    LUM_TRY(solved_->verdict, luminist::judge(*stage_->renderer, shown(), target, *picture, {&added, go_on}));
  }
  return &*solved_->verdict;
}

Result<void> Session::apply_remedy(std::uint32_t stroke) {
  if (!has_proposal() || !solved_->verdict) return nothing_judged();
  const std::vector<StrokeVerdict>& strokes = solved_->verdict->strokes;
  const auto found =
      std::find_if(strokes.begin(), strokes.end(), [&](const StrokeVerdict& each) { return each.stroke == stroke; });
  if (found == strokes.end() || found->remedy.kind == Remedy::Kind::kNone) {
    return Error{ErrorKind::kNothingToDo, fmt::format("nothing is advised for stroke {}", stroke), "", "stroke", ""};
  }
  const Remedy remedy = found->remedy;
  const std::string label = fmt::format("For stroke {}: {}", stroke, remedy.text);
  const std::string action = Json{{"do", "remedy"}, {"stroke", stroke}, {"text", remedy.text}}.dump();
  ParamState next = state_;
  if (remedy.kind == Remedy::Kind::kImportance) {
    LUM_TRY(const Canvas* canvas, this->canvas());
    LayerStack layers = canvas->state().layers;
    layers.counts[remedy.stroke] = remedy.importance;
    return this->layers().commit(label, action, std::move(layers));
  }
  for (const std::string& pattern : remedy.patterns) LUM_TRY_VOID(luminist::set_locked(next, pattern, false));
  if (remedy.light) {
    const NewLight usual;
    const std::string name = next.rig.unused_name(usual.name);
    LUM_TRY(Light light, make_light(stage_->types, usual.type, name, stage_->frame));
    apply_start_light(*remedy.light, light);
    next.rig.lights.push_back(std::move(light));
  }
  if (remedy.state) next = *remedy.state;
  return commit_state(label, action, std::move(next));
}

}  // namespace luminist
