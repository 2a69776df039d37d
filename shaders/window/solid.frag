// A lamp beside the eye and a little of the sky, on both sides of every surface.
uniform vec3 eye;
uniform vec3 color;
in vec3 world_position;
in vec3 world_normal;
out vec4 code;

void main() {
  vec3 way = normalize(eye - world_position);
  vec3 normal = normalize(world_normal);
  if (dot(normal, way) < 0.0) normal = -normal;
  float lit = 0.10 + 0.38 * max(0.0, dot(normal, way)) + 0.10 * max(0.0, normal.y);
  code = vec4(pow(color * lit, vec3(1.0 / 2.2)), 1.0);
}
