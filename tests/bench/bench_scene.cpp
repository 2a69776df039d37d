#include "bench/bench_scene.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace luminist {

namespace fs = std::filesystem;

BenchScene demo_scene(const std::string& name) {
  BenchScene scene = bare_scene(name);
  scene.shot.rig = "meshes/" + name + "/rig.toml";
  return scene;
}

BenchScene bare_scene(const std::string& scene) {
  BenchScene result;
  const bool is_file = fs::path(scene).has_extension();
  result.name = fs::path(scene).stem().string();
  result.shot.scene = is_file ? scene : "meshes/" + scene + "/" + scene + ".glb";
  result.shot.scene_options = {is_file, is_file};
  return result;
}

Result<std::vector<BenchScene>> scenes_of_folder(const std::string& folder) {
  std::vector<BenchScene> scenes;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".obj" && extension != ".ply" && extension != ".glb" && extension != ".stl") continue;
    scenes.push_back(bare_scene(entry.path().string()));
  }
  if (scenes.empty()) {
    return Error{ErrorKind::kMissing, "no meshes in this folder", folder, "meshes", "name a folder of .obj files"};
  }
  std::sort(scenes.begin(), scenes.end(), [](const BenchScene& a, const BenchScene& b) { return a.name < b.name; });
  return scenes;
}

Result<BenchStage> open_bench_stage(Device& device, const BenchScene& scene, int width, int height) {
  Shot shot = scene.shot;
  shot.width = width;
  shot.height = height;
  Diagnostics diagnostics;
  const AssetRoots roots = AssetRoots::standard();
  LUM_TRY(std::unique_ptr<Stage> stage, open_stage(device, roots, shot, fs::current_path(), diagnostics));
  LUM_TRY(ParamState state, starting_state(*stage, roots, shot, fs::current_path()));
  for (ParamBlock* block : state.blocks()) block->set_param_locked(-1, true);
  return BenchStage{scene.name, width, height, std::move(stage), std::move(state)};
}

Target whole_picture(Image wanted, Image before) {
  Target target;
  target.importance = Image(wanted.width, wanted.height, 1, 1.0F);
  target.stroke.assign(wanted.pixels(), 0);
  target.color = std::move(wanted);
  target.before = std::move(before);
  return target;
}

}  // namespace luminist
