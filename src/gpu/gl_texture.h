#pragma once
// gpu/gl_texture.h -- pixels in the memory of the graphics device.
#include <string>

#include "base/image.h"
#include "base/result.h"
#include "gpu/device.h"
#include "gpu/gl_name.h"

namespace luminist {

class GlTexture {
 public:
  GlTexture() = default;

  /// Immutable storage, one level, nearest, clamped to the edge. format is a sized internal format (GL_RGBA32F).
  /// errors kLimit above the device's texture size or layers, or if memory runs out.
  static Result<GlTexture> create_2d(Device& device, GLenum format, int width, int height, const std::string& label);
  static Result<GlTexture> create_2d_array(Device& device, GLenum format, int width, int height, int layers,
                                           const std::string& label);

  /// A picture on a surface: RGBA half float, all mipmap levels, trilinear, anisotropic up to 8. Row 0 of the image is
  /// at v = 0. 1, 2 or 3 channels are filled up (grey is spread; alpha 1). An image larger than the device's textures
  /// is made smaller. errors kLimit.
  static Result<GlTexture> create_picture(Device& device, const Image& image, bool repeat_u, bool repeat_v,
                                          const std::string& label);

  /// One channel of a picture of numbers, 16 bits a texel. levels > 0: the image is a strip whose upper `width` x
  /// `width` texels are level 0, those below them, half as wide, level 1, and so on; repeating, trilinear. levels = 0:
  /// one level, bilinear, clamped. errors kLimit; kBadContent for a strip that is too short.
  static Result<GlTexture> create_numbers(Device& device, const Image& image, int levels, const std::string& label);

  [[nodiscard]] GLuint name() const { return name_.get(); }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int layers() const { return layers_; }  ///< 0: not an array

  void bind(GLuint unit) const { glBindTextureUnit(unit, name()); }
  void set(GLenum parameter, GLint value) { glTextureParameteri(name(), parameter, value); }

 private:
  static Result<GlTexture> create(Device& device, GLenum target, GLenum format, int levels, int width, int height,
                                  int layers, const std::string& label);

  static void remove(GLuint name) { glDeleteTextures(1, &name); }
  GlName<remove> name_;
  int width_ = 0;
  int height_ = 0;
  int layers_ = 0;
};

}  // namespace luminist
