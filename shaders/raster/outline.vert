// A vertex of a hull: moved along its direction as far as the line is wide there, and a little away from the eye.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 direction;
layout(location = 2) in float share;

uniform mat4 clip_from_world;  // with the shift of the pass
uniform mat4 world_from_object;
uniform mat3 normal_from_object;  // inverse transpose, not normalized
uniform vec3 eye;
uniform float width;            // world, at the depth of reference
uniform float reference_depth;
uniform float growth;  // exponent of the width with depth: 1 keeps it on the picture, 0 in the world
uniform float push;

out vec3 world_position;
out vec3 world_direction;

void main() {
  vec3 world = (world_from_object * vec4(position, 1.0)).xyz;
  vec3 turned = normal_from_object * direction;
  float stretch = length(turned);
  world_direction = stretch > 0.0 ? turned / stretch : vec3(0.0);
  float depth = max((clip_from_world * vec4(world, 1.0)).w, 1e-4 * reference_depth);
  float here = share * width * pow(depth / reference_depth, growth);
  vec3 away = world - eye;
  world += here * (length(direction) * world_direction + push * away / max(length(away), 1e-12));
  world_position = world;
  gl_Position = clip_from_world * vec4(world, 1.0);
}
