#pragma once
// studio/shot.h -- what is looked at, from where and in which style.
#include <filesystem>
#include <string>
#include <vector>

#include "base/files.h"
#include "project/document.h"
#include "scene/scene.h"

namespace luminist {

/// A shot as a lighter names it. Paths are those of find_input().
struct Shot {
  std::string scene;
  SceneOptions scene_options;
  std::string camera;  ///< empty: the scene's first
  int width = 640;
  int height = 480;
  std::string style = "cinematic";
  std::string rig;               ///< rig file; empty: the lights that the scene brings along, or none
  std::vector<std::string> set;  ///< "path=value", applied last
  double frame = 0.0;            ///< what moves, and the lights' keys, are as they are at frame / fps seconds
  double fps = 24.0;             ///< > 0

  [[nodiscard]] double seconds() const { return frame / fps; }
};

/// The file that a user means: as it stands or below `folder`, else below an asset root.
/// errors kMissing, naming what was tried first.
Result<std::string> find_input(const std::string& path, const std::filesystem::path& folder, const AssetRoots& roots);

/// "shot/scene", "shot/floor", "shot/wall", "shot/camera", "shot/size", "shot/style", "shot/frame", "shot/fps": what a
/// stage is made of. The rig is in paths of its own.
void write_shot(const Shot& shot, Document& document);
/// errors kBadContent naming the path.
Result<Shot> read_shot(const Document& document);

/// Whether both need the same stage.
bool same_stage(const Shot& one, const Shot& other);

/// The same file in other words: relative to the asset root that holds it, or else absolute, so that a project can be
/// opened from anywhere.
std::string portable_path(const std::string& path, const AssetRoots& roots);

}  // namespace luminist
