#include "cli/shot_words.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <charconv>

#include <fmt/format.h>

#include "cli/task_words.h"
#include "studio/constraint_words.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

Result<std::pair<int, int>> parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  int width = 0;
  int height = 0;
  const auto number = [](const char* first, const char* last, int& value) {
    const auto [end, status] = std::from_chars(first, last, value);
    return status == std::errc() && end == last;
  };
  const bool fine = cross != std::string::npos && number(text.data(), text.data() + cross, width) &&
                    number(text.data() + cross + 1, text.data() + text.size(), height) && width > 0 && height > 0;
  if (fine) return std::pair(width, height);
  return Error{ErrorKind::kUsage, fmt::format("\"{}\" is no size", text), "", "--size", "write it as 640x480"};
}

/// Writes and removes a small file: permissions, full disks and folders that are files all show themselves.
Result<void> try_folder(const fs::path& folder, const std::string& wanted) {
  const fs::path probe = folder / fmt::format(".luminist-probe-{}", content_hash(wanted).substr(0, 8));
  auto written = write_file_atomic(probe, "probe");
  std::error_code error;
  fs::remove(probe, error);
  if (written) return {};
  Error unwritable = std::move(written).error();
  unwritable.where = wanted;
  return unwritable;
}

}  // namespace

void declare_view(CLI::App& app, ShotWords& words) {
  app.add_option("SCENE", words.shot.scene, "glTF (.gltf, .glb), .obj, .ply, .stl or .off")->required();
  app.add_option("--camera", words.shot.camera, "Name of a camera of the scene (default: the first)");
  app.add_option("--size", words.size, "Pixels as WxH (default: 640x480)");
  app.add_option("--frame", words.shot.frame,
                 "Where the scene's animation and the rig's keys are looked at (default: 0)");
  require_above_zero(*app.add_option("--fps", words.shot.fps, "Frames a second (default: 24)"));
  app.add_flag("--floor", words.shot.scene_options.floor, "Puts a floor under the scene");
  app.add_flag("--wall", words.shot.scene_options.wall, "Puts a wall behind the scene");
}

void declare_shot(CLI::App& app, ShotWords& words) {
  declare_view(app, words);
  app.add_option("--rig", words.shot.rig, "Rig file with the lights (default: those in the scene)");
  app.add_option("--style", words.style, "Name of a folder in styles/ (default: cinematic)");
  app.add_option("--samples", words.samples, "Paths a pixel of a path-traced style, as --set style/samples=N")
      ->check(CLI::Range(1, 4096));
  app.add_option("--set", words.shot.set, "Sets a parameter, as lights/key/color=1,0.9,0.8; may be repeated")
      ->allow_extra_args(false)
      ->type_name("PATH=VALUE");
  app.add_option("--link", words.link,
                 "A light, or group:NAME, lights only the objects of these names or patterns, as key=creature*,floor; "
                 "may be repeated")
      ->allow_extra_args(false)
      ->type_name("LIGHT=OBJECTS");
  app.add_option("--constrain", words.constrain, std::string("Holds from now on; may be repeated. ") + kConstraintForms)
      ->allow_extra_args(false)
      ->type_name("RULE");
}

Result<Shot> shot_from(const ShotWords& words) {
  Shot shot = words.shot;
  if (!words.size.empty()) {
    LUM_TRY(const auto size, parse_size(words.size));
    shot.width = size.first;
    shot.height = size.second;
  }
  if (words.style.find(',') != std::string::npos) {
    return Error{ErrorKind::kUsage, "styles cannot be stacked: one style at a time draws the picture", "", "--style",
                 fmt::format("choose one of {}", words.style)};
  }
  if (!words.style.empty()) shot.style = words.style;
  if (words.samples) shot.set.insert(shot.set.begin(), fmt::format("style/samples={}", *words.samples));
  return shot;
}

Result<void> check_image_output(const std::string& path) {
  const fs::path file(path);
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending != ".exr" && ending != ".png") {
    return Error{ErrorKind::kUsage, fmt::format("\"{}\" is no kind of picture that can be written", ending), path, "-o",
                 "end the name in .exr or .png"};
  }
  std::error_code error;
  if (fs::is_directory(file, error)) {
    return Error{ErrorKind::kUnwritable, "it is a folder", path, "-o", "give the name of a file"};
  }
  if (file.has_parent_path()) LUM_TRY_VOID(make_folder(file.parent_path()));
  return try_folder(file.has_parent_path() ? file.parent_path() : fs::path("."), path);
}

Result<void> check_folder_output(const std::string& path) {
  LUM_TRY_VOID(make_folder(path));
  return try_folder(path, path);
}

}  // namespace luminist
