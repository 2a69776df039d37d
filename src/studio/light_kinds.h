#pragma once
// studio/light_kinds.h -- which kind of light a painting wants: each is tried, the fewest degrees of freedom win.
#include <string>
#include <vector>

#include "studio/session.h"

namespace luminist {

/// "any", or "any:point,sun": what NewLight::type says where the kind is to be found.
bool is_any_kind(const std::string& type);
/// The types that it names; all that there are for "any". errors kUsage for a type that is not there (nearest name).
Result<std::vector<std::string>> kinds_named(const std::string& type, const LightTypes& types);

/// What a kind of light came to on its own.
struct LightKind {
  std::string type;
  int dofs = 0;          ///< of the new light that a solve may turn
  double epsilon = 0.0;  ///< without penalty
};
struct LightKinds {
  double epsilon_without = 0.0;  ///< with no light added
  std::vector<LightKind> tried;  ///< fewest degrees of freedom first
  std::size_t chosen = 0;        ///< of tried
  std::string name;              ///< of the light that was added
};

/// The share of what the best kind gains that a kind with fewer degrees of freedom may lack and still be chosen.
inline constexpr double kKindSlack = 0.05;

/// Solves for the paint with one more light of each kind, begun where the paint says, and adds a light of the kind with
/// the fewest degrees of freedom among those that are nearly as good as the best. One gesture, as Session::add_light();
/// the light begins where the paint says, as any. wanted.type: see is_any_kind().
/// watch: false ends the present solve, and the kinds that are left are not tried. errors kNothingToDo without paint;
/// Session::add_light()'s; the solves'. cost a solve a kind.
Result<LightKinds> add_light_of_any_kind(Session& session, const NewLight& wanted, const SolveOptions& options,
                                         const Session::SolveWatch& watch);

}  // namespace luminist
