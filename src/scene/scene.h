#pragma once
// scene/scene.h -- everything that is in front of the camera, as data.
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/math.h"
#include "base/result.h"
#include "scene/animation.h"
#include "scene/deform.h"
#include "scene/material.h"
#include "scene/mesh.h"

namespace luminist {

/// A mesh with one material, placed in the world.
struct Object {
  std::string name;  ///< unique in the scene
  int mesh = 0;
  int material = 0;
  Mat4 world_from_object{1.0F};
  bool backdrop = false;  ///< an added floor or wall: not part of the scene's frame
  Mount mount = {};
  int shadow_mesh = -1;  ///< index of the mesh that blocks light in its stead; -1: its own
  int deformer = -1;     ///< what moves the vertices of its mesh, which is then no other object's; -1: nothing

  [[nodiscard]] int blocking_mesh() const { return shadow_mesh >= 0 ? shadow_mesh : mesh; }
};

/// A pinhole looking along -Z of its own frame, Y up.
struct Camera {
  std::string name;
  Mat4 world_from_camera{1.0F};
  float fov_y = 0.7F;  ///< radians
  float near_plane = 0.01F;
  float far_plane = 1000.0F;
  bool fitted_near = false;  ///< fit_clip_planes() has chosen it
  bool fitted_far = false;
  Mount mount = {};

  [[nodiscard]] Vec3 position() const { return Vec3(world_from_camera[3]); }
  /// Clip space with depth in [0,1].
  [[nodiscard]] Mat4 clip_from_world(float aspect) const;
};

/// A light as KHR_lights_punctual stores it; rig/punctual turns it into a light of the rig.
struct PunctualLight {
  enum class Kind { kPoint, kSpot, kSun };
  std::string name;
  Kind kind = Kind::kPoint;
  Vec3 color{1.0F};
  float intensity = 1.0F;  ///< candela, or lux for a sun
  float range = 0.0F;      ///< 0: none
  float inner_angle = 0.0F;
  float outer_angle = 0.785F;  ///< radians, half angle
  Vec3 position{0.0F};
  Vec3 direction{0.0F, 0.0F, -1.0F};
  Mount mount = {};

  [[nodiscard]] Mat4 world_from_light() const;  ///< it shines along -Z
};

struct Scene {
  std::vector<Mesh> meshes;
  std::vector<Material> materials;  ///< at least one
  std::vector<Texture> textures;
  std::vector<Object> objects;
  std::vector<Camera> cameras;  ///< at least one after load_scene()
  std::vector<PunctualLight> lights;
  Animation animation;
  std::vector<Deformer> deformers;
  std::optional<SceneFrame> rest_frame;  ///< of a scene that was posed

  /// World bounds of what is seen of the objects; without backdrops unless asked, or unless there is nothing else.
  [[nodiscard]] Box bounds(bool with_backdrop = false) const;
  /// World bounds of what blocks light, with backdrops.
  [[nodiscard]] Box shadow_bounds() const;
  [[nodiscard]] SceneFrame frame() const;
  [[nodiscard]] std::size_t triangle_count() const;
  [[nodiscard]] const Camera* find_camera(const std::string& name) const;
};

struct SceneOptions {
  bool floor = false;  ///< add a floor under the scene
  bool wall = false;   ///< add a wall behind it, seen from the automatic camera

  [[nodiscard]] bool operator==(const SceneOptions&) const = default;
};

/// Reads .gltf, .glb, .obj (with .mtl), .ply, .stl or .off. Missing normals are made smooth; a file without a camera
/// gets one that frames the objects (three-quarter view). NaN or index faults drop faces, with a warning.
/// errors kMissing; kBadContent naming file, position and field; kLimit above 20 M triangles.
Result<Scene> load_scene(const std::string& path, const SceneOptions& options, Diagnostics& diagnostics);

/// Writes a binary glTF with everything a Scene holds; textures become PNG. What deforms is written as it is posed.
/// errors kUnwritable.
Result<void> save_scene(const Scene& scene, const std::string& path);

}  // namespace luminist
