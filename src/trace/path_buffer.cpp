#include "trace/path_buffer.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "base/check.h"

namespace luminist {

PathBuffer::PathBuffer(const PathTracer& tracer, const PathOptions& options)
    : tracer_(&tracer),
      options_(options),
      pixels_(static_cast<std::size_t>(tracer.width()) * static_cast<std::size_t>(tracer.height())) {}

std::size_t PathBuffer::there(std::uint32_t pixel) const {
  return pixels_[pixel] ? pixels_[pixel]->size() : 0;
}

void PathBuffer::want(std::span<const AskedPixel> asked) {
  std::vector<AskedPixel> missing;
  for (const AskedPixel& each : asked) {
    LUM_CHECK(each.pixel < pixels_.size(), "a pixel of the picture");
    if (there(each.pixel) < each.paths) missing.push_back(each);
  }
  // A pixel may be asked for more than once; its largest wish counts.
  std::ranges::sort(missing, [](const AskedPixel& a, const AskedPixel& b) {
    return a.pixel != b.pixel ? a.pixel < b.pixel : a.paths > b.paths;
  });
  const auto same = [](const AskedPixel& a, const AskedPixel& b) { return a.pixel == b.pixel; };
  missing.erase(std::unique(missing.begin(), missing.end(), same), missing.end());
  for (const AskedPixel& each : missing) held_ += each.paths - there(each.pixel);
  tbb::parallel_for(std::size_t{0}, missing.size(), [&](std::size_t i) {
    const AskedPixel& wish = missing[i];
    std::unique_ptr<LightPaths>& kept = pixels_[wish.pixel];
    if (!kept) kept = std::make_unique<LightPaths>();
    for (auto path = static_cast<std::uint32_t>(kept->size()); path < wish.paths; ++path) {
      tracer_->trace(wish.pixel, path, options_, *kept);
    }
    kept->vertices.shrink_to_fit();
  });
}

const LightPaths& PathBuffer::paths_of(const AskedPixel& asked) const {
  LUM_CHECK(there(asked.pixel) >= asked.paths, "it was wanted");
  return *pixels_[asked.pixel];
}

std::size_t PathBuffer::gather(const RigLight& light, std::span<const AskedPixel> asked, std::span<Vec3> out) const {
  std::size_t rays = 0;
  std::vector<Vec3> sums;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    out[i] = Vec3(0.0F);
    if (asked[i].paths == 0) continue;
    sums.assign(asked[i].paths, Vec3(0.0F));
    rays += gather_light(tracer_->rays(), paths_of(asked[i]), 0, asked[i].paths, light, sums);
    for (const Vec3& sum : sums) out[i] += is_finite(sum) ? sum : Vec3(0.0F);
    out[i] /= static_cast<float>(asked[i].paths);
  }
  return rays;
}

void PathBuffer::base(std::span<const AskedPixel> asked, std::span<Vec3> emitted, std::span<Vec3> escaped) const {
  for (std::size_t i = 0; i < asked.size(); ++i) {
    emitted[i] = escaped[i] = Vec3(0.0F);
    if (asked[i].paths == 0) continue;
    const LightPaths& kept = paths_of(asked[i]);
    for (std::size_t path = 0; path < asked[i].paths; ++path) {
      emitted[i] += is_finite(kept.emitted[path]) ? kept.emitted[path] : Vec3(0.0F);
      escaped[i] += kept.escaped[path];
    }
    emitted[i] /= static_cast<float>(asked[i].paths);
    escaped[i] /= static_cast<float>(asked[i].paths);
  }
}

}  // namespace luminist
