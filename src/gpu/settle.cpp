#include "gpu/settle.h"

#include <array>

namespace luminist {

void settle(const Device& device) {
  if (!device.info().software) return;
  glFinish();
  GLuint pixel = 0;
  GLuint framebuffer = 0;
  glCreateRenderbuffers(1, &pixel);
  glNamedRenderbufferStorage(pixel, GL_RGBA8, 1, 1);
  glCreateFramebuffers(1, &framebuffer);
  glNamedFramebufferRenderbuffer(framebuffer, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixel);
  const std::array<float, 4> black{};
  glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, black.data());
  glFinish();
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteRenderbuffers(1, &pixel);
}

}  // namespace luminist
