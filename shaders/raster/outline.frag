// A sample of a line. The normal of a silhouette is the one that the surface has there, so that lines can be lit.
in vec3 world_position;
in vec3 world_direction;

uniform vec3 eye;
uniform uvec2 ids;  // 1 + object, 1 + material
uniform vec3 base_color;
uniform uint kind;  // LINE_... of shaders/lib/surface.glsl

layout(location = 0) out vec4 out_position;  // w: 1 / depth, linear in the picture on a plane
layout(location = 1) out vec4 out_normal;
layout(location = 2) out vec4 out_albedo;
layout(location = 3) out vec4 out_specular;
layout(location = 4) out vec4 out_emissive;
layout(location = 5) out uvec2 out_ids;
layout(location = 6) out vec4 out_stroke;

void main() {
  vec3 to_eye = normalize(eye - world_position);
  vec3 across = world_direction - (dot(world_direction, to_eye) - 0.02) * to_eye;
  float far = length(across);
  out_position = vec4(world_position, gl_FragCoord.w);
  out_normal = vec4(far > 1e-6 ? across / far : to_eye, 0.0);
  out_albedo = vec4(base_color, 1.0);
  out_specular = vec4(0.0);
  out_emissive = vec4(0.0);
  out_ids = uvec2(ids.x, ids.y | kind << 28u);
  out_stroke = vec4(0.0);
}
