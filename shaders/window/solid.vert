// The scene in the window's free view: plain, for turning it under the hand.
uniform mat4 clip_from_world;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
out vec3 world_position;
out vec3 world_normal;

void main() {
  world_position = position;
  world_normal = normal;
  gl_Position = clip_from_world * vec4(position, 1.0);
}
