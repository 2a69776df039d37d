#include "raster/style_texture.h"

#include "image_io/image_io.h"

namespace luminist {

Result<GlTexture> load_style_texture(Device& device, const StyleTexture& texture) {
  LUM_TRY(const Image image, read_image(texture.path, Encoding::kLinear));
  if (texture.levels > 0 || image.channels == 1) {
    return GlTexture::create_numbers(device, image, texture.levels, texture.path);
  }
  return GlTexture::create_picture(device, image, false, false, texture.path);
}

}  // namespace luminist
