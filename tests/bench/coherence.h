#pragma once
// bench/coherence.h -- whether ink holds still: what becomes of it at the same surface points from frame to frame.
#include <string>
#include <vector>

#include "base/result.h"
#include "gpu/device.h"

namespace luminist {

struct CoherenceOptions {
  bool json = false;
  std::vector<std::string> styles{"cinematic", "hatching", "toon+outline", "halftone"};
  int first = 12;  ///< frames of the creature
  int count = 8;   ///< pairs of frames
  int width = 640;
  int height = 480;
};

/// For each pair of frames that follow each other, over the pixels whose surface point is seen in both and has moved
/// by at least half a pixel: the mean change of luminance at the surface point, at the pixel, and the mean motion in
/// pixels; medians over the pairs. Ink that sticks to the surface changes at its pixel and not at its point.
/// errors those of open_stage() and the renderer.
Result<void> run_coherence(Device& device, const CoherenceOptions& options);

}  // namespace luminist
