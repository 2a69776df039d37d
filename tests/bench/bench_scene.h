#pragma once
// tests/bench/bench_scene.h -- the scenes that benchmarks run on.
#include <memory>
#include <string>
#include <vector>

#include "studio/stage.h"

namespace luminist {

/// A name for reports, and the shot.
struct BenchScene {
  std::string name;
  Shot shot;
};

/// A scene of meshes/ with its committed rig.
BenchScene demo_scene(const std::string& name);

/// A scene of meshes/ by its name, or any scene file, which gets a floor and a wall; without lights.
BenchScene bare_scene(const std::string& scene);

/// Every mesh of a folder, on a floor before a wall, by name. errors kMissing.
Result<std::vector<BenchScene>> scenes_of_folder(const std::string& folder);

/// A scene at one size, ready to be solved in.
struct BenchStage {
  std::string scene;
  int width = 0;
  int height = 0;
  std::unique_ptr<Stage> stage;
  ParamState state;  ///< its rig, as committed; everything locked

  [[nodiscard]] Renderer& renderer() const { return *stage->renderer; }
  [[nodiscard]] const SceneFrame& frame() const { return stage->frame; }
};

/// errors those of open_stage() and starting_state().
Result<BenchStage> open_bench_stage(Device& device, const BenchScene& scene, int width, int height);

/// A picture that is asked for as it is: importance 1 everywhere.
Target whole_picture(Image wanted, Image before);

}  // namespace luminist
