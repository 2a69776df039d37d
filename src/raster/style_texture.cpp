#include "raster/style_texture.h"

#include "image_io/image_io.h"

namespace luminist {

Result<GlTexture> load_style_texture(Device& device, const StyleTexture& texture) {
  LUM_TRY(const Image image, read_image(texture.path, texture.colors ? Encoding::kAuto : Encoding::kLinear));
  if (!texture.colors && (texture.levels > 0 || image.channels == 1)) {
    return GlTexture::create_numbers(device, image, texture.levels, texture.path);
  }
  LUM_TRY(GlTexture picture, GlTexture::create_picture(device, image, false, false, texture.path));
  picture.set(GL_TEXTURE_MAX_ANISOTROPY, 1);  // a compute shader has no derivatives that could stretch the filter
  return picture;
}

}  // namespace luminist
