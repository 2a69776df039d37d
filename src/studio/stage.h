#pragma once
// studio/stage.h -- a shot, loaded: scene, camera, style, light types and the engine that draws them.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "gpu/device.h"
#include "paint/canvas.h"
#include "render/renderer.h"
#include "rig/light_rig.h"
#include "rig/light_type.h"
#include "solve/sample_cells.h"
#include "studio/shot.h"
#include "style/style.h"

namespace luminist {

class PathRenderer;
class RasterRenderer;

/// Made by open_stage(); stays where it is, because the engine points into it.
struct Stage {
  std::uint64_t id = 0;  ///< no other stage on the device has it
  LightTypes types;
  Style style;
  SceneFrame frame;
  Camera camera;
  Box bounds;  ///< of the scene without backdrops
  std::vector<std::string> camera_names;
  std::vector<PunctualLight> scene_lights;
  std::vector<MaterialParams> materials;  ///< as the scene has them
  std::string scene_file;                 ///< where it was found
  std::shared_ptr<Scene> moving;          ///< the scene itself, to be posed again; null where nothing moves
  std::unique_ptr<Renderer> renderer;
  RasterRenderer* raster = nullptr;       ///< the renderer, where the style is drawn by the raster engine
  PathRenderer* paths = nullptr;          ///< the renderer, where it is path traced
  std::shared_ptr<const EdgeMask> edges;  ///< of the renderer's surface, for every solve on it

  [[nodiscard]] std::span<const std::string> object_names() const;  ///< of the scene; valid while the renderer is
};

/// The shot's scene at the shot's frame. device outlives the stage. Paths of the shot are looked for below folder, then
/// below the roots. The style chooses the engine. errors kUsage for an unknown camera (nearest name) or a bad size;
/// those of the scene, the style and the engine. cost reading the scene and compiling the style: seconds. A scene that
/// moves and was read before, by the stage of another frame of the shot, is taken instead of the file.
Result<std::unique_ptr<Stage>> open_stage(Device& device, const AssetRoots& roots, const Shot& shot,
                                          const std::filesystem::path& folder, Diagnostics& diagnostics,
                                          std::shared_ptr<Scene> moving = nullptr);

/// The lights that a shot starts with: its rig file, or the lights in the scene, or none, at the shot's frame; then its
/// settings. The materials are the scene's.
/// errors those of load_rig(), check_links() and set_path().
Result<ParamState> starting_state(const Stage& stage, const AssetRoots& roots, const Shot& shot,
                                  const std::filesystem::path& folder);

/// Lights at another frame: as their keys say, then the scene's own where the scene has them (follow_scene()), then as
/// the constraints say. from: a stage of the frame that they are at; to: one of the other. returns whether a light of
/// the scene went anywhere.
Result<bool> pose_lights(LightRig& rig, const Stage& from, const Stage& to, double frame);

/// What the shadow brush or eraser copies from. errors the renderer's. cost a picture.
Result<Image> render_shadow_picture(Renderer& renderer, const ParamState& lights, ShadowPicture which);

/// Warns of values that assignments put outside of their ranges.
void warn_of_ranges(const ParamState& state, const std::vector<std::string>& assignments, const SceneFrame& frame,
                    Diagnostics& diagnostics);

}  // namespace luminist
