#pragma once
// paint/copy_source.h -- the picture that was modified in an external program, ready to copy from (section 4.2).
#include <functional>
#include <string>

#include "base/image.h"
#include "base/result.h"

namespace luminist {

/// Reads an image file as linear floats with 1 to 4 channels; read_image() unless a test or a cache stands in.
using ImageReader = std::function<Result<Image>(const std::string& path)>;

/// The image at reference, looked for below folder, at width x height.
/// errors kMissing, kBadContent: outside the folder, another aspect (by more than a pixel after scaling), not finite.
Result<Image> load_copy_source(const std::string& reference, const std::string& folder, int width, int height,
                               const ImageReader& read);

/// Colour premultiplied by alpha, and alpha (image files keep colour that way). 1 channel: grey; 2: grey and alpha.
Vec4 source_pixel(const Image& image, std::size_t pixel);

}  // namespace luminist
