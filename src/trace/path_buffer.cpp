#include "trace/path_buffer.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "base/check.h"

namespace luminist {

PathBuffer::PathBuffer(const PathTracer& tracer, std::span<const std::uint32_t> pixels, int paths,
                       const PathOptions& options)
    : tracer_(&tracer), pixels_(pixels.size()), paths_(paths), blocks_((pixels.size() + kBlock - 1) / kBlock) {
  tbb::parallel_for(std::size_t{0}, blocks_.size(), [&](std::size_t block) {
    LightPaths& kept = blocks_[block];
    const std::size_t end = std::min(pixels.size(), (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < end; ++i) {
      for (int path = 0; path < paths; ++path) {
        tracer.trace(pixels[i], static_cast<std::uint32_t>(path), options, kept);
      }
    }
    kept.vertices.shrink_to_fit();
  });
}

std::size_t PathBuffer::gather(const RigLight& light, std::span<const AskedPixel> asked, std::span<Vec3> out) const {
  std::size_t rays = 0;
  std::vector<Vec3> sums;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    LUM_CHECK(asked[i].slot < pixels_ && asked[i].paths <= static_cast<std::uint32_t>(paths_), "it is kept");
    out[i] = Vec3(0.0F);
    if (asked[i].paths == 0) continue;
    sums.assign(asked[i].paths, Vec3(0.0F));
    const std::size_t first = asked[i].slot % kBlock * static_cast<std::size_t>(paths_);
    rays += gather_light(tracer_->rays(), blocks_[asked[i].slot / kBlock], first, asked[i].paths, light, sums);
    for (const Vec3& sum : sums) out[i] += is_finite(sum) ? sum : Vec3(0.0F);
    out[i] /= static_cast<float>(asked[i].paths);
  }
  return rays;
}

void PathBuffer::base(std::span<const AskedPixel> asked, std::span<Vec3> emitted, std::span<Vec3> escaped) const {
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const LightPaths& kept = blocks_[asked[i].slot / kBlock];
    const std::size_t first = asked[i].slot % kBlock * static_cast<std::size_t>(paths_);
    emitted[i] = escaped[i] = Vec3(0.0F);
    for (std::size_t path = first; path < first + asked[i].paths; ++path) {
      emitted[i] += is_finite(kept.emitted[path]) ? kept.emitted[path] : Vec3(0.0F);
      escaped[i] += kept.escaped[path];
    }
    const float share = 1.0F / static_cast<float>(std::max(1U, asked[i].paths));
    emitted[i] *= share;
    escaped[i] *= share;
  }
}

}  // namespace luminist
