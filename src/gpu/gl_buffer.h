#pragma once
// gpu/gl_buffer.h -- bytes in the memory of the graphics device.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "gpu/device.h"
#include "gpu/gl_name.h"

namespace luminist {

/// What a buffer is for: decides the limit that its size is checked against.
enum class BufferUse { kVertex, kUniform, kStorage };

class GlBuffer {
 public:
  GlBuffer() = default;

  /// Room for `bytes` (at least 16 are allocated, so that an empty list can be bound), zero-filled.
  /// errors kLimit above the device's block size for this use, or if memory runs out.
  static Result<GlBuffer> create(Device& device, BufferUse use, std::size_t bytes, const std::string& label);
  /// Filled with a copy of the values.
  template <class T>
  static Result<GlBuffer> create(Device& device, BufferUse use, std::span<const T> values, const std::string& label) {
    return create_with(device, use, std::as_bytes(values), label);
  }

  [[nodiscard]] GLuint name() const { return name_.get(); }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

  /// Copies values to byte_offset; they must fit.
  template <class T>
  void write(std::size_t byte_offset, std::span<const T> values) {
    write_bytes(byte_offset, std::as_bytes(values));
  }
  /// Copies from byte_offset into values; waits for the device, and sees what shaders wrote before.
  template <class T>
  void read(std::size_t byte_offset, std::span<T> values) const {
    read_bytes(byte_offset, std::as_writable_bytes(values));
  }
  /// Copies within the device, also within one buffer if the ranges do not overlap.
  void copy_from(const GlBuffer& source, std::size_t source_offset, std::size_t offset, std::size_t byte_count);
  /// Every 32-bit word of the range := value. Offset and size are multiples of 4.
  void fill(std::size_t byte_offset, std::size_t byte_count, float value);

  void bind_storage(GLuint binding) const { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name()); }
  void bind_uniform(GLuint binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, binding, name()); }

 private:
  static Result<GlBuffer> create_with(Device& device, BufferUse use, std::span<const std::byte> bytes,
                                      const std::string& label);
  void write_bytes(std::size_t byte_offset, std::span<const std::byte> bytes);
  void read_bytes(std::size_t byte_offset, std::span<std::byte> bytes) const;

  static void remove(GLuint name) { glDeleteBuffers(1, &name); }
  static GlName<remove> new_name();
  GlName<remove> name_;
  std::size_t bytes_ = 0;
};

}  // namespace luminist
