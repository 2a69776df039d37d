#pragma once
// tests/bench/hidden_light.h -- a light that a solver has to find again, and the painting that asks for it.
#include "render/renderer.h"
#include "solve/random.h"

namespace luminist {

/// A cinematic light with all 18 degrees of freedom unlocked, at its defaults.
Result<Light> free_cinematic(const LightTypes& types, const std::string& name, const SceneFrame& frame);

/// What a hidden light asks for: its picture, what was there before, importance 1 where it adds more than 5 % of its
/// peak and nu elsewhere.
struct HiddenTask {
  Light hidden;
  Target target;
  double lit = 0.0;  ///< share of the picture where importance is 1
};

/// All 18 numbers at random: somewhere on the camera's side of the scene, above it or beside, aimed at something
/// visible. Drawn again until it lights at least a tenth of the picture. errors the renderer's; kLimit if none does.
Result<HiddenTask> hidden_task(Renderer& renderer, const LightTypes& types, const ParamState& before, float nu,
                               std::uint64_t seed);

}  // namespace luminist
