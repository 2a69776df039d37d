#pragma once
// explore/light_removal.h -- a light removed, so that the others make up for it (paper, section 6.1.1).
#include <string>

#include "base/result.h"
#include "explore/locks.h"
#include "render/renderer.h"

namespace luminist {

/// The same lights without one and without the constraints that name it. Lights that shared its shadow map have their
/// own again.
ParamState without_light(const ParamState& state, std::size_t light);

/// A picture to be kept: everything counts alike, nothing is painted.
Target kept_picture(const Image& picture);

/// What the epsilon of a black picture would be: errors are read against it. Follows the importance.
double black_error(const Target& target);

/// What a light did for a picture.
struct RemovalFacts {
  std::string light;
  double black = 0.0;    ///< black_error() of the picture
  double epsilon = 0.0;  ///< without the light, before others make up for it
  /// The share of the light's part that is shadow: how much that part changes when nothing casts shadows. Other lights
  /// make up for a glow, but hardly for a shadow.
  double shadow_share = 0.0;

  [[nodiscard]] bool shadows_matter() const { return shadow_share > 0.1; }
};

/// What is to be solved when a light goes: start is the rig without it, target the picture with it.
struct RemovalTask {
  ParamState start;
  Target target;
  RemovalFacts facts;
};

/// errors kUsage for a name that is not in the rig (with the nearest); kNothingToDo for the only light, and where
/// everything else is locked; the renderer's. cost four pictures.
Result<RemovalTask> removal_task(Renderer& renderer, const ParamState& state, const std::string& light,
                                 MakeUp who = MakeUp::kUnlockedOrByType);

}  // namespace luminist
