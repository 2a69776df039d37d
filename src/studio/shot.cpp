#include "studio/shot.h"

#include <array>
#include <system_error>

#include <nlohmann/json.hpp>

namespace luminist {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Error wrong(const std::string& path, const std::string& what) {
  return {ErrorKind::kBadContent, what, "", path, "the project was not written by this program"};
}

Result<std::string> text_at(const Document& document, const std::string& path) {
  const Json value = Json::parse(document.get(path), nullptr, false);
  if (!value.is_string()) return wrong(path, "a string is wanted");
  return value.get<std::string>();
}

Result<double> number_at(const Document& document, const std::string& path) {
  const Json value = Json::parse(document.get(path), nullptr, false);
  if (!value.is_number()) return wrong(path, "a number is wanted");
  return value.get<double>();
}

}  // namespace

Result<std::string> find_input(const std::string& path, const fs::path& folder, const AssetRoots& roots) {
  if (path.empty()) return Error{ErrorKind::kUsage, "a path is wanted", "", "", ""};
  const fs::path given(path);
  const fs::path beside = given.is_absolute() ? given : folder / given;
  std::error_code error;
  if (fs::exists(beside, error)) return beside.string();
  if (!given.is_absolute()) {
    if (auto found = roots.find(given)) return found->string();
  }
  return Error{ErrorKind::kMissing, "there is no such file", beside.string(), "", "check the spelling of the path"};
}

std::string portable_path(const std::string& path, const AssetRoots& roots) {
  std::error_code error;
  const fs::path absolute = fs::weakly_canonical(path, error);
  if (error) return path;
  // A suffix of the path that a root holds, and that is this very file.
  for (fs::path relative = absolute.filename(), parent = absolute.parent_path();;
       relative = parent.filename() / relative, parent = parent.parent_path()) {
    const auto found = roots.find(relative);
    if (found && fs::equivalent(*found, absolute, error)) return relative.string();
    if (parent == parent.root_path()) return absolute.string();
  }
}

void write_shot(const Shot& shot, Document& document) {
  document.set("shot/scene", Json(shot.scene).dump());
  document.set("shot/floor", Json(shot.scene_options.floor).dump());
  document.set("shot/wall", Json(shot.scene_options.wall).dump());
  document.set("shot/camera", Json(shot.camera).dump());
  document.set("shot/size", Json(std::array{shot.width, shot.height}).dump());
  document.set("shot/style", Json(shot.style).dump());
  document.set("shot/frame", Json(shot.frame).dump());
  document.set("shot/fps", Json(shot.fps).dump());
}

Result<Shot> read_shot(const Document& document) {
  Shot shot;
  LUM_TRY(shot.scene, text_at(document, "shot/scene"));
  LUM_TRY(shot.camera, text_at(document, "shot/camera"));
  LUM_TRY(shot.style, text_at(document, "shot/style"));
  shot.scene_options.floor = document.get("shot/floor") == "true";
  shot.scene_options.wall = document.get("shot/wall") == "true";
  const Json size = Json::parse(document.get("shot/size"), nullptr, false);
  if (!size.is_array() || size.size() != 2 || !size[0].is_number_integer() || !size[1].is_number_integer()) {
    return wrong("shot/size", "width and height are wanted");
  }
  shot.width = size[0].get<int>();
  shot.height = size[1].get<int>();
  // Older projects know no frames.
  if (document.has("shot/frame")) {
    LUM_TRY(shot.frame, number_at(document, "shot/frame"));
  }
  if (document.has("shot/fps")) {
    LUM_TRY(shot.fps, number_at(document, "shot/fps"));
  }
  if (!(shot.fps > 0.0)) return wrong("shot/fps", "frames a second are wanted");
  return shot;
}

bool same_stage(const Shot& one, const Shot& other) {
  return one.scene == other.scene && one.scene_options == other.scene_options && one.camera == other.camera &&
         one.width == other.width && one.height == other.height && one.style == other.style &&
         one.frame == other.frame && one.fps == other.fps;
}

}  // namespace luminist
