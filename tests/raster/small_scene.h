#pragma once
// tests/raster/small_scene.h -- a bumpy ball over a floor, two lights: enough to see shadows, highlights and edges.
#include <cmath>
#include <cstdint>
#include <string>

#include "base/math.h"
#include "render/param_state.h"
#include "scene/scene.h"

namespace luminist {

/// A ball of radius 1 around the origin with bumps of the given height, triangulated in rings.
inline Mesh bumpy_ball(int rings, float bump) {
  Mesh mesh;
  const int columns = 2 * rings;
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j < columns; ++j) {
      const float v = static_cast<float>(kPi) * static_cast<float>(i) / static_cast<float>(rings);
      const float u = 2.0F * static_cast<float>(kPi) * static_cast<float>(j) / static_cast<float>(columns);
      const float r = 1.0F + bump * std::sin(5.0F * u) * std::sin(v) * std::sin(6.0F * v);
      mesh.positions.push_back(r * Vec3(std::sin(v) * std::cos(u), std::cos(v), std::sin(v) * std::sin(u)));
    }
  }
  const auto at = [columns](int i, int j) { return static_cast<std::uint32_t>(i * columns + j % columns); };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < columns; ++j) {
      if (i > 0) mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      if (i < rings - 1) mesh.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  compute_normals(mesh, kPi);
  return mesh;
}

/// A horizontal square at height y.
inline Mesh floor_square(float half, float y) {
  Mesh mesh;
  mesh.positions = {{-half, y, -half}, {-half, y, half}, {half, y, half}, {half, y, -half}};
  mesh.normals.assign(4, Vec3(0.0F, 1.0F, 0.0F));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// A camera at `eye` that looks at `target`, Y up.
inline Camera camera_towards(const Vec3& eye, const Vec3& target) {
  const Vec3 back = glm::normalize(eye - target);
  const Vec3 right = glm::normalize(glm::cross(Vec3(0.0F, 1.0F, 0.0F), back));
  Camera camera;
  camera.name = "camera";
  camera.world_from_camera =
      Mat4(Vec4(right, 0.0F), Vec4(glm::cross(back, right), 0.0F), Vec4(back, 0.0F), Vec4(eye, 1.0F));
  camera.fov_y = 0.6F;
  return camera;
}

/// The ball (object 1, slightly shiny) and the floor (object 2, white and matte), seen from the front and above.
inline Scene small_scene(int rings = 48, float bump = 0.06F) {
  Scene scene;
  scene.meshes = {bumpy_ball(rings, bump), floor_square(6.0F, -1.1F)};
  Material clay;
  clay.name = "clay";
  clay.base_color = {0.8F, 0.55F, 0.4F};
  clay.roughness = 0.45F;
  Material white;
  white.name = "white";
  white.base_color = Vec3(0.9F);
  white.roughness = 1.0F;
  scene.materials = {clay, white};
  Object ball;
  ball.name = "ball";
  Object floor;
  floor.name = "floor";
  floor.mesh = 1;
  floor.material = 1;
  floor.backdrop = true;
  scene.objects = {ball, floor};
  scene.cameras = {camera_towards({0.0F, 2.2F, 6.5F}, {0.0F, -0.2F, 0.0F})};
  return scene;
}

/// A cinematic light at `position` that shines at `target`.
inline Light aimed_light(const LightTypes& types, const std::string& name, const SceneFrame& frame,
                         const Vec3& position, const Vec3& target, const Vec3& color) {
  Light light = make_light(types, "cinematic", name, frame).value();
  const ParamSchema& schema = light.params.schema();
  light.params.set_vec3(*schema.by_role("position"), position);
  light.params.set_vec3(*schema.by_role("direction"), glm::normalize(target - position));
  light.params.set_vec3(*schema.by_role("color"), color);
  return light;
}

/// A warm key from the right and a cool fill from the left.
inline ParamState small_state(const LightTypes& types, const Style& style, const SceneFrame& frame) {
  ParamState state = initial_state(types, style, frame);
  const Vec3 target(0.0F, -0.3F, 0.0F);
  state.rig.lights.push_back(aimed_light(types, "key", frame, {3.0F, 4.0F, 3.0F}, target, {1.0F, 0.9F, 0.75F}));
  state.rig.lights.push_back(aimed_light(types, "fill", frame, {-4.0F, 2.0F, 2.5F}, target, {0.2F, 0.3F, 0.5F}));
  return state;
}

}  // namespace luminist
