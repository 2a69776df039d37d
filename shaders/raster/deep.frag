// What is visible at a sample: geometry and the glTF metallic-roughness material, ready for shading.
in vec3 world_position;
in vec3 world_normal;
in vec2 texture_uv;
in vec4 world_tangent;
in vec2 stroke_place;

uniform vec3 eye;
uniform float side;  // -1 for an object that is mirrored: its triangles wind the other way
uniform uvec2 ids;   // 1 + object, 1 + material
uniform vec3 base_color;
uniform float metallic;
uniform float roughness;
uniform float specular;
uniform vec3 emissive;
uniform float normal_scale;
uniform float heights_per_pixel;

layout(binding = 0) uniform sampler2D base_color_texture;
layout(binding = 1) uniform sampler2D metallic_roughness_texture;
layout(binding = 2) uniform sampler2D normal_texture;
layout(binding = 3) uniform sampler2D emissive_texture;
uniform bool has_base_color_texture;
uniform bool has_metallic_roughness_texture;
uniform bool has_normal_texture;
uniform bool has_emissive_texture;

layout(location = 0) out vec4 out_position;  // w: 1 / depth, linear in the picture on a plane
layout(location = 1) out vec4 out_normal;
layout(location = 2) out vec4 out_albedo;
layout(location = 3) out vec4 out_specular;
layout(location = 4) out vec4 out_emissive;
layout(location = 5) out uvec2 out_ids;
layout(location = 6) out vec4 out_stroke;

const float kDielectric = 0.04;  // reflectance of everything that is no metal (glTF 2.0, appendix B)

vec3 mapped_normal(vec3 n) {
  vec3 t = world_tangent.xyz - n * dot(n, world_tangent.xyz);
  if (!has_normal_texture || dot(t, t) < 1e-12) return n;
  t = normalize(t);
  vec3 b = cross(n, t) * world_tangent.w;
  vec3 m = texture(normal_texture, texture_uv).xyz * 2.0 - 1.0;
  return normalize(t * m.x * normal_scale + b * m.y * normal_scale + n * max(m.z, 1e-3));
}

// The triangle's side that is seen decides the sign, exactly; what an interpolated or mapped normal then still leans
// away from the eye is bent back to the silhouette.
vec3 facing_normal() {
  vec3 to_eye = normalize(eye - world_position);
  if (!(dot(world_normal, world_normal) > 0.0)) return to_eye;  // a degenerate corner of a mesh
  vec3 n = mapped_normal(normalize(world_normal));
  n *= gl_FrontFacing ? side : -side;
  float away = min(dot(n, to_eye) - 1e-3, 0.0);
  return normalize(n - away * to_eye);
}

void main() {
  vec3 base = base_color;
  float metal = metallic;
  float rough = roughness;
  vec3 glow = emissive;
  if (has_base_color_texture) base *= texture(base_color_texture, texture_uv).rgb;
  if (has_metallic_roughness_texture) {
    vec2 roughness_metallic = texture(metallic_roughness_texture, texture_uv).gb;
    rough *= roughness_metallic.x;
    metal *= roughness_metallic.y;
  }
  if (has_emissive_texture) glow *= texture(emissive_texture, texture_uv).rgb;

  out_position = vec4(world_position, gl_FragCoord.w);
  out_normal = vec4(facing_normal(), 0.0);
  out_albedo = vec4(base * (1.0 - metal), rough);
  float dielectric = kDielectric * specular;
  out_specular = vec4(mix(vec3(dielectric), base, metal), dielectric * (1.0 - metal));
  out_emissive = vec4(glow, 0.0);
  out_ids = ids;
  vec2 across = dFdx(stroke_place);
  vec2 down = dFdy(stroke_place);
  out_stroke = vec4(stroke_place, length(vec2(across.x, down.x)), length(vec2(across.y, down.y)));
  out_stroke.zw /= heights_per_pixel;
}
