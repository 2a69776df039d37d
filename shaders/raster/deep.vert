// A vertex of the scene, for the deep framebuffer.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 tangent;
layout(location = 4) in vec2 stroke;  // zero where the style has none

uniform mat4 clip_from_world;  // with the shift of the pass
uniform mat4 world_from_object;
uniform mat3 normal_from_object;  // inverse transpose, not normalized

uniform float radii_per_unit;  // scene radii of a unit of the mesh

out vec3 world_position;
out vec3 world_normal;
out vec2 texture_uv;
out vec4 world_tangent;
out vec2 stroke_place;

void main() {
  vec4 world = world_from_object * vec4(position, 1.0);
  world_position = world.xyz;
  world_normal = normal_from_object * normal;
  texture_uv = uv;
  stroke_place = radii_per_unit * stroke;
  world_tangent = vec4(mat3(world_from_object) * tangent.xyz, tangent.w);
  gl_Position = clip_from_world * vec4(world.xyz, 1.0);
}
