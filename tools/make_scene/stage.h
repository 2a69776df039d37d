#pragma once
// make_scene/stage.h -- puts a scene together: names, indices and the rounding that makes files repeatable.
#include <string>

#include "scene/scene.h"

namespace luminist {

class Stage {
 public:
  /// Index of the new texture, for a Material.
  int add_texture(const std::string& name, Image image);
  int add_material(Material material);
  int add_plain(const std::string& name, const Vec3& color, float roughness, float metallic = 0.0F);
  /// A material whose colour is a picture; relief: the texture of its normals, -1 for none.
  int add_textured(const std::string& name, Image picture, float roughness, int relief = -1);
  /// Coordinates are rounded to 2^-17, normals to 2^-14: a last bit that differs between mathematical libraries is gone
  /// from the file.
  int add_mesh(Mesh mesh);
  void add_object(const std::string& name, int mesh, int material, const Mat4& world_from_object = Mat4(1.0F));
  void add_object(const std::string& name, Mesh mesh, int material, const Mat4& world_from_object = Mat4(1.0F));
  /// The object added last is no part of the scene's frame (a wall, a floor).
  void mark_backdrop();
  void add_camera(const std::string& name, const Vec3& eye, const Vec3& look_at, float fov_y);
  Scene take() { return std::move(scene_); }

 private:
  Scene scene_;
};

}  // namespace luminist
