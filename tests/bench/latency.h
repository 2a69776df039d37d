#pragma once
// tests/bench/latency.h -- how long a hand waits for its picture.
#include <string>

#include "base/result.h"

namespace luminist {

struct LatencyOptions {
  bool json = false;
  std::string scene = "meshes/still_life/still_life.glb";
  std::string strokes = "meshes/still_life/figure2/1_key.json";
  int width = 1280;
  int height = 720;
};

/// Paints the strokes on a studio's thread in real time, as a hand does with a tablet: 60 events a second, one picture
/// height a second, a pause between strokes. Says, as median and 95th percentile in seconds, how long after an event a
/// snapshot holds its points and the picture of the lights that follow them ("event_to_picture"), and how long after
/// each stroke the picture is there at full size ("stroke_to_full"). What a window adds is one frame.
/// errors those of the scene and the strokes; kLimit if the studio does not answer for two minutes.
Result<void> run_latency(const LatencyOptions& options);

}  // namespace luminist
