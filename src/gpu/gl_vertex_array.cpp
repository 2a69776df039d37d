#include "gpu/gl_vertex_array.h"

namespace luminist {

GlVertexArray GlVertexArray::create(Device& /*device*/, const std::string& label) {
  GlVertexArray array;
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  array.name_ = GlName<remove>(name);
  glObjectLabel(GL_VERTEX_ARRAY, name, -1, label.c_str());
  return array;
}

void GlVertexArray::set_vertices(GLuint binding, const GlBuffer& buffer, std::size_t stride) {
  glVertexArrayVertexBuffer(name(), binding, buffer.name(), 0, static_cast<GLsizei>(stride));
}

void GlVertexArray::set_attribute(GLuint location, GLuint binding, int components, std::size_t offset) {
  glEnableVertexArrayAttrib(name(), location);
  glVertexArrayAttribFormat(name(), location, components, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
  glVertexArrayAttribBinding(name(), location, binding);
}

void GlVertexArray::set_indices(const GlBuffer& buffer) {
  glVertexArrayElementBuffer(name(), buffer.name());
}

}  // namespace luminist
