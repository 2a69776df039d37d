#pragma once
// tests/bench/bench_scene.h -- the scenes that benchmarks run on.
#include <memory>
#include <string>
#include <vector>

#include "studio/stage.h"

namespace luminist {

struct BenchOptions {
  std::string scene = "still_life";  ///< a folder of meshes/, or a scene file
  std::string meshes;                ///< a folder: every mesh in it is run, on a floor before a wall
  int width = 256;
  int height = 256;
  int seeds = 20;
  bool json = false;
  bool verbose = false;     ///< a line a run, on stderr
  bool no_simplex = false;  ///< the fast solver alone
  int simplex_width = 128;
  int simplex_height = 128;
  int simplex_seeds = 5;
  int simplex_evals = 5000;
};

/// A name for reports and the shot.
struct BenchScene {
  std::string name;
  Shot shot;
};

/// errors kMissing.
Result<std::vector<BenchScene>> bench_scenes(const BenchOptions& options);

/// The stage of a scene at a size.
Result<std::unique_ptr<Stage>> bench_stage(Device& device, const BenchScene& scene, int width, int height);

}  // namespace luminist
