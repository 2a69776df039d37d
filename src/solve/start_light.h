#pragma once
// solve/start_light.h -- where a new light starts (paper, section 5.2).
#include "base/result.h"
#include "render/surface_buffer.h"
#include "render/target.h"
#include "rig/light_rig.h"

namespace luminist {

struct StartLight {
  Vec3 hot_spot{0.0F};   ///< average position of the lightened pixels
  Vec3 direction{0.0F};  ///< unit, the way the light shines
  Vec3 position{0.0F};   ///< one model diameter from the hot spot towards where the light comes from
  Vec3 intensity{0.0F};  ///< per channel, irradiance at the hot spot, >= 0
  float half_angle = 0.0F;  ///< radians, least that covers the box of the painted points
  bool ill_conditioned = false;  ///< average colour and normal were used instead of least squares
};

/// Solves c_i - b_i = k_i L (n_i . d) per channel over the lightened pixels.
/// errors kNothingToDo if no pixel was lightened.
Result<StartLight> estimate_start_light(const SurfaceBuffer& surface, const Target& target, const SceneFrame& frame);

/// Writes the estimate into a light through the roles of its parameters (position, direction, color, shape, falloff).
void apply_start_light(const StartLight& start, Light& light);

}  // namespace luminist
