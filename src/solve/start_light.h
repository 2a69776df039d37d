#pragma once
// solve/start_light.h -- where a new light starts (paper, section 5.2).
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "render/surface_buffer.h"
#include "render/target.h"
#include "rig/light_rig.h"

namespace luminist {

struct StartLight {
  Vec3 hot_spot{0.0F};           ///< average position of the lightened pixels
  Vec3 direction{0.0F};          ///< unit, the way the light shines
  Vec3 position{0.0F};           ///< one model diameter from the hot spot towards where the light comes from
  Vec3 intensity{0.0F};          ///< per channel, irradiance at the hot spot, >= 0
  float half_angle = 0.0F;       ///< radians, least that covers the box of the painted points
  bool ill_conditioned = false;  ///< average colour and normal were used instead of least squares
  SceneFrame frame;              ///< what the estimate was measured against
};

/// Solves c_i - b_i = k_i L (n_i . d) per channel over the lightened pixels, d towards the light; the model diameter is
/// twice the frame's radius, which backdrops do not stretch. A pixel is lightened if paint adds to it, by more than 1 %
/// of what it adds to the most lightened one; where stroke ids are known, only painted pixels are.
/// Average painted colour and average normal take over where the equations are ill-conditioned (by the condition number
/// of their matrix) or where the light they give would come from behind the surfaces.
/// errors kNothingToDo if no pixel was lightened. cost O(pixels).
Result<StartLight> estimate_start_light(const SurfaceBuffer& surface, const Target& target, const SceneFrame& frame);

/// The same over the pixels that `mask` [pixels] is not 0 for; an empty mask is all of them.
Result<StartLight> estimate_start_light(const SurfaceBuffer& surface, const Target& target, const SceneFrame& frame,
                                        std::span<const unsigned char> mask);

/// Several new lights from one painting: the lightened pixels fall into `count` groups by place, by the colour and by
/// the strength of what paint adds to their albedo (k-means, no chance in it), and each group starts a light. The
/// strongest comes first; fewer come back if there are fewer kinds of pixels. errors as above; kUsage for count < 1.
Result<std::vector<StartLight>> estimate_start_lights(int count, const SurfaceBuffer& surface, const Target& target,
                                                      const SceneFrame& frame);

/// Writes the estimate into a light through the roles of its parameters: position, direction, color, shape (first two
/// numbers: half width and height, tangents), falloff_distance (where the colour is what it says). Stays in the ranges
/// of position, color and shape; a position moved for that looks at the hot spot again.
void apply_start_light(const StartLight& start, Light& light);

/// The same for lights of a rig, by name: each begins where its share of the paint says. errors as above; kNothingToDo
/// if the paint is of fewer kinds.
Result<void> place_lights(std::span<const std::string> names, const SurfaceBuffer& surface, const Target& target,
                          const SceneFrame& frame, LightRig& rig);

/// [pixels] how much paint adds: the sum of T - b over the channels where the pixel was lightened as said above, else
/// 0.
std::vector<float> lightening(const SurfaceBuffer& surface, const Target& target);

}  // namespace luminist
