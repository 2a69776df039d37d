#include "studio/light_kinds.h"

#include <algorithm>
#include <chrono>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "params/param_text.h"

namespace luminist {
namespace {

constexpr std::string_view kAny = "any";

/// A solve from a light of one kind, that begins where the paint says; no other light is turned if it is so wanted.
Result<LightKind> try_kind(Session& session, const NewLight& wanted, const StartLight& start,
                           const SolveOptions& options, const Session::SolveWatch& watch, bool& go_on) {
  const Stage& stage = session.stage();
  ParamState state = session.state();
  for (Light& light : state.rig.lights) {
    if (wanted.lock_others) light.params.set_param_locked(-1, true);
  }
  const std::string name = state.rig.unused_name(wanted.name);
  LUM_TRY(Light light, make_light(stage.types, wanted.type, name, stage.frame));
  apply_start_light(start, light);
  LightKind kind{wanted.type, 0, 0.0};
  for (int dof = 0; dof < light.params.schema().dofs(); ++dof) kind.dofs += light.params.locked(dof) ? 0 : 1;
  state.rig.lights.push_back(std::move(light));
  LUM_TRY(const Target* target, session.target());
  LUM_TRY(SolveSession solve, SolveSession::create(*stage.renderer, std::move(state), *target, options, stage.edges));
  for (bool more = true; more && go_on;) {
    LUM_TRY(more, solve.run_for(std::chrono::milliseconds(50)));
    go_on = !watch || watch(solve.report());
  }
  if (!go_on) solve.stop();
  kind.epsilon = solve.report().error();
  return kind;
}

/// The first, with the fewest degrees of freedom, that lacks little of what the best gains.
std::size_t choose(const LightKinds& kinds) {
  double best = kinds.epsilon_without;
  for (const LightKind& kind : kinds.tried) best = std::min(best, kind.epsilon);
  const double enough = best + kKindSlack * (kinds.epsilon_without - best);
  const auto first = std::find_if(kinds.tried.begin(), kinds.tried.end(),
                                  [&](const LightKind& kind) { return kind.epsilon <= enough; });
  return first != kinds.tried.end() ? static_cast<std::size_t>(first - kinds.tried.begin()) : 0;
}

}  // namespace

bool is_any_kind(const std::string& type) {
  return type == kAny || type.starts_with("any:");
}

Result<std::vector<std::string>> kinds_named(const std::string& type, const LightTypes& types) {
  if (type == kAny) return types.names();
  std::vector<std::string> named;
  std::istringstream words(type.substr(std::min(type.size(), kAny.size() + 1)));
  for (std::string word; std::getline(words, word, ',');) {
    if (types.find(word) == nullptr) {
      const std::string near = nearest_name(word, types.names());
      return Error{ErrorKind::kUsage, fmt::format("there is no light type \"{}\"", word), "", "type",
                   near.empty() ? fmt::format("there are: {}", fmt::join(types.names(), ", "))
                                : fmt::format("did you mean \"{}\"?", near)};
    }
    if (std::find(named.begin(), named.end(), word) == named.end()) named.push_back(word);
  }
  if (!named.empty()) return named;
  return Error{ErrorKind::kUsage, "no light type is named", "", "type", "write it as any:point,sun"};
}

Result<LightKinds> add_light_of_any_kind(Session& session, const NewLight& wanted, const SolveOptions& options,
                                         const Session::SolveWatch& watch) {
  if (!session.painted()) {
    return Error{ErrorKind::kNothingToDo, "nothing is painted that could choose a kind of light", "", "type",
                 "paint the light that you want to see, or name a type"};
  }
  const Stage& stage = session.stage();
  LUM_TRY(const std::vector<std::string> types, kinds_named(wanted.type, stage.types));
  LUM_TRY(const Target* target, session.target());
  Target lacking = *target;
  LUM_TRY(lacking.before, stage.renderer->render(session.state()));
  auto start = estimate_start_light(stage.renderer->surface(), lacking, stage.frame);
  if (!start) start = estimate_start_light(stage.renderer->surface(), *target, stage.frame);
  if (!start) return std::move(start).error();
  LightKinds kinds;
  LUM_TRY(kinds.epsilon_without, stage.renderer->error(session.state(), *target));
  bool go_on = true;
  for (const std::string& type : types) {
    if (!go_on && !kinds.tried.empty()) break;
    NewLight one = wanted;
    one.type = type;
    LUM_TRY(LightKind kind, try_kind(session, one, *start, options, watch, go_on));
    kinds.tried.push_back(std::move(kind));
  }
  std::stable_sort(kinds.tried.begin(), kinds.tried.end(), [](const LightKind& a, const LightKind& b) {
    return std::pair(a.dofs, a.epsilon) < std::pair(b.dofs, b.epsilon);
  });
  kinds.chosen = choose(kinds);
  NewLight chosen = wanted;
  chosen.type = kinds.tried[kinds.chosen].type;
  LUM_TRY(kinds.name, session.add_light(chosen));
  return kinds;
}

}  // namespace luminist
