#include "gpu/gl_buffer.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"

namespace luminist {
namespace {

constexpr std::size_t kLeastBytes = 16;
/// NVIDIA's driver (580.159) does not keep larger direct writes in order with a clear before them: they are lost. By
/// way of a copy they keep the order.
constexpr std::size_t kLargestDirectWrite = std::size_t{64} << 10U;

Result<void> check_size(const Device& device, BufferUse use, std::size_t bytes, const std::string& label) {
  std::int64_t limit = PTRDIFF_MAX;
  if (use == BufferUse::kStorage) limit = device.info().max_storage_block_bytes;
  if (use == BufferUse::kUniform) limit = device.info().max_uniform_block_bytes;
  if (bytes <= static_cast<std::size_t>(limit)) return {};
  return Error{ErrorKind::kLimit,
               fmt::format("{} would need {} bytes, and this device's limit is {}", label, bytes, limit), "", "",
               "make the picture smaller"};
}

}  // namespace

Result<GlBuffer> GlBuffer::create(Device& device, BufferUse use, std::size_t bytes, const std::string& label) {
  LUM_TRY(GlBuffer buffer, create_with(device, use, std::span(static_cast<const std::byte*>(nullptr), bytes), label));
  buffer.fill(0, (bytes + 3) / 4 * 4, 0.0F);
  return buffer;
}

Result<GlBuffer> GlBuffer::create_with(Device& device, BufferUse use, std::span<const std::byte> bytes,
                                       const std::string& label) {
  LUM_TRY_VOID(check_size(device, use, bytes.size(), label));
  LUM_TRY_VOID(device.check_errors("prepare " + label));
  GlBuffer buffer;
  buffer.name_ = new_name();
  const GLuint name = buffer.name();
  buffer.bytes_ = bytes.size();
  glObjectLabel(GL_BUFFER, name, -1, label.c_str());
  const std::size_t allocated = std::max(kLeastBytes, (bytes.size() + 3) / 4 * 4);
  const bool whole = allocated == bytes.size();
  glNamedBufferStorage(name, static_cast<GLsizeiptr>(allocated), whole ? bytes.data() : nullptr,
                       GL_DYNAMIC_STORAGE_BIT);
  LUM_TRY_VOID(device.check_errors("allocate " + label));
  if (!whole && bytes.data() != nullptr) buffer.write_bytes(0, bytes);
  return buffer;
}

GlName<GlBuffer::remove> GlBuffer::new_name() {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  return GlName<remove>(name);
}

void GlBuffer::write_bytes(std::size_t byte_offset, std::span<const std::byte> bytes) {
  LUM_CHECK(byte_offset + bytes.size() <= bytes_, "a write stays inside the buffer");
  if (bytes.empty()) return;
  const auto offset = static_cast<GLintptr>(byte_offset);
  const auto size = static_cast<GLsizeiptr>(bytes.size());
  if (bytes.size() <= kLargestDirectWrite) {
    glNamedBufferSubData(name(), offset, size, bytes.data());
    return;
  }
  const GlName<remove> staging = new_name();
  glNamedBufferStorage(staging.get(), size, bytes.data(), 0);
  glCopyNamedBufferSubData(staging.get(), name(), 0, offset, size);
}

void GlBuffer::read_bytes(std::size_t byte_offset, std::span<std::byte> bytes) const {
  LUM_CHECK(byte_offset + bytes.size() <= bytes_, "a read stays inside the buffer");
  if (bytes.empty()) return;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  // By way of a copy: a driver that sees a buffer read directly may move it to host memory, where shaders are slow.
  const GlName<remove> staging = new_name();
  const auto size = static_cast<GLsizeiptr>(bytes.size());
  glNamedBufferStorage(staging.get(), size, nullptr, GL_MAP_READ_BIT | GL_CLIENT_STORAGE_BIT);
  glCopyNamedBufferSubData(name(), staging.get(), static_cast<GLintptr>(byte_offset), 0, size);
  glGetNamedBufferSubData(staging.get(), 0, size, bytes.data());
}

void GlBuffer::copy_from(const GlBuffer& source, std::size_t source_offset, std::size_t offset,
                         std::size_t byte_count) {
  LUM_CHECK(source_offset + byte_count <= source.bytes_ && offset + byte_count <= bytes_, "a copy stays inside");
  if (byte_count == 0) return;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(source.name(), name(), static_cast<GLintptr>(source_offset), static_cast<GLintptr>(offset),
                           static_cast<GLsizeiptr>(byte_count));
}

void GlBuffer::fill(std::size_t byte_offset, std::size_t byte_count, float value) {
  LUM_CHECK(byte_offset % 4 == 0 && byte_count % 4 == 0, "whole words are filled");
  LUM_CHECK(byte_offset + byte_count <= (bytes_ + 3) / 4 * 4, "a fill stays inside the buffer");
  if (byte_count == 0) return;
  glClearNamedBufferSubData(name(), GL_R32F, static_cast<GLintptr>(byte_offset), static_cast<GLsizeiptr>(byte_count),
                            GL_RED, GL_FLOAT, &value);
}

}  // namespace luminist
