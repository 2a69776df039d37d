#pragma once
// gpu/gl_vertex_array.h -- how vertices lie in buffers.
#include <cstddef>
#include <string>

#include "gpu/device.h"
#include "gpu/gl_buffer.h"
#include "gpu/gl_name.h"

namespace luminist {

class GlVertexArray {
 public:
  GlVertexArray() = default;
  static GlVertexArray create(Device& device, const std::string& label);

  /// Vertices of `stride` bytes at binding point `binding`; the buffer outlives the array's use.
  void set_vertices(GLuint binding, const GlBuffer& buffer, std::size_t stride);
  /// Shader input `location`: `components` floats at `offset` of each vertex of `binding`.
  void set_attribute(GLuint location, GLuint binding, int components, std::size_t offset);
  void set_indices(const GlBuffer& buffer);

  [[nodiscard]] GLuint name() const { return name_.get(); }
  void bind() const { glBindVertexArray(name()); }

 private:
  static void remove(GLuint name) { glDeleteVertexArrays(1, &name); }
  GlName<remove> name_;
};

}  // namespace luminist
