#pragma once
// trace/path_buffer.h -- kept paths of a picture's pixels: the deep framebuffer of the path tracer.
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "trace/light_gathering.h"
#include "trace/path_tracer.h"

namespace luminist {

/// A pixel of the picture (linear index), and how many of its paths are asked.
struct AskedPixel {
  std::uint32_t pixel = 0;
  std::uint32_t paths = 0;
};

/// The first paths of pixels, as many as were wanted of each so far. thread any, const calls are concurrent.
class PathBuffer {
 public:
  /// The tracer must outlive it.
  PathBuffer(const PathTracer& tracer, const PathOptions& options);

  /// Traces what is not there yet, in parallel. Same paths, whatever the order of wishes and the number of threads.
  /// memory about 500 bytes a path. cost about 3 us a path and core.
  void want(std::span<const AskedPixel> asked);
  /// All paths that are there.
  [[nodiscard]] std::size_t held() const { return held_; }

  /// out[i] := mean over the first asked[i].paths paths of what the light adds, its colour being 1. returns the number
  /// of shadow rays. Only of paths that were wanted.
  std::size_t gather(const RigLight& light, std::span<const AskedPixel> asked, std::span<Vec3> out) const;
  /// The same means of what does not depend on the rig's lights: what shines in the scene, and what a radiance of 1 all
  /// around adds.
  void base(std::span<const AskedPixel> asked, std::span<Vec3> emitted, std::span<Vec3> escaped) const;

 private:
  [[nodiscard]] std::size_t there(std::uint32_t pixel) const;
  [[nodiscard]] const LightPaths& paths_of(const AskedPixel& asked) const;

  const PathTracer* tracer_;
  PathOptions options_;
  std::vector<std::unique_ptr<LightPaths>> pixels_;  ///< null where nothing was wanted
  std::size_t held_ = 0;
};

}  // namespace luminist
