#include "paint/paint_view.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/check.h"
#include "base/files.h"

namespace luminist {
namespace {

constexpr float kSameSurface = 1e-4F;  // of the way to a place; see hidden()

}  // namespace

PaintView::PaintView(SurfaceRays rays, const Scene& scene, const Camera& camera, float aspect)
    : rays_(std::move(rays)),
      meshes_(&scene.meshes),
      world_from_camera_(camera.world_from_camera),
      camera_from_world_(glm::inverse(camera.world_from_camera)),
      eye_(camera.position()),
      slope_(std::tan(0.5F * camera.fov_y)),
      aspect_(aspect),
      near_(camera.near_plane),
      far_(camera.far_plane) {
  for (const Object& object : scene.objects) {
    mesh_of_.push_back(object.mesh);
    names_.push_back(object.name);
    places_.push_back(object.world_from_object);
  }
}

Result<PaintView> PaintView::create(const Scene& scene, const Camera& camera, float aspect) {
  LUM_CHECK(aspect > 0.0F, "a picture has an area");
  LUM_TRY(SurfaceRays rays, SurfaceRays::create(scene));
  return PaintView(std::move(rays), scene, camera, aspect);
}

Result<int> PaintView::object(const std::string& name) const {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (names_[i] == name) return static_cast<int>(i);
  }
  const std::string near = nearest_name(name, names_);
  return Error{ErrorKind::kBadContent, fmt::format("there is no object \"{}\"", name), "", "clip",
               near.empty() ? "" : fmt::format("did you mean \"{}\"?", near)};
}

std::size_t PaintView::triangles(int object) const {
  return (*meshes_)[static_cast<std::size_t>(mesh_of_[static_cast<std::size_t>(object)])].triangles.size();
}

std::array<Vec3, 3> PaintView::corners(int object, std::uint32_t triangle) const {
  const Mesh& mesh = (*meshes_)[static_cast<std::size_t>(mesh_of_[static_cast<std::size_t>(object)])];
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

RayHit PaintView::at(const StrokePoint& point, int only) const {
  const float x = (point.x - 0.5F * aspect_) * 2.0F * slope_;
  const float y = (0.5F - point.y) * 2.0F * slope_;
  // One step along the way is one unit of depth.
  return rays_.first({eye_, Vec3(world_from_camera_ * Vec4(x, y, -1.0F, 0.0F)), near_, far_}, only);
}

std::optional<PicturePlace> PaintView::place_of(const Vec3& world) const {
  const Vec3 p(camera_from_world_ * Vec4(world, 1.0F));
  const float depth = -p.z;
  if (!(depth >= near_ && depth <= far_)) return std::nullopt;
  const float height = height_at(depth);
  return PicturePlace{{0.5F * aspect_ + p.x / height, 0.5F - p.y / height}, height};
}

bool PaintView::hidden(const Vec3& world, int only) const {
  const Vec3 way = world - eye_;
  const float depth = -(camera_from_world_ * Vec4(world, 1.0F)).z;
  return rays_.first({eye_, way, near_ / depth, 1.0F - kSameSurface}, only).hit();
}

}  // namespace luminist
