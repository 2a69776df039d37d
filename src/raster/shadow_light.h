#pragma once
// raster/shadow_light.h -- what the shadows of a light depend on, and the geometry of their filter. Maps (on the GPU)
// and rays (on the CPU) both follow it, so that they see the same shadows. No GL here.
#include <vector>

#include "base/math.h"
#include "rig/light_rig.h"
#include "rig/light_type.h"

namespace luminist {

/// Equal values, equal shadows. Made by shadow_light(). A sun has no place: its map lies across its rays and covers the
/// scene's sphere, and its lengths are world units where those of the others are tangents of angles.
struct ShadowLight {
  ShadowKind kind = ShadowKind::kNone;  ///< kNone: everything is lit
  Vec3 position{0.0F};                  ///< world; of a kSun the middle of what its map covers
  Vec3 direction{0.0F, 0.0F, -1.0F};    ///< unit; of a kSpot and a kSun
  float extent = 1.0F;                  ///< the map covers tangents of angles up to this, to each side
  float softness = 0.01F;               ///< radius of the filter, tangent of the angle seen from the light
  int size_px = 256;                    ///< texels along a side of the map

  bool operator==(const ShadowLight&) const = default;
  [[nodiscard]] bool parallel() const { return kind == ShadowKind::kSun; }
  /// A texel's width at distance 1 on the map's axis.
  [[nodiscard]] float texel() const { return 2.0F * extent / static_cast<float>(size_px); }
};

/// Reads the roles position, direction, shape and size. A light whose position or direction is not finite is kNone.
/// The extent is rounded up in steps, so that a small change of the shape keeps the map; the size is the power of two
/// at which the filter's radius is two to four texels, within 256 .. 2048 (the filter is widened if 2048 is too few).
/// scene: the sphere around what casts shadows, without backdrops; a sun's filter is as wide as its disc is seen
/// through a pinhole one radius away.
ShadowLight shadow_light(const Light& light, const LightTypes& types, const SceneFrame& scene);

/// One per light of the rig, in its order. Where the rig names a shadow_light, all equal that one's.
std::vector<ShadowLight> shadow_lights(const LightRig& rig, const LightTypes& types, const SceneFrame& scene);

/// The way from a place to the light, unit; zero at the light.
Vec3 way_to_light(const ShadowLight& light, const Vec3& position);
/// Where a ray to a tap starts: the light, or far beyond the scene.
Vec3 ray_origin(const ShadowLight& light, const Vec3& tap);

/// How far a receiver is pushed along its normal before it is compared, world units: about one texel and a half,
/// growing with the slope, so that a surface does not shadow itself. distance from the light; cosine between the normal
/// and the way to the light.
float receiver_offset(const ShadowLight& light, float distance, float cosine);

/// position pushed along normal (unit) by receiver_offset(), and by the slack of the mesh that blocks light in the
/// stead of its object, if one does: that mesh's facets must not show where light grazes the object.
Vec3 shadow_receiver(const ShadowLight& light, const Vec3& position, const Vec3& normal, float slack = 0.0F);

/// A tap of the filter: the point that must be seen from the light. `receiver` from shadow_receiver(), `disc` in the
/// unit disc. The taps lie in a cone of tangent softness around the way from the light, as far as the receiver but
/// nowhere under its tangent plane, and the outer ones a little nearer to the light.
/// visibility = mean over the disc of "nothing between the light and the tap".
Vec3 shadow_tap(const ShadowLight& light, const Vec3& receiver, const Vec3& normal, const Vec2& disc);

/// How much of the light that reaches a receiver is left if a shadow mesh blocks light in the stead of its object: what
/// faces away from a light is in the shadow of its own object, whatever the shadow mesh is like there.
/// cosine between the normal and the way to the light.
float share_before_own_shadow(float cosine);

/// Whether the map sees the receiver at all; what it does not see is lit.
bool shadow_covers(const ShadowLight& light, const Vec3& receiver);

/// Point i of n of a sunflower (Vogel) disc: equal areas, no rows.
Vec2 vogel_disc(int i, int n);

}  // namespace luminist
