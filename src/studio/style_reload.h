#pragma once
// studio/style_reload.h -- a style that is edited while it is looked at.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "studio/stage.h"

namespace luminist {

/// Remembers when the files of a style were written: manifests, GLSL, textures.
class StyleFiles {
 public:
  explicit StyleFiles(const Style& style) { follow(style); }
  /// Those that are there now, in the order of their paths.
  [[nodiscard]] std::vector<std::filesystem::path> files() const;
  /// A new version may have files elsewhere: what is there now is known.
  void follow(const Style& style);
  /// Whether one was written, added or removed since the last look (or since this was made).
  [[nodiscard]] bool changed();

 private:
  using Times = std::map<std::string, std::filesystem::file_time_type>;
  [[nodiscard]] Times times() const;

  std::vector<std::filesystem::path> folders_;
  Times seen_;
};

/// The parameters of a style that is there in a new version: one keeps its value and locks if it is there still with
/// the same type, unless it had the old default; then it gets the new one. cost O(parameters).
ParamState carried_over(const ParamState& state, const Style& style, const SceneFrame& frame);

/// The same of materials that the stage's scene has by name: its file may have been written again meanwhile.
std::vector<MaterialParams> carried_materials(const std::vector<MaterialParams>& before, const Stage& stage);

/// Reads the stage's style again and compiles it in place; scene, shadows and paint stay. returns carried_over().
/// errors kStyle at the author's line, and the stage is as it was: the last good version stays. kUsage for what needs
/// another stage: a path-traced style, and one that now unwraps meshes or draws lines and did not before, or the
/// reverse.
Result<ParamState> reload_style(Stage& stage, const AssetRoots& roots, const ParamState& state);

}  // namespace luminist
