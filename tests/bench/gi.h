#pragma once
// tests/bench/gi.h -- a ceiling light found from paint under global illumination (paper, Figure 10 and section 6.1.3).
#include <string>
#include <vector>

#include "base/result.h"
#include "bench/bench_suite.h"
#include "gpu/device.h"

namespace luminist {

struct GiOptions {
  PictureSize size{128, 128};
  int seeds = 3;                     ///< starts of the light, and paths
  int max_evals = 150;               ///< pictures that a simplex compares, on all its sizes together
  int samples = 64;                  ///< paths a pixel of those pictures
  int reference = 1024;              ///< paths a pixel of the picture that judges
  std::vector<std::string> methods;  ///< only these of full, multiresolution, kept, searched; empty: all
  bool json = false;
};

/// One strokes file painted on the room, 4 degrees of freedom of a panel on the ceiling (x, z, size, intensity), from a
/// different place for every seed. Four methods:
///
/// full              the simplex of the paper on whole pictures, each traced anew (unimportant pixels with fewer
///                   paths), until it has collapsed once or the cap is reached
/// multiresolution   the same from a quarter of the size over a half to the whole, each from where the last one ended
/// kept              the fast solver on kept paths, without its rounds of restarts either; refined where that gains
/// searched          the same with its rounds, as the studio solves
///
/// Each is timed from its first picture on (kept paths are traced within); the scene is loaded before. The state that
/// comes out is judged by an independent picture: other seed, `reference` samples. A line a run, then medians and
/// ratios; JSON: {bench: "gi", kind: "run", method, seed, size, evals, capped, seconds, cpu_seconds, first_seconds,
/// epsilon_start, epsilon, found (x, z, size, intensity)} and {kind: "result", method, seconds, cpu_seconds,
/// first_seconds, epsilon, speedup, cpu_speedup}. errors the renderer's.
Result<void> run_gi(Device& device, const GiOptions& options);

}  // namespace luminist
