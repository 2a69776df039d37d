#pragma once
// gpu/settled_drawing.h -- drawing of which software GL holds nothing back.
#include <cstddef>

#include "gpu/device.h"

namespace luminist {

/// Lives while one framebuffer is drawn on.
///
/// Software GL (llvmpipe) sorts triangles into tiles before it draws them. It keeps them, and all textures that they
/// were drawn with and on, deleted ones too, until their slot is drawn from again; and it takes another slot for each
/// framebuffer that is drawn on while others are under way, and where a slot is full. So this waits until nothing is
/// under way, which makes the first slot free, waits before that is full, and in the end puts one pixel in the
/// drawing's place. Where hardware draws it only draws. cost waiting for what was drawn.
class SettledDrawing {
 public:
  explicit SettledDrawing(const Device& device);
  ~SettledDrawing();
  SettledDrawing(const SettledDrawing&) = delete;
  SettledDrawing& operator=(const SettledDrawing&) = delete;

  /// Draws triangles of the vertex array that is bound, whose indices are 32 bits wide. index_offset in bytes.
  void triangles(GLsizei index_count, std::size_t index_offset, GLint base_vertex);

 private:
  bool software_;
  GLsizei taken_ = 0;  ///< indices that are in the slot
};

}  // namespace luminist
