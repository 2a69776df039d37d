#pragma once
// trace/progressive.h -- a picture from fresh paths, pass by pass.
#include <cstdint>
#include <functional>
#include <span>

#include "base/image.h"
#include "base/result.h"
#include "trace/path_tracer.h"
#include "trace/rig_light.h"

namespace luminist {

/// What a picture has come to.
struct PathProgress {
  int samples = 0;  ///< done, of a pixel that gets most
  int of = 0;
  const Image* so_far = nullptr;
};
/// Called after every pass; false cancels the picture.
using PathWatch = std::function<bool(const PathProgress&)>;

/// What is to be drawn.
struct PathJob {
  PathOptions options;
  std::span<const RigLight> lights;
  Vec3 ambient{0.0F};                      ///< radiance of what is seen where nothing is
  std::span<const std::uint32_t> samples;  ///< [pixels]
  /// What one path may bring at most by way of a second surface, in its largest channel; 0: anything. Rare bright paths
  /// are single bright pixels; what is taken off them is missing in the mean.
  float most_later = 0.0F;
};

/// Means over each pixel's samples; black where there are none. Passes double up to eight samples, so that something is
/// seen soon. watch may be empty. queries is increased by the number of shadow rays.
/// errors kCancelled. thread: works in parallel; same arguments, same bits. memory: that of a few rows' paths.
Result<Image> trace_picture(const PathTracer& tracer, const PathJob& job, const PathWatch& watch, double& queries);

}  // namespace luminist
