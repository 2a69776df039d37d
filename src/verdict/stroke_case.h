#pragma once
// verdict/stroke_case.h -- one stroke before the judge: which experiments are made, and what follows from them.
#include <optional>
#include <string>
#include <vector>

#include "verdict/evidence.h"
#include "verdict/verdict.h"

namespace luminist {

/// Better lights for everything that is wished, by a full picture.
struct Rival {
  ParamState state;
  double epsilon = 0.0;
};

/// open(), then for an open one try_alone() and decide(). The evidence and the target must outlive it.
class StrokeCase {
 public:
  StrokeCase(Evidence& evidence, const SceneFrame& frame, const Target& target, double epsilon, int region);

  /// Whether the stroke needs more than a look at the picture.
  bool open();
  /// What is free, for this stroke alone. errors the renderer's, here and below.
  Result<void> try_alone();
  /// The lights that come near this stroke; null if what is free does not.
  [[nodiscard]] const ParamState* alone() const;
  /// rival: lights that are better for everything, if such are known.
  Result<void> decide(const std::optional<Rival>& rival);

  /// What was decided. Of a stroke that is not met its text says what chance hides, where samples are estimates.
  [[nodiscard]] StrokeVerdict take();

 private:
  Result<Reached> reach_alone();
  Result<void> weigh(const ParamState& alone);
  Result<int> opponent(const ParamState& alone);
  Result<void> explain();
  Result<void> explain_dark();
  Result<void> nothing_helps();
  Result<std::optional<Unlocking>> best_unlocking(LockedKind kind);
  Result<std::vector<std::string>> colors_to_unlock();
  [[nodiscard]] std::vector<std::string> lights_behind() const;

  void rule(StrokeOutcome outcome, Cause cause, std::string text);
  void miss(const Rival& rival);
  void blame(int partner, const std::string& param, bool light_helps);
  void unlock(std::vector<std::string> patterns);
  void add_light(const StartLight& light);
  void let_count(int partner);

  Evidence* evidence_;
  SceneFrame frame_;
  const Target* target_;
  double epsilon_;  ///< of the picture that is judged
  int region_;
  StrokeVerdict verdict_;
  std::optional<Reached> alone_;
};

}  // namespace luminist
