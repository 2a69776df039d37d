#pragma once
// studio/free_view.h -- the shot from anywhere: the same scene, style and lights, seen by a camera that is not the
// shot's.
#include <memory>

#include "studio/solid_scene.h"
#include "studio/stage.h"

namespace luminist {

class PathRenderer;
class RasterRenderer;

/// Obtained by ShotView::from_anywhere(). thread the device's.
class FreeView {
 public:
  /// Reads the scene at the shot's frame. device outlives the view. errors those of open_stage().
  static Result<std::unique_ptr<FreeView>> open(Device& device, const AssetRoots& roots, const Shot& shot,
                                                const std::filesystem::path& folder, Diagnostics& diagnostics);
  ~FreeView();

  /// Its triangles, which stay when the view goes.
  [[nodiscard]] const std::shared_ptr<const SolidScene>& solid() const { return solid_; }
  /// Clip planes around the scene, whatever those of the camera are. A path tracer takes at most kPaths samples a
  /// pixel. errors the renderer's. cost a picture, and a few passes over the triangles where the camera or the size is
  /// another than before.
  Result<Image> picture(const Camera& camera, int width, int height, const ParamState& lights);
  static constexpr double kPaths = 8.0;
  /// Gives back what pictures need besides the scene: several hundred bytes a pixel, or what rays are traced in. The
  /// next one costs as much as the first.
  void put_away();

 private:
  FreeView(Device& device, AssetRoots roots);
  Result<void> look_from(const Camera& camera, int width, int height);

  Device* device_;
  AssetRoots roots_;
  Scene scene_;
  LightTypes types_;
  Style style_;
  std::shared_ptr<const SolidScene> solid_;
  std::unique_ptr<RasterRenderer> raster_;
  std::unique_ptr<PathRenderer> paths_;
  Camera camera_;
  int width_ = 0;
  int height_ = 0;
};

/// A camera at a place that looks at another one, up as the world is. fov_y in radians. The two differ.
Camera camera_at(const Vec3& from, const Vec3& at, float fov_y);

}  // namespace luminist
