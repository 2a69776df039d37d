#pragma once
// gpu/program.h -- shaders from several files, with errors at the user's file, line and column.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/math.h"
#include "base/result.h"
#include "gpu/device.h"
#include "gpu/gl_name.h"

namespace luminist {

/// A piece of GLSL. Chunks are joined in order; the host writes `#version 450 core` in front of them.
struct SourceChunk {
  std::string file;  ///< for messages: a path, or "<generated lights>"
  std::string text;
};

/// The chunk of a file below an asset root: "shaders/raster/gather.comp". errors kMissing.
Result<SourceChunk> load_chunk(const AssetRoots& roots, const std::string& relative_path);

class Program {
 public:
  Program() = default;

  /// errors kStyle at path:line:column (drivers that do not tell the column: path:line) with the driver's first
  /// message; kStyle without a line where linking fails. cost up to a second for the first time.
  static Result<Program> compute(Device& device, std::span<const SourceChunk> chunks, const std::string& label);
  static Result<Program> graphics(Device& device, std::span<const SourceChunk> vertex,
                                  std::span<const SourceChunk> fragment, const std::string& label);

  [[nodiscard]] GLuint name() const { return name_.get(); }
  void use() const { glUseProgram(name()); }

  /// Sets a uniform by name; one that the compiler removed is skipped.
  void set(const char* uniform, int value);
  void set(const char* uniform, unsigned value);
  void set(const char* uniform, float value);
  void set(const char* uniform, const Vec2& value);
  void set(const char* uniform, const Vec3& value);
  void set(const char* uniform, const Vec4& value);
  void set(const char* uniform, const Mat3& value);
  void set(const char* uniform, const Mat4& value);

  /// Runs a compute program with local size `local_size` x 1 x 1 on at least `count` invocations, as a grid of groups
  /// that may be two-dimensional: index = (group.y * groups.x + group.x) * local_size + local index, which
  /// shaders/raster/dispatch.glsl computes as linear_index(). What it writes is visible to shaders, copies and reads
  /// that follow.
  void dispatch(Device& device, std::size_t count, std::size_t local_size = 64) const;

 private:
  static void remove(GLuint name) { glDeleteProgram(name); }
  GlName<remove> name_;
};

/// What a driver's log says first, its line mapped back through the chunks' line bases. Exposed for tests: knows the
/// forms "0:30012(7): error: text" and "0(30012) : error C1503: text".
Error shader_error(std::span<const SourceChunk> chunks, const std::string& log, const std::string& label);

}  // namespace luminist
