#pragma once
// studio/scene_export.h -- the scene of a shot with its materials as they are turned, for other programs.
#include <string>

#include "studio/stage.h"

namespace luminist {

/// Reads the stage's scene file again and writes it as a binary glTF, with backdrops where the shot has them and with
/// the state's materials (with_materials()); its lights are the file's. errors those of load_scene() and save_scene();
/// kBadContent if the file has other materials than when the stage was opened. cost reading and writing the scene.
Result<void> export_scene(const Stage& stage, const Shot& shot, const ParamState& state, const std::string& path);

}  // namespace luminist
