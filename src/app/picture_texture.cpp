#include "app/picture_texture.h"

#include <epoxy/gl.h>

#include "base/check.h"

namespace luminist {

PictureTexture::~PictureTexture() {
  if (name_ != 0) glDeleteTextures(1, &name_);
}

void PictureTexture::upload(std::span<const std::uint32_t> pixels, int width, int height) {
  LUM_CHECK(pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height), "one code a pixel");
  if (name_ == 0) glGenTextures(1, &name_);
  glBindTexture(GL_TEXTURE_2D, name_);
  if (width != width_ || height != height_) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    width_ = width;
    height_ = height;
  } else {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  }
  glGenerateMipmap(GL_TEXTURE_2D);
}

void PictureTexture::filter(float zoom) {
  constexpr float kSquares = 2.0F;
  glBindTexture(GL_TEXTURE_2D, name_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, zoom < 0.7F ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, zoom >= kSquares ? GL_NEAREST : GL_LINEAR);
}

}  // namespace luminist
