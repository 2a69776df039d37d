#include "gpu/settled_drawing.h"

#include <algorithm>
#include <array>

#include "gpu/gl_texture.h"

namespace luminist {
namespace {

constexpr std::size_t kSlotBytes = std::size_t{30} << 20U;  // llvmpipe's end at 36 MB of triangles, 64 of textures
constexpr std::size_t kTriangleBytes = 1024;                // with sixteen varyings and its places in the tiles
constexpr std::size_t kTexelBytes = 16;
constexpr GLsizei kPortion = 3 * 10'000;  // indices

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

void SettledDrawing::take(std::size_t bytes) {
  taken_ += bytes;
  if (!software_ || taken_ <= kSlotBytes) return;
  glFinish();
  taken_ = bytes;
}

void SettledDrawing::triangles(GLsizei index_count, std::size_t index_offset, GLint base_vertex) {
  const GLsizei portion = software_ ? kPortion : std::max(index_count, 1);
  for (GLsizei first = 0; first < index_count; first += portion) {
    const GLsizei count = std::min(portion, index_count - first);
    take(static_cast<std::size_t>(count) / 3 * kTriangleBytes);
    const std::size_t offset = index_offset + static_cast<std::size_t>(first) * sizeof(GLuint);
    glDrawElementsBaseVertex(GL_TRIANGLES, count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset), base_vertex);
  }
}

void SettledDrawing::uses(const GlTexture& texture) {
  take(static_cast<std::size_t>(texture.width()) * static_cast<std::size_t>(texture.height()) * kTexelBytes);
}

}  // namespace luminist
