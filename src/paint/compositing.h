#pragma once
// paint/compositing.h -- what one stroke does to one pixel (paper, section 4.1).
#include "base/math.h"
#include "paint/brush.h"

namespace luminist {

/// What a stroke brings to a pixel.
struct Dose {
  float coverage = 0.0F;  ///< of the stroke, times the gradient where that thins the paint (fades_amount())
  float amount = 0.0F;    ///< a: opacity x coverage
  float shading = 1.0F;   ///< the gradient where it shades the brush's colour instead
  Vec4 source{0.0F, 0.0F, 0.0F, 1.0F};  ///< of tools that copy: colour premultiplied by alpha, and alpha
};

/// A gradient by normals shades the colour of kColor; the screen gradient, and any gradient of a tool that has no
/// colour of its own, thins the paint.
bool fades_amount(const Brush& brush);

/// p_f from p_b and the albedo c_d, per channel. Of kImportance it is p_b.
///   kColor           c_p = (1 - tau) c + tau c c_d;  c_c = (1 - a) p_b + a shading c_p
///   copying tools    c_c = (1 - a alpha) p_b + a source
///   kBrighten        c_c = p_b 2^(strength a), kDarken p_b 2^(-strength a); up to kBrightest
/// and p_f = max(p_b, c_c) with add_light, except for kErase.
Vec3 composited(const Brush& brush, const Vec3& below, const Vec3& albedo, const Dose& dose);

}  // namespace luminist
