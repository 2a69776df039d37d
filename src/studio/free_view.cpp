#include "studio/free_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "raster/raster_renderer.h"
#include "trace/path_renderer.h"

namespace luminist {
namespace {

/// Around everything that is drawn, with depths as fine as they can be.
void fit_planes(const Box& bounds, Camera& camera) {
  const float radius = std::max(0.5F * glm::length(bounds.hi - bounds.lo), 1e-3F);
  const float away = glm::length(0.5F * (bounds.lo + bounds.hi) - camera.position());
  camera.far_plane = 1.05F * (away + radius);
  camera.near_plane = std::max(0.002F * radius, 0.95F * (away - radius));
}

bool same_view(const Camera& one, const Camera& other) {
  return one.world_from_camera == other.world_from_camera && one.fov_y == other.fov_y;
}

}  // namespace

Result<std::unique_ptr<FreeView>> FreeView::open(Device& device, const AssetRoots& roots, const Shot& shot,
                                                 const std::filesystem::path& folder, Diagnostics& diagnostics) {
  std::unique_ptr<FreeView> view(new FreeView(device, roots));
  LUM_TRY(view->style_, load_whole_style(roots, shot.style));
  LUM_TRY(view->types_, LightTypes::load(roots));
  LUM_TRY(const std::string path, find_input(shot.scene, folder, roots));
  LUM_TRY(view->scene_, load_scene(path, shot.scene_options, diagnostics));
  pose(view->scene_, shot.seconds());
  view->solid_ = std::make_shared<const SolidScene>(solid_scene(view->scene_));
  return view;
}

FreeView::FreeView(Device& device, AssetRoots roots) : device_(&device), roots_(std::move(roots)) {}
FreeView::~FreeView() = default;

Result<void> FreeView::look_from(const Camera& camera, int width, int height) {
  const bool there = raster_ || paths_;
  if (there && same_view(camera, camera_) && width == width_ && height == height_) return {};
  Camera fitted = camera;
  fit_planes(scene_.bounds(true), fitted);
  width_ = 0;  // nothing can be drawn until this has gone well
  if (style_.engine == StyleEngine::kPath) {
    LUM_TRY(paths_, PathRenderer::create(scene_, fitted, style_, width, height));
  } else if (raster_) {
    auto looked = raster_->look_from(scene_, fitted, roots_, width, height);
    if (!looked) {
      raster_.reset();
      return looked;
    }
  } else {
    LUM_TRY(raster_, RasterRenderer::create(*device_, scene_, fitted, types_, style_, roots_, width, height));
  }
  camera_ = camera;
  width_ = width;
  height_ = height;
  return {};
}

void FreeView::put_away() {
  raster_.reset();
  paths_.reset();
}

Result<Image> FreeView::picture(const Camera& camera, int width, int height, const ParamState& lights) {
  LUM_TRY_VOID(look_from(camera, width, height));
  if (raster_) return raster_->render(lights);
  ParamState quick = lights;
  if (const auto samples = quick.style.schema().by_role("samples")) {
    quick.style.set(*samples, 0, std::min(quick.style.get(*samples, 0), kPaths));
  }
  return paths_->render(quick);
}

Camera camera_at(const Vec3& from, const Vec3& at, float fov_y) {
  const Vec3 back = unit_direction(from - at).value_or(Vec3(0.0F, 0.0F, 1.0F));
  // Straight from above, north is up.
  const Vec3 up = std::abs(back.y) > 0.9999F ? Vec3(0.0F, 0.0F, -1.0F) : Vec3(0.0F, 1.0F, 0.0F);
  const Vec3 right = glm::normalize(glm::cross(up, back));
  Camera camera;
  camera.fov_y = fov_y;
  camera.world_from_camera =
      Mat4(Vec4(right, 0.0F), Vec4(glm::cross(back, right), 0.0F), Vec4(back, 0.0F), Vec4(from, 1.0F));
  return camera;
}

}  // namespace luminist
