#pragma once
// tests/bench/recover.h -- a hidden light of 18 degrees of freedom is asked for by its picture, and found again.
#include "bench/bench_suite.h"
#include "gpu/device.h"

namespace luminist {

struct RecoverOptions {
  SuiteOptions suite;
  std::string scene = "still_life";  ///< a folder of meshes/, or a scene file
  std::string meshes;                ///< a folder: every mesh in it is run, on a floor before a wall
  bool no_simplex = false;           ///< the fast solver alone
  PictureSize size{256, 256};
  PictureSize simplex_size{128, 128};
  int seeds = 20;
  int simplex_seeds = 5;
};

/// Runs the fast solver over all seeds and the simplex over its own, smaller share. Success: epsilon fell to 5 % of
/// that of the start light of section 5.2. errors kMissing; the renderer's.
Result<void> run_recover(Device& device, const RecoverOptions& options);

}  // namespace luminist
