#pragma once
// gpu/settle.h -- memory that software GL would hold back.
#include "gpu/device.h"

namespace luminist {

/// To be called after drawing on a framebuffer, before another one is drawn on.
///
/// Software GL (llvmpipe) keeps the triangles that it has sorted into tiles, and all textures that they were drawn with
/// and on, deleted ones too, until their slot is drawn from again; and it takes another slot for each framebuffer that
/// is drawn on while others are under way. This waits for the drawing and puts one pixel in its place, so that nothing
/// is kept. Where hardware draws it does nothing. cost waiting for what was drawn.
void settle(const Device& device);

}  // namespace luminist
