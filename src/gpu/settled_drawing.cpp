#include "gpu/settled_drawing.h"

#include <algorithm>
#include <array>

namespace luminist {
namespace {

/// In Mesa 22 a slot (lp_scene) holds 36 MB of triangles, each of them a kilobyte at most with sixteen varyings.
constexpr GLsizei kSlotIndices = 3 * 30'000;

}  // namespace

SettledDrawing::SettledDrawing(const Device& device) : software_(device.info().software) {
  if (software_) glFinish();
}

SettledDrawing::~SettledDrawing() {
  if (!software_) return;
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

void SettledDrawing::triangles(GLsizei index_count, std::size_t index_offset, GLint base_vertex) {
  const GLsizei portion = software_ ? kSlotIndices : std::max(index_count, 1);
  for (GLsizei first = 0; first < index_count; first += portion) {
    const GLsizei count = std::min(portion, index_count - first);
    if (software_ && taken_ + count > kSlotIndices) {
      glFinish();
      taken_ = 0;
    }
    taken_ += count;
    const std::size_t offset = index_offset + static_cast<std::size_t>(first) * sizeof(GLuint);
    glDrawElementsBaseVertex(GL_TRIANGLES, count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset), base_vertex);
  }
}

}  // namespace luminist
