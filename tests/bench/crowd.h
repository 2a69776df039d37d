#pragma once
// tests/bench/crowd.h -- rigs of any number of lights, and scenes of any number of triangles.
#include "render/param_state.h"
#include "scene/scene.h"

namespace luminist {

/// A rig of `count` lights: those of the state's in their order, again and again, each round turned about the vertical
/// through the scene's centre, and together about as bright as the first round is. count >= 1; the rig has lights.
ParamState crowded(const ParamState& state, const SceneFrame& frame, int count);

/// Every mesh after `levels` steps of Loop's scheme, or with a quarter of its triangles for each step below 0; one that
/// cannot be subdivided stays. Textures go, because texture
/// coordinates do. errors kLimit.
Result<Scene> refined(Scene scene, int levels);

}  // namespace luminist
