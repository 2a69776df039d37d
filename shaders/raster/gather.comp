// Copies the samples that will be shaded from the passes' textures into lists: pixel centres, then edge samples.
// Words are copied as integers, because an object index read as a float would be a denormal that a device may flush.
layout(std430, binding = 0) writeonly buffer Position { uvec4 position[]; };
layout(std430, binding = 1) writeonly buffer Normal { uvec4 normal[]; };
layout(std430, binding = 2) writeonly buffer Albedo { uvec4 albedo[]; };
layout(std430, binding = 3) writeonly buffer Specular { uvec4 specular[]; };
layout(std430, binding = 4) writeonly buffer Emissive { uvec4 emissive[]; };
layout(std430, binding = 6) writeonly buffer Stroke { vec4 stroke[]; };

const uint kNoEdge = 0xffffffffu;

void copy(ivec3 texel, uint sample_index) {
  uint object = texelFetch(id_layers, texel, 0).x;
  position[sample_index] = uvec4(floatBitsToUint(texelFetch(position_layers, texel, 0).xyz), object);
  normal[sample_index] = uvec4(floatBitsToUint(texelFetch(normal_layers, texel, 0).xyz), material_word(texel));
  albedo[sample_index] = floatBitsToUint(texelFetch(albedo_layers, texel, 0));
  specular[sample_index] = floatBitsToUint(texelFetch(specular_layers, texel, 0));
  emissive[sample_index] = floatBitsToUint(texelFetch(emissive_layers, texel, 0));
  if (has_strokes) stroke[sample_index] = texelFetch(stroke_layers, texel, 0);
}

void main() {
  ivec2 texel;
  uint pixel;
  if (!locate(linear_index(), texel, pixel)) return;
  copy(ivec3(texel, 0), pixel);
  uint edge = edge_of_pixel[pixel];
  if (edge == kNoEdge) return;
  for (int k = 0; k < 4; ++k) copy(ivec3(texel, k + 1), size.x * size.y + 4u * edge + uint(k));
}
