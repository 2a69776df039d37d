#pragma once
// studio/picture_export.h -- which pictures of a shot become files, and of which kind.
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "studio/session.h"

namespace luminist {

/// What is written. Of the lights that the session shows: a proposal's while there is one.
struct PictureChoice {
  bool light = true;        ///< picture: the shot as it is lit
  bool paint = true;        ///< target: what is painted
  bool importance = false;  ///< black counts most
  bool residual = false;    ///< what light and paint differ by, weighed by the importance
  bool each_light = false;  ///< light_NAME: as with that light alone, and no_lights; ambient and emission in each
  bool png = true;          ///< as the screen shows it at exposure 0
  bool exr = false;         ///< linear, 16 bits
  bool sheet = false;       ///< sheet.png: all of these, small, side by side
  bool rig = true;          ///< rig.toml, style.json and materials.json, with which the picture is made again
  bool scene = false;       ///< scene.glb, with the materials as they are turned
};
/// "light", "paint", "importance", "residual", "each_light": what pictures are called in scripts.
std::span<const std::string> picture_words();

/// Told what is written next, and how many are written of how many. returns whether to go on.
using ExportWatch = std::function<bool(const std::string& next, int done, int all)>;

/// Writes them below a folder, which is made. returns the files. errors kNothingToDo if nothing is chosen; kCancelled
/// if watch says so: what is written stays, every file whole; the renderer's, kUnwritable, kChild. cost a picture a
/// light.
Result<std::vector<std::filesystem::path>> export_pictures(Session& session, const PictureChoice& choice,
                                                           const std::filesystem::path& folder,
                                                           const ExportWatch& watch = {});

}  // namespace luminist
