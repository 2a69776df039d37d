#include "studio/scene_export.h"

#include <utility>

namespace luminist {

Result<void> export_scene(const Stage& stage, const Shot& shot, const ParamState& state, const std::string& path) {
  Diagnostics told_already;
  LUM_TRY(Scene scene, load_scene(stage.scene_file, shot.scene_options, told_already));
  const std::vector<std::string> names = material_names(scene.materials);
  bool same = state.materials.empty() || names.size() == state.materials.size();
  for (std::size_t i = 0; same && i < state.materials.size(); ++i) same = names[i] == state.materials[i].name;
  if (!same) {
    return Error{ErrorKind::kBadContent, "the scene has other materials than when it was opened", stage.scene_file, "",
                 "open the shot again"};
  }
  if (!scene.deformers.empty()) pose(scene, shot.seconds());  // written as it stands at the frame that is seen
  return save_scene(with_materials(std::move(scene), state.materials), path);
}

}  // namespace luminist
