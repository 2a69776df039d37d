// Marks the pixels whose samples differ so much that one of them would alias.
const float kNormalCosine = 0.97;  // 14 degrees within a pixel: a crease, or a curve of a few pixels
const float kAlbedoStep = 0.3;     // of any channel
const float kDepthStep = 2.0;      // pixels' widths that the surface may leave its own plane by

uniform float pixel_angle;  // width of a pixel at distance 1

bool differs(ivec2 texel) {
  uvec2 id = texelFetch(id_layers, ivec3(texel, 0), 0).xy;
  for (int k = 1; k <= 4; ++k) {
    if (texelFetch(id_layers, ivec3(texel, k), 0).x != id.x) return true;
  }
  if (has_lines) {
    uint line = material_word(ivec3(texel, 0)) >> 28u;
    for (int k = 1; k <= 4; ++k) {
      if (material_word(ivec3(texel, k)) >> 28u != line) return true;
    }
    if (line != 0u) return false;  // lines are flat
  }
  if (id.x == 0u) return false;

  vec3 normal = texelFetch(normal_layers, ivec3(texel, 0), 0).xyz;
  vec3 albedo = texelFetch(albedo_layers, ivec3(texel, 0), 0).rgb;
  for (int k = 1; k <= 4; ++k) {
    if (dot(normal, texelFetch(normal_layers, ivec3(texel, k), 0).xyz) < kNormalCosine) return true;
    vec3 step_up = abs(albedo - texelFetch(albedo_layers, ivec3(texel, k), 0).rgb);
    if (max(step_up.x, max(step_up.y, step_up.z)) > kAlbedoStep) return true;
  }

  // 1 / depth is linear in the picture on a plane of any slope, and the samples lie opposite each other in pairs
  // (1, 4) and (2, 3): the second difference is what is left when the surface leaves its plane.
  float centre = texelFetch(position_layers, ivec3(texel, 0), 0).w;
  float pair_a = texelFetch(position_layers, ivec3(texel, 1), 0).w + texelFetch(position_layers, ivec3(texel, 4), 0).w;
  float pair_b = texelFetch(position_layers, ivec3(texel, 2), 0).w + texelFetch(position_layers, ivec3(texel, 3), 0).w;
  float bend = max(abs(pair_a - 2.0 * centre), abs(pair_b - 2.0 * centre));
  return bend > kDepthStep * pixel_angle * centre;
}

void main() {
  ivec2 texel;
  uint pixel;
  if (!locate(linear_index(), texel, pixel)) return;
  edge_of_pixel[pixel] = differs(texel) ? 1u : 0u;
}
