#include "bench/bench_scene.h"

#include <algorithm>
#include <filesystem>

namespace luminist {

namespace fs = std::filesystem;

Result<std::vector<BenchScene>> bench_scenes(const BenchOptions& options) {
  std::vector<BenchScene> scenes;
  if (options.meshes.empty()) {
    BenchScene scene{options.scene, {}};
    const bool is_file = fs::path(options.scene).has_extension();
    scene.shot.scene = is_file ? options.scene : "meshes/" + options.scene + "/" + options.scene + ".glb";
    scene.shot.scene_options = {is_file, is_file};
    scene.name = fs::path(options.scene).stem().string();
    scenes.push_back(scene);
    return scenes;
  }
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(options.meshes, error)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".obj" && extension != ".ply" && extension != ".glb" && extension != ".stl") continue;
    BenchScene scene{entry.path().stem().string(), {}};
    scene.shot.scene = entry.path().string();
    scene.shot.scene_options = {true, true};
    scenes.push_back(scene);
  }
  if (scenes.empty()) {
    return Error{ErrorKind::kMissing, "no meshes in this folder", options.meshes, "meshes",
                 "name a folder of .obj files"};
  }
  std::sort(scenes.begin(), scenes.end(), [](const BenchScene& a, const BenchScene& b) { return a.name < b.name; });
  return scenes;
}

Result<std::unique_ptr<Stage>> bench_stage(Device& device, const BenchScene& scene, int width, int height) {
  Shot shot = scene.shot;
  shot.width = width;
  shot.height = height;
  Diagnostics diagnostics;
  return open_stage(device, AssetRoots::standard(), shot, fs::current_path(), diagnostics);
}

}  // namespace luminist
