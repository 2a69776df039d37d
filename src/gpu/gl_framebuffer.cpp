#include "gpu/gl_framebuffer.h"

#include <fmt/format.h>

#include <vector>

namespace luminist {

GlFramebuffer GlFramebuffer::create(Device& /*device*/, const std::string& label) {
  GlFramebuffer framebuffer;
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  framebuffer.name_ = GlName<remove>(name);
  glObjectLabel(GL_FRAMEBUFFER, name, -1, label.c_str());
  return framebuffer;
}

void GlFramebuffer::attach(GLenum point, const GlTexture& texture, int layer) {
  if (layer < 0) {
    glNamedFramebufferTexture(name(), point, texture.name(), 0);
  } else {
    glNamedFramebufferTextureLayer(name(), point, texture.name(), 0, layer);
  }
}

void GlFramebuffer::attach_color(int index, const GlTexture& texture, int layer) {
  attach(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(index), texture, layer);
}

void GlFramebuffer::attach_depth(const GlTexture& texture, int layer) {
  attach(GL_DEPTH_ATTACHMENT, texture, layer);
}

Result<void> GlFramebuffer::finish(int color_count) {
  std::vector<GLenum> outputs;
  for (int i = 0; i < color_count; ++i) outputs.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
  if (outputs.empty()) outputs.push_back(GL_NONE);
  glNamedFramebufferDrawBuffers(name(), static_cast<GLsizei>(outputs.size()), outputs.data());
  const GLenum status = glCheckNamedFramebufferStatus(name(), GL_DRAW_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return {};
  return Error{ErrorKind::kGl, fmt::format("this device cannot draw into the textures we need (status {:#x})", status),
               "", "", ""};
}

void GlFramebuffer::bind(int width, int height) const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name());
  glViewport(0, 0, width, height);
}

}  // namespace luminist
