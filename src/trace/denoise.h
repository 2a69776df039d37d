#pragma once
// trace/denoise.h -- smoothing of few samples for a preview. No part of any error.
#include "base/image.h"
#include "render/surface_buffer.h"

namespace luminist {

/// Specks of a single pixel taken out, then the picture over what the surface reflects, averaged over
/// neighbours with holes of growing size where object, normal, position and brightness agree, times that again.
/// Pixels without a surface stay. source: edge-avoiding a-trous wavelets, Dammertz et al. 2010. cost O(pixels).
Image denoised(const Image& picture, const SurfaceBuffer& surface);

}  // namespace luminist
