#pragma once
// trace/reflection.h -- how a surface scatters light: Lambert, GGX and mirror, in the raster engine's terms.
#include "base/math.h"
#include "trace/scene_surfaces.h"

namespace luminist {

/// f(to_eye, to_light) = (1 - F) albedo / pi + D V F  with the GGX distribution D, Smith's height-correlated masking V
/// and Schlick's Fresnel term F = factor (F0 + (1 - F0)(1 - h.l)^5); glTF 2.0, appendix B. It is reciprocal and
/// reflects at most what arrives. A surface smoother than kMirror reflects F in one direction instead of D V F.
struct Reflection {
  Vec3 normal{0.0F};           ///< unit
  Vec3 to_eye{0.0F};           ///< unit, dot(normal, to_eye) > 0
  Vec3 albedo{0.0F};           ///< of what is scattered diffusely
  Vec3 specular{0.0F};         ///< F0
  float factor = 1.0F;         ///< of F
  float alpha = 1.0F;          ///< of GGX; 0: a mirror, whose reflection is not part of evaluate()
  float diffuse_share = 1.0F;  ///< the probability with which sample() scatters diffusely

  static constexpr float kMirror = 0.05F;      ///< roughness
  static constexpr float kLeastAlpha = 0.01F;  ///< as in styles/cinematic

  /// factor: the style's, of every highlight; 0 is matte.
  static Reflection create(const SurfacePoint& point, const Vec3& to_eye, float factor);
  [[nodiscard]] bool mirrors() const { return alpha == 0.0F; }
  /// Whether light from a direction that was not sampled is reflected at all.
  [[nodiscard]] bool scatters() const;
};

/// f times the cosine, and the density (per solid angle) with which sample() chooses that direction.
struct Scattered {
  Vec3 value{0.0F};
  float pdf = 0.0F;
};
Scattered evaluate(const Reflection& surface, const Vec3& to_light);

/// A direction to go on in. weight: f cosine / pdf; for a mirror pdf is 0 and weight its reflectance over the
/// probability of having chosen it. weight 0: the path ends.
struct Bounce {
  Vec3 direction{0.0F};
  Vec3 weight{0.0F};
  float pdf = 0.0F;
};
/// lobe in [0,1), place in [0,1)^2. source for visible normals: Heitz 2018.
Bounce sample(const Reflection& surface, float lobe, const Vec2& place);

}  // namespace luminist
