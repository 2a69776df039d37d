#pragma once
// explore/light_place.h -- where a light stands and what it shines on, by the roles of its parameters.
#include <optional>

#include "rig/light_rig.h"

namespace luminist {

/// Where its light comes from, seen from a place.
struct LightPlace {
  Vec3 way{0.0F};        ///< unit, towards the light
  double octaves = 0.0;  ///< binary logarithm of its distance; 0 for a light without a position
};

/// Nothing for a light that has neither position nor direction.
std::optional<LightPlace> light_place(const Light& light, const Vec3& seen_from);

/// [0,1]: half the chord between the ways, together with an eighth of the octaves between the distances, which hardly
/// show where lights have no falloff. Two lights without a place are 0 apart, one with and one without 1.
double place_difference(const std::optional<LightPlace>& a, const std::optional<LightPlace>& b);

/// What a light shines on: the point of its axis that is nearest to the focus, in front of it; the focus itself for a
/// light without position or direction.
Vec3 aim_point(const Light& light, const SceneFrame& frame, const Vec3& focus);

/// Puts a light, which has a position, elsewhere so that it goes on shining at a place with the footprint that it has
/// there. What is locked of its shape stays.
void move_light(Light& light, const Vec3& position, const Vec3& aim, const SceneFrame& frame);

}  // namespace luminist
