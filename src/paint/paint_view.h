#pragma once
// paint/paint_view.h -- a picture as what lies behind its points: from paint to the surface and back.
#include <optional>
#include <string>
#include <vector>

#include "base/math.h"
#include "paint/stroke.h"
#include "rays/surface_rays.h"
#include "scene/scene.h"

namespace luminist {

/// A place in the world on a picture.
struct PicturePlace {
  Vec2 point{0.0F};     ///< as a StrokePoint, in picture heights
  float height = 0.0F;  ///< of the whole picture there, in scene units: what a length of one picture height is
};

/// One camera on one scene as it stands when the view is made. Exact rays, no pixels: the size of the picture does not
/// matter, only its shape.
class PaintView {
 public:
  /// aspect: width / height of the picture. errors those of SurfaceRays::create().
  static Result<PaintView> create(const Scene& scene, const Camera& camera, float aspect);

  /// The object of that name. errors kBadContent with the nearest name.
  [[nodiscard]] Result<int> object(const std::string& name) const;
  [[nodiscard]] const std::string& name(int object) const { return names_[static_cast<std::size_t>(object)]; }
  [[nodiscard]] const Mat4& world_from(int object) const { return places_[static_cast<std::size_t>(object)]; }
  /// Corners in the object's frame. triangle < triangles(object).
  [[nodiscard]] std::array<Vec3, 3> corners(int object, std::uint32_t triangle) const;
  [[nodiscard]] std::size_t triangles(int object) const;

  /// What a point of the picture shows, of all objects or of one alone; the hit's distance is the depth.
  [[nodiscard]] RayHit at(const StrokePoint& point, int only = SurfaceRays::kAnyObject) const;
  /// Where a place of the world is on the picture, also beside it; nothing if it is not between the clip planes.
  [[nodiscard]] std::optional<PicturePlace> place_of(const Vec3& world) const;
  /// Whether something stands before that place, of all objects or of one alone. What lies within 1e-4 of the way
  /// before it belongs to the place: single precision and the facets of a mesh can not be told apart there.
  [[nodiscard]] bool hidden(const Vec3& world, int only = SurfaceRays::kAnyObject) const;
  /// What a picture height measures at a depth, in scene units.
  [[nodiscard]] float height_at(float depth) const { return 2.0F * slope_ * depth; }
  [[nodiscard]] const Vec3& eye() const { return eye_; }
  [[nodiscard]] float aspect() const { return aspect_; }

 private:
  PaintView(SurfaceRays rays, const Scene& scene, const Camera& camera, float aspect);

  SurfaceRays rays_;
  const std::vector<Mesh>* meshes_;  ///< the scene's
  std::vector<int> mesh_of_;         ///< [objects], as the rest
  std::vector<std::string> names_;
  std::vector<Mat4> places_;
  Mat4 world_from_camera_;
  Mat4 camera_from_world_;
  Vec3 eye_;
  float slope_;  ///< tangent of half the vertical angle
  float aspect_;
  float near_;
  float far_;
};

}  // namespace luminist
