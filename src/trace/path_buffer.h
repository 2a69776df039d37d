#pragma once
// trace/path_buffer.h -- kept paths of a set of pixels: the deep framebuffer of the path tracer.
#include <cstdint>
#include <span>
#include <vector>

#include "trace/light_gathering.h"
#include "trace/path_tracer.h"

namespace luminist {

/// A pixel of a buffer, by its place in the buffer's list, and how many of its paths are asked.
struct AskedPixel {
  std::uint32_t slot = 0;
  std::uint32_t paths = 0;
};

/// Paths 0 .. paths - 1 of some pixels. thread any, const calls are concurrent.
class PathBuffer {
 public:
  /// Traces in parallel; same arguments, same bits, whatever the number of threads. The tracer must outlive it.
  /// memory about 500 bytes a path. cost about 2 us a path and core.
  PathBuffer(const PathTracer& tracer, std::span<const std::uint32_t> pixels, int paths, const PathOptions& options);

  [[nodiscard]] int paths() const { return paths_; }
  [[nodiscard]] std::size_t pixels() const { return pixels_; }

  /// out[i] := mean over the first asked[i].paths paths of what the light adds, its colour being 1. returns the number
  /// of shadow rays.
  std::size_t gather(const RigLight& light, std::span<const AskedPixel> asked, std::span<Vec3> out) const;
  /// The same means of what does not depend on the rig's lights: what shines in the scene, and what a radiance of 1 all
  /// around adds.
  void base(std::span<const AskedPixel> asked, std::span<Vec3> emitted, std::span<Vec3> escaped) const;

 private:
  static constexpr std::size_t kBlock = 32;  // pixels that are traced together
  const PathTracer* tracer_;
  std::size_t pixels_;
  int paths_;
  std::vector<LightPaths> blocks_;
};

}  // namespace luminist
