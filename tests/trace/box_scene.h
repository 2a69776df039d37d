#pragma once
// tests/trace/box_scene.h -- scenes of rectangles, whose light is known.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "rig/light_type.h"
#include "support/fixtures.h"
#include "trace/path_renderer.h"

namespace luminist {

/// A matte grey material, or what shines with that radiance.
inline Material matte(const Vec3& color, const Vec3& emissive = Vec3(0.0F)) {
  Material material;
  material.base_color = color;
  material.roughness = 1.0F;
  material.emissive = emissive;
  return material;
}

inline int add_material(Scene& scene, const Material& material) {
  scene.materials.push_back(material);
  return static_cast<int>(scene.materials.size()) - 1;
}

/// A rectangle that faces cross(along, up).
inline void add_rectangle(Scene& scene, const Vec3& corner, const Vec3& along, const Vec3& up, int material) {
  Mesh mesh;
  mesh.positions = {corner, corner + along, corner + along + up, corner + up};
  mesh.normals.assign(4, glm::normalize(glm::cross(along, up)));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  Object object;
  object.name = "rectangle-" + std::to_string(scene.objects.size());
  object.mesh = static_cast<int>(scene.meshes.size());
  object.material = material;
  scene.meshes.push_back(std::move(mesh));
  scene.objects.push_back(std::move(object));
}

/// The inside of the cube from (-1,-1,-1) to (1,1,1).
inline void add_cube(Scene& scene, int material) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0F, 1.0F}) {
      Vec3 corner(-1.0F);
      Vec3 along(0.0F);
      Vec3 up(0.0F);
      corner[axis] = side;
      along[(axis + 1) % 3] = 2.0F;
      up[(axis + 2) % 3] = 2.0F;
      add_rectangle(scene, corner, along, up, material);
    }
  }
}

/// Looks along -Z from a place.
inline Camera camera_at(const Vec3& place, float fov_y) {
  Camera camera;
  camera.world_from_camera[3] = Vec4(place, 1.0F);
  camera.fov_y = fov_y;
  camera.near_plane = 1e-4F;
  return camera;
}

/// Looks straight down from a place.
inline Camera camera_above(const Vec3& place, float fov_y) {
  Camera camera = camera_at(place, fov_y);
  camera.world_from_camera[1] = Vec4(0.0F, 0.0F, -1.0F, 0.0F);
  camera.world_from_camera[2] = Vec4(0.0F, 1.0F, 0.0F, 0.0F);
  return camera;
}

/// A path-traced shot without lights.
class PathShot {
 public:
  static Result<PathShot> create(Scene scene, const Camera& camera, int width, int height) {
    PathShot shot;
    LUM_TRY(shot.types_, LightTypes::load(AssetRoots::standard()));
    LUM_TRY(const Style style, load_style(AssetRoots::standard(), "path"));
    LUM_TRY(shot.renderer, PathRenderer::create(std::move(scene), camera, style, width, height));
    shot.state = std::make_unique<ParamState>(initial_state(shot.types_, style, shot.renderer->frame()));
    shot.set("ambient/color=0,0,0");
    shot.set("style/caustics=true");
    shot.set("style/clamp=0");
    return shot;
  }
  void set(const std::string& assignment) const { LUM_EXPECT_OK(set_path(*state, assignment)); }
  void add_light(const std::string& type, const std::string& name) const {
    auto light = make_light(types_, type, name, renderer->frame());
    ASSERT_TRUE(light) << light.error().message();
    state->rig.lights.push_back(std::move(light).value());
  }
  [[nodiscard]] Image picture() const {
    auto image = renderer->render(*state);
    EXPECT_TRUE(image) << (image ? "" : image.error().message());
    return image ? std::move(image).value() : Image(1, 1, 3);
  }

  std::unique_ptr<PathRenderer> renderer;
  std::unique_ptr<ParamState> state;

 private:
  PathShot() = default;
  LightTypes types_;
};

/// A glossy floor in a cube, and a mirror on the wall behind.
inline void add_floor_and_mirror(Scene& cube) {
  Material glossy = matte(Vec3(0.5F));
  glossy.roughness = 0.4F;
  glossy.metallic = 0.4F;
  cube.objects[2].material = add_material(cube, glossy);
  Material mirror = matte(Vec3(0.9F));
  mirror.roughness = 0.0F;
  mirror.metallic = 1.0F;
  add_rectangle(cube, {-0.2F, -0.5F, -0.99F}, {0.9F, 0.0F, 0.0F}, {0.0F, 1.1F, 0.0F}, add_material(cube, mirror));
}

/// A cube with coloured walls, a glossy floor, a mirror on the wall behind, and a panel under the ceiling.
inline Result<PathShot> small_room(int width, int height) {
  Scene scene;
  add_cube(scene, add_material(scene, matte(Vec3(0.7F))));
  scene.objects[0].material = add_material(scene, matte({0.7F, 0.15F, 0.1F}));
  scene.objects[1].material = add_material(scene, matte({0.15F, 0.6F, 0.2F}));
  add_floor_and_mirror(scene);
  add_rectangle(scene, {-0.8F, -0.4F, -0.6F}, {0.6F, 0.0F, 0.3F}, {0.0F, 0.1F, -0.4F},
                add_material(scene, matte({0.2F, 0.3F, 0.7F})));
  LUM_TRY(PathShot shot, PathShot::create(std::move(scene), camera_at({0.0F, 0.0F, 0.98F}, 1.5F), width, height));
  shot.add_light("area", "panel");
  shot.set("lights/panel/position=0.2,0.99,0");
  shot.set("lights/panel/size=0.5");
  shot.set("lights/panel/falloff_distance=1.5");
  return shot;
}

}  // namespace luminist
