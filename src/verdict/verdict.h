#pragma once
// verdict/verdict.h -- what became of each stroke of a solve, why, and what would help.
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/param_state.h"
#include "solve/start_light.h"

namespace luminist {

enum class StrokeOutcome {
  kMet,          ///< the picture shows it, as near as light comes to paint
  kMissed,       ///< it can be had with the present locks and everything else; the search ended elsewhere
  kConflicting,  ///< it can be had alone, not together with the rest of what is wished
  kImpossible,   ///< nothing that the present locks leave free makes it
};

enum class Cause {
  kNone,
  kSearchEnded,      ///< a better optimum is known
  kNothingThere,     ///< the paint lies on the background
  kFacesAway,        ///< the surface faces away from every light that may change
  kTooDark,          ///< darker than the ambient and what is locked of the lights allow
  kLockedParameter,  ///< a locked parameter keeps it from being met
  kStrokesDisagree,  ///< two strokes ask the same lights for different things
  kRestDisagrees,    ///< what is not painted wants the lights as they are
  kNeedsLight,       ///< the lights at hand cannot, another light could
  kBeyondLight,      ///< no light that was tried makes this
};

/// What an artist can do about it; Session::apply_remedy() does it.
struct Remedy {
  enum class Kind { kNone, kUnlock, kAddLight, kImportance, kRestart };
  Kind kind = Kind::kNone;
  std::string text;                   ///< "unlock lights/key/position"
  std::vector<std::string> patterns;  ///< kUnlock: of set_locked()
  std::optional<StartLight> light;    ///< kAddLight
  std::uint32_t stroke = 0;           ///< kImportance: whose pixels; 0: those without paint
  float importance = 1.0F;            ///< kImportance: what they count from now on
  std::optional<ParamState> state;    ///< kRestart: the better lights, from where a solve goes on
};

struct StrokeVerdict {
  std::uint32_t stroke = 0;  ///< id in Target::stroke: 1 + index of the stroke since the last accepted solve
  std::string label;         ///< "stroke 2 on jug"
  StrokeOutcome outcome = StrokeOutcome::kMet;
  Cause cause = Cause::kNone;
  std::string text;  ///< why, as a clause: "the surface faces away from key"
  Remedy remedy;
  std::uint32_t other = 0;  ///< kStrokesDisagree: the other stroke

  // Means over the stroke's pixels in linear RGB.
  double wished = 0.0;                 ///< |T - before|
  double missed = 0.0;                 ///< |T - R|
  std::optional<double> least_missed;  ///< certified: no setting of what is free misses less
  std::optional<double> near_missed;   ///< estimate: a search for this stroke alone came so near
};

struct Verdict {
  std::vector<StrokeVerdict> strokes;       ///< by id
  double epsilon = 0.0;                     ///< of the picture that was judged, without penalty
  std::optional<double> least_epsilon;      ///< certified lower bound on epsilon under the present locks
  std::optional<double> estimated_epsilon;  ///< estimate: with as many more lights as wanted, fitted from a bank
  double seconds = 0.0;
};

/// "met", "missed", "conflicting", "impossible".
const char* to_string(StrokeOutcome outcome);
/// "surface faces away", "needs another light" ...; "" for kNone.
const char* to_string(Cause cause);

/// One line: "stroke 2 on jug: impossible, the surface faces away from key; unlock lights/key/position".
std::string verdict_line(const StrokeVerdict& stroke);

/// {"epsilon", "least_epsilon" (certified), "estimated_epsilon", "strokes": [{"stroke", "label", "outcome", "cause",
/// "text", "remedy": {"kind", "text", ...}, "wished", "missed", "least_missed" (certified), "near_missed"}]}
nlohmann::json verdict_to_json(const Verdict& verdict);

}  // namespace luminist
