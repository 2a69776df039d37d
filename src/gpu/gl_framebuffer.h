#pragma once
// gpu/gl_framebuffer.h -- where triangles are drawn to.
#include <string>

#include "base/result.h"
#include "gpu/device.h"
#include "gpu/gl_name.h"
#include "gpu/gl_texture.h"

namespace luminist {

class GlFramebuffer {
 public:
  GlFramebuffer() = default;
  static GlFramebuffer create(Device& device, const std::string& label);

  /// Textures outlive the framebuffer's use. A layer of an array, or all of a plain texture with layer -1.
  void attach_color(int index, const GlTexture& texture, int layer = -1);
  void attach_depth(const GlTexture& texture, int layer = -1);
  /// Colour outputs 0 .. count-1 are written. errors kGl if the device cannot draw into these attachments.
  Result<void> finish(int color_count);

  [[nodiscard]] GLuint name() const { return name_.get(); }
  /// Draws go here from now on; the viewport covers width x height pixels.
  void bind(int width, int height) const;

 private:
  void attach(GLenum point, const GlTexture& texture, int layer);

  static void remove(GLuint name) { glDeleteFramebuffers(1, &name); }
  GlName<remove> name_;
};

}  // namespace luminist
