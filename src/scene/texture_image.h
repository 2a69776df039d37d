#pragma once
// scene/texture_image.h -- pictures into the shape a Texture wants.
#include "base/image.h"

namespace luminist {

/// 3 or 4 channels: grey is spread over r, g and b, alpha stays, channels beyond the fourth are dropped.
Image as_color(Image image);

}  // namespace luminist
