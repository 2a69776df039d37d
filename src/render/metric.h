#pragma once
// render/metric.h -- the reference of the error that the solver minimizes; engines must agree with it.
#include "base/image.h"
#include "render/target.h"
#include "style/style.h"

namespace luminist {

/// epsilon = sum_i I_i |T_i - R_i|_2 / sum_i I_i over pixels, after the style's blur of T and R (paper, section 5).
/// Sums in double in row order. returns 0 where the importance sums to 0.
double picture_error(const Image& picture, const Target& target, const StyleMetric& metric);

/// The picture as the metric compares it: blurred, if it blurs.
Image as_compared(const Image& picture, const StyleMetric& metric);
/// A target as the metric compares it: what is wanted and what was there before are blurred, if it blurs.
Target as_compared(const Target& target, const StyleMetric& metric);

/// I_i |T_i - R_i|_2, 1 channel: where the error is.
Image residual_map(const Image& picture, const Target& target);

}  // namespace luminist
