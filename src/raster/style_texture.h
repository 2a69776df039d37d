#pragma once
// raster/style_texture.h -- the pictures that a style's GLSL reads.
#include "gpu/device.h"
#include "gpu/gl_texture.h"
#include "style/style.h"

namespace luminist {

/// A strip of levels as numbers (thresholds are no colours); another picture with its channels, linear numbers
/// or colours, clamped. errors those of read_image() and GlTexture.
Result<GlTexture> load_style_texture(Device& device, const StyleTexture& texture);

}  // namespace luminist
