#pragma once
// tests/verdict/known_case.h -- paintings of which it is known what becomes of them.
#include <optional>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "solve/random.h"
#include "verdict/verdict.h"

namespace luminist {

inline int param(const Light& light, const char* name) {
  return *light.params.schema().find(name);
}

inline constexpr int kPatientSteps = 400;  ///< of a solve that gets there

/// A renderer and what cases are built from in its scene.
struct CaseScene {
  std::string name;
  Renderer* renderer = nullptr;
  ParamState empty;                    ///< no lights
  Light prototype;                     ///< a cinematic light
  Vec3 middle{0.0F};                   ///< where the objects are
  float reach = 1.0F;                  ///< how far from there lights stand
  std::vector<std::uint32_t> objects;  ///< ids of surfaces that are painted on
};

/// A painting, the lights that a solve starts from, and the truth.
struct KnownCase {
  std::string name;
  ParamState start;
  Target target;
  Cause cause = Cause::kNone;  ///< of the first stroke that is not met; kNone: all are met
  bool reachable = false;      ///< each stroke by itself
  int steps = 150;             ///< of the solve
};

/// Nothing where chance made a case that means nothing, such as paint of too few pixels.
std::optional<KnownCase> make_case(const CaseScene& scene, Cause cause, Random& random);

}  // namespace luminist
