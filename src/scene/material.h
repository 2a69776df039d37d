#pragma once
// scene/material.h -- metallic-roughness materials as glTF 2.0 has them.
#include <string>

#include "base/image.h"
#include "base/math.h"

namespace luminist {

/// A picture on a surface. Colour textures are stored linear (decoded when loaded).
struct Texture {
  std::string name;
  Image image;           ///< 3 or 4 channels
  bool repeat_u = true;  ///< else clamped
  bool repeat_v = true;

  /// Red at a place of the picture, linear between the centres of its pixels; u to the right, v down. cost O(1).
  [[nodiscard]] float red_at(const Vec2& uv) const;
};

/// What everything that is no metal reflects head-on (glTF 2.0, appendix B).
inline constexpr float kDielectric = 0.04F;

/// Factors multiply textures; a texture index of -1 means none.
struct Material {
  std::string name;
  Vec3 base_color{0.8F};  ///< linear
  float metallic = 0.0F;
  float roughness = 0.5F;
  float specular = 1.0F;  ///< factor of kDielectric (KHR_materials_specular); may exceed 1
  Vec3 emissive{0.0F};
  float normal_scale = 1.0F;
  int base_color_texture = -1;
  int metallic_roughness_texture = -1;  ///< green: roughness, blue: metallic
  int normal_texture = -1;
  int emissive_texture = -1;
  int line_width_texture = -1;  ///< red: 0 to 1, share of an outline's width there
  bool double_sided = true;
};

}  // namespace luminist
