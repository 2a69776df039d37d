#pragma once
// trace/rig_light.h -- the lights of a rig for the path tracer: the formulas of shaders/light/*.glsl and
// shaders/lib/helpers.glsl in C++ (a test holds both together).
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/math.h"
#include "base/result.h"
#include "render/renderer.h"
#include "rig/light_rig.h"

namespace luminist {

/// A light, read out of its parameters. Everything is for a light of colour 1; `color` scales all it does.
struct RigLight {
  enum class Kind { kCinematic, kPoint, kArea, kSun };
  Kind kind = Kind::kPoint;
  Vec3 color{1.0F};  ///< times the intensity, where the type has one

  Vec3 position{0.0F};
  Vec3 axis{0.0F, 0.0F, -1.0F};  ///< unit, the way it shines
  Vec3 right{1.0F, 0.0F, 0.0F};
  Vec3 up{0.0F, 1.0F, 0.0F};
  Vec2 near_cutoff{0.0F};
  Vec2 far_cutoff{0.0F};
  float falloff_exponent = 0.0F;
  float falloff_distance = 1.0F;
  Vec3 barn{0.0F};
  float edge_softness = 0.0F;  ///< least barn edge

  bool shadows = true;
  float shadow_density = 1.0F;
  float shadow_softness = 0.0F;  ///< radius of the lamp over the distance to what it shines on
  Vec3 shadow_position{0.0F};    ///< from where shadows are cast: another light's place if the rig shares shadows

  std::vector<char> unlit;  ///< [objects] 1: it is not linked to the light; empty: it lights everything
  [[nodiscard]] bool lights(std::uint32_t object) const { return object >= unlit.size() || unlit[object] == 0; }

  float half_side = 0.0F;  ///< of a square panel; its emitting plane lies a hair before `position`

  /// A panel's radiance, and a point of its square. place in [0,1)^2.
  [[nodiscard]] float panel_radiance() const;
  [[nodiscard]] Vec3 panel_point(const Vec2& place) const;
  [[nodiscard]] float panel_area() const { return 4.0F * half_side * half_side; }
  /// Distance along a ray (unit direction) at which it meets the panel's shining side; infinity if it does not.
  [[nodiscard]] float meet_panel(const Vec3& origin, const Vec3& direction) const;
};

/// frame: of the scene. softness widens shadows and barn edges for the solver's coarse levels.
/// objects: their names, for links. errors kStyle for a light type whose formula the path tracer does not have, naming
/// it.
Result<RigLight> rig_light(const LightRig& rig, int light, const Softness& softness, const SceneFrame& frame,
                           std::span<const std::string> objects = {});

/// The frame of the barn of a light that shines along axis (unit), as shaders/lib/helpers.glsl has it.
void light_frame(const Vec3& axis, Vec3& right, Vec3& up);

/// Radiance of a white diffuser at a place that faces the light, without shadows, of a light of colour 1 that shines
/// from a point (every kind but kArea).
float point_strength(const RigLight& light, const Vec3& position);

/// All that a light's picture depends on but its colour, as bytes. Equal bytes, equal pictures of one style.
std::string picture_key(const RigLight& light);

}  // namespace luminist
