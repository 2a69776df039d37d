#pragma once
// explore/light_walk.h -- from one light to another, one aspect at a time.
#include <vector>

#include "rig/light_rig.h"

namespace luminist {

enum class LightAspect { kPlace, kBeam, kColor };

/// One aspect taken over from the other light.
struct WalkStep {
  LightAspect aspect = LightAspect::kPlace;
  double difference = 0.0;  ///< [0,1] in light space
  Light light;              ///< after the step
};

/// Steps that turn a light into another of the same type; the last step's light has the other's values. Aspects that
/// agree are left out. Found by the roles of the parameters:
///
/// place   the chord between the ways in which the lights stand, seen from the focus, together with an eighth of the
///         octaves between their distances; the light goes on shining where it shone, with the same footprint there.
/// beam    all but place and colour at once, because a light that looks past its subject with a wide beam may shine on
///         it like one that looks at it with a narrow one: how far apart the places are that they shine on, in scene
///         radii, together with the largest difference of any other parameter in unit coordinates.
/// color   |a - b| / (|a| + |b|).
///
/// focus: where the picture counts, world. Muted lights and names play no part.
std::vector<WalkStep> light_walk(const Light& from, const Light& to, const SceneFrame& frame, const Vec3& focus);

/// Root of the sum of the squared differences.
double walk_length(const std::vector<WalkStep>& walk);

/// What a light shines on: the point of its axis that is nearest to the focus, in front of it; the focus itself for a
/// light without a direction.
Vec3 aim_point(const Light& light, const SceneFrame& frame, const Vec3& focus);

/// Puts a light elsewhere so that it goes on shining at a place with the footprint that it has there.
void move_light(Light& light, const Vec3& position, const Vec3& aim, const SceneFrame& frame);

}  // namespace luminist
