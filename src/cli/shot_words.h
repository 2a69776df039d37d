#pragma once
// cli/shot_words.h -- SHOT = SCENE [--camera C] [--size WxH] [--rig R] [--style A] [--samples N] [--frame F] [--fps N]
// [--set path=value]... [--link LIGHT=OBJECTS]... [--constrain WORDS]... [--floor] [--wall]
#include <optional>
#include <string>
#include <vector>

#include "cli/verb.h"
#include "studio/shot.h"

namespace luminist {

/// The words of a shot as they were typed.
struct ShotWords {
  Shot shot;
  std::string size;
  std::string style;
  std::optional<int> samples;          ///< of a path-traced style
  std::vector<std::string> link;       ///< for link_lights(), once all lights are there
  std::vector<std::string> constrain;  ///< for parse_constraint(), once all lights are there
};

/// Scene, camera, size and time: the words that say what is looked at, for verbs that need no lights and no style.
void declare_view(CLI::App& app, ShotWords& words);
/// The words that render, paint and solve share: these and those of lights and style.
void declare_shot(CLI::App& app, ShotWords& words);

/// errors kUsage for a size that is not WxH and for more than one style.
Result<Shot> shot_from(const ShotWords& words);

/// Whether an image can be written there, tried before long work: the ending is .exr or .png and the folder, which is
/// made if it is not there, takes files. errors kUsage, kUnwritable.
Result<void> check_image_output(const std::string& path);
/// Makes the folder and tries it. errors kUnwritable.
Result<void> check_folder_output(const std::string& path);

}  // namespace luminist
