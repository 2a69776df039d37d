#include "scene/scene.h"

#include <glm/gtc/matrix_transform.hpp>

namespace luminist {
namespace {

void extend(Box& box, const Mesh& mesh, const Mat4& world_from_object) {
  for (const Vec3& p : mesh.positions) box.extend(Vec3(world_from_object * Vec4(p, 1.0F)));
}

Box bounds_of(const Scene& scene, bool backdrops, bool others) {
  Box box;
  for (const Object& object : scene.objects) {
    if (!(object.backdrop ? backdrops : others)) continue;
    extend(box, scene.meshes[static_cast<std::size_t>(object.mesh)], object.world_from_object);
  }
  return box;
}

}  // namespace

Mat4 Camera::clip_from_world(float aspect) const {
  return glm::perspectiveRH_ZO(fov_y, aspect, near_plane, far_plane) * glm::inverse(world_from_camera);
}

Mat4 PunctualLight::world_from_light() const {
  Vec3 x, y;
  tangent_frame(-direction, x, y);
  return {Vec4(x, 0.0F), Vec4(y, 0.0F), Vec4(-direction, 0.0F), Vec4(position, 1.0F)};
}

Box Scene::bounds(bool with_backdrop) const {
  const Box box = bounds_of(*this, with_backdrop, true);
  return box.empty() ? bounds_of(*this, true, false) : box;
}

Box Scene::shadow_bounds() const {
  Box box;
  for (const Object& object : objects) {
    extend(box, meshes[static_cast<std::size_t>(object.blocking_mesh())], object.world_from_object);
  }
  return box;
}

SceneFrame Scene::frame() const {
  if (rest_frame) return *rest_frame;
  const Box box = bounds();
  if (box.empty()) return {};
  const float radius = box.radius();
  return {box.center(), radius > 0.0F ? radius : 1.0F};
}

std::size_t Scene::triangle_count() const {
  std::size_t count = 0;
  for (const Object& object : objects) count += meshes[static_cast<std::size_t>(object.mesh)].triangles.size();
  return count;
}

const Camera* Scene::find_camera(const std::string& name) const {
  for (const Camera& camera : cameras) {
    if (camera.name == name) return &camera;
  }
  return nullptr;
}

}  // namespace luminist
