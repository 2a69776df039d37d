#include "studio/style_reload.h"

#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "raster/raster_renderer.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

void carry_over(const ParamBlock& before, ParamBlock& now, const SceneFrame& frame) {
  for (int param = 0; param < now.schema().size(); ++param) {
    const ParamSpec& spec = now.schema()[param];
    const auto old = before.schema().find(spec.name);
    if (!old) continue;
    const ParamSpec& was = before.schema()[*old];
    if (was.type != spec.type || was.dofs() != spec.dofs() || was.choices != spec.choices) continue;
    for (int i = 0; i < spec.dofs(); ++i) {
      now.set_locked(spec.first_dof + i, before.locked_by_hand(was.first_dof + i));
    }
    if (before.at_default(*old, frame)) continue;
    for (int i = 0; i < spec.components(); ++i) now.set(param, i, before.get(*old, i));
  }
}

}  // namespace

void StyleFiles::follow(const Style& style) {
  std::set<fs::path> folders{fs::path(style.folder)};
  if (!style.ink_folder.empty()) folders.insert(fs::path(style.ink_folder));
  for (const std::string& path : {style.glsl_path, style.ink_path}) {
    if (!path.empty()) folders.insert(fs::path(path).parent_path());
  }
  for (const StyleTexture& texture : style.textures) folders.insert(fs::path(texture.path).parent_path());
  folders_.assign(folders.begin(), folders.end());
  seen_ = times();
}

StyleFiles::Times StyleFiles::times() const {
  Times result;
  std::error_code error;
  for (const fs::path& folder : folders_) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      if (entry.is_regular_file(error)) result[entry.path().string()] = entry.last_write_time(error);
    }
  }
  return result;
}

std::vector<fs::path> StyleFiles::files() const {
  std::vector<fs::path> list;
  for (const auto& [path, time] : times()) list.emplace_back(path);
  return list;
}

bool StyleFiles::changed() {
  Times now = times();
  if (now == seen_) return false;
  seen_ = std::move(now);
  return true;
}

ParamState carried_over(const ParamState& state, const Style& style, const SceneFrame& frame) {
  ParamState next{state.rig, ParamBlock(style.schema, frame), state.materials};
  carry_over(state.style, next.style, frame);
  return next;
}

std::vector<MaterialParams> carried_materials(const std::vector<MaterialParams>& before, const Stage& stage) {
  std::vector<MaterialParams> now = stage.materials;
  std::map<std::string_view, const ParamBlock*> known;
  for (const MaterialParams& material : before) known[material.name] = &material.params;
  for (MaterialParams& material : now) {
    if (const auto it = known.find(material.name); it != known.end())
      carry_over(*it->second, material.params, stage.frame);
  }
  return now;
}

Result<ParamState> reload_style(Stage& stage, const AssetRoots& roots, const ParamState& state) {
  LUM_TRY(Style style, load_style(roots, stage.style.name));
  if (stage.raster == nullptr || style.engine != StyleEngine::kRaster) {
    return Error{ErrorKind::kUsage, "a path-traced style is not read again while it is looked at", style.folder,
                 "engine", "open the shot again"};
  }
  LUM_TRY_VOID(stage.raster->change_style(style, roots));
  ParamState next = carried_over(state, style, stage.frame);
  stage.style = std::move(style);
  return next;
}

}  // namespace luminist
