#include "studio/stage.h"

#include <utility>

#include <fmt/format.h>

#include "raster/raster_renderer.h"
#include "render/param_state.h"
#include "rig/light_links.h"
#include "studio/shot_camera.h"
#include "trace/path_renderer.h"

namespace luminist {
namespace {

constexpr int kLargestSide = 16384;

Result<void> check_size(int width, int height) {
  if (width < 1 || height < 1) {
    return Error{ErrorKind::kUsage, fmt::format("{} x {} is no picture", width, height), "", "size",
                 "write it as 640x480"};
  }
  if (width <= kLargestSide && height <= kLargestSide) return {};
  return Error{ErrorKind::kLimit, fmt::format("{} x {} pixels are too many", width, height), "", "size",
               fmt::format("a side has at most {} pixels", kLargestSide)};
}

/// The engine that the style asks for. The scene is not needed afterwards.
Result<void> make_renderer(Stage& stage, Device& device, const Scene& scene, const Camera& camera,
                           const AssetRoots& roots, const Shot& shot) {
  if (stage.style.engine == StyleEngine::kPath) {
    LUM_TRY(auto paths, PathRenderer::create(scene, camera, stage.style, shot.width, shot.height));
    stage.paths = paths.get();
    stage.renderer = std::move(paths);
    return {};
  }
  LUM_TRY(auto raster,
          RasterRenderer::create(device, scene, camera, stage.types, stage.style, roots, shot.width, shot.height));
  stage.raster = raster.get();
  stage.renderer = std::move(raster);
  return {};
}

}  // namespace

Result<std::unique_ptr<Stage>> open_stage(Device& device, const AssetRoots& roots, const Shot& shot,
                                          const std::filesystem::path& folder, Diagnostics& diagnostics,
                                          std::shared_ptr<Scene> moving) {
  LUM_TRY_VOID(check_size(shot.width, shot.height));
  auto stage = std::make_unique<Stage>();
  stage->id = device.new_id();
  LUM_TRY(stage->style, load_whole_style(roots, shot.style));
  LUM_TRY(stage->types, LightTypes::load(roots));
  LUM_TRY(stage->scene_file, find_input(shot.scene, folder, roots));
  std::shared_ptr<Scene> loaded = std::move(moving);
  if (!loaded) {
    LUM_TRY(Scene read, load_scene(stage->scene_file, shot.scene_options, diagnostics));
    loaded = std::make_shared<Scene>(std::move(read));
  }
  Scene& scene = *loaded;
  pose(scene, shot.seconds());
  LUM_TRY(const Camera camera, shot_camera(scene, shot.camera));
  stage->frame = scene.frame();
  stage->camera = camera;
  stage->bounds = scene.bounds();
  for (const Camera& each : scene.cameras) stage->camera_names.push_back(each.name);
  stage->scene_lights = scene.lights;
  LUM_TRY(const auto material_schema, load_material_schema(roots));
  stage->materials = material_params(scene.materials, *material_schema);
  LUM_TRY_VOID(make_renderer(*stage, device, scene, camera, roots, shot));
  stage->edges = std::make_shared<const EdgeMask>(edge_pixels(stage->renderer->surface()));
  if (!scene.animation.empty()) stage->moving = std::move(loaded);
  return stage;
}

std::span<const std::string> Stage::object_names() const {
  return std::span(renderer->surface().object_names).subspan(1);
}

Result<ParamState> starting_state(const Stage& stage, const AssetRoots& roots, const Shot& shot,
                                  const std::filesystem::path& folder) {
  ParamState state = initial_state(stage.types, stage.style, stage.frame);
  state.materials = stage.materials;
  if (!shot.rig.empty()) {
    LUM_TRY(const std::string path, find_input(shot.rig, folder, roots));
    LUM_TRY(state.rig, load_rig(path, stage.types, stage.frame));
    LUM_TRY_VOID(check_links(state.rig, stage.object_names(), path));
  } else if (!stage.scene_lights.empty()) {
    LUM_TRY(state.rig.lights, from_punctual(stage.scene_lights, stage.types, stage.frame));
  }
  pose(state.rig, shot.frame);
  for (const std::string& assignment : shot.set) LUM_TRY_VOID(set_path(state, assignment));
  keep_constraints(state.rig);
  follow_with_keys(state.rig, shot.frame);
  return state;
}

Result<bool> pose_lights(LightRig& rig, const Stage& from, const Stage& to, double frame) {
  pose(rig, frame);
  if (&from == &to || from.scene_lights.empty()) return false;
  LUM_TRY(const std::vector<Light> before, from_punctual(from.scene_lights, from.types, from.frame));
  LUM_TRY(const std::vector<Light> after, from_punctual(to.scene_lights, to.types, to.frame));
  const bool moved = follow_scene(rig, before, after);
  if (moved) keep_constraints(rig);
  return moved;
}

Result<Image> render_shadow_picture(Renderer& renderer, const ParamState& lights, ShadowPicture which) {
  if (which == ShadowPicture::kShadowsOff) return renderer.render(lights, RenderOptions{.shadows = false});
  ParamState free_lights_off = lights;
  for (Light& light : free_lights_off.rig.lights) light.muted = light.muted || may_change(lights.rig, light);
  return renderer.render(free_lights_off);
}

void warn_of_ranges(const ParamState& state, const std::vector<std::string>& assignments, const SceneFrame& frame,
                    Diagnostics& diagnostics) {
  for (const std::string& assignment : assignments) {
    const std::string path = assignment.substr(0, assignment.find('='));
    const std::string note = range_note(state, path, frame);
    if (!note.empty()) diagnostics.warn(path, note);
  }
}

}  // namespace luminist
