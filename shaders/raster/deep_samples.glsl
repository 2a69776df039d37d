// The passes of a deep framebuffer as textures: layer 0 holds pixel centres, layers 1 to 4 the shifted samples.
layout(binding = 0) uniform sampler2DArray position_layers;  // w: 1 / depth
layout(binding = 1) uniform sampler2DArray normal_layers;
layout(binding = 2) uniform sampler2DArray albedo_layers;
layout(binding = 3) uniform sampler2DArray specular_layers;
layout(binding = 4) uniform sampler2DArray emissive_layers;
layout(binding = 5) uniform usampler2DArray id_layers;
layout(binding = 6) uniform usampler2DArray line_layers;
layout(binding = 7) uniform sampler2DArray stroke_layers;

uniform bool has_lines;
uniform bool has_strokes;

layout(std430, binding = 5) buffer EdgeOfPixel { uint edge_of_pixel[]; };

uniform uvec2 size;     // of the picture
uniform uint band_row;  // first row of the band that the textures hold, counted from the bottom
uniform uint band_rows;
uniform uint margin;  // rows of the textures below the band

// 1 + material, with the kind of a line in the upper four bits.
uint material_word(ivec3 texel) {
  uint word = texelFetch(id_layers, texel, 0).y;
  return has_lines ? word | texelFetch(line_layers, texel, 0).x << 28u : word;
}

// The band's pixel of an invocation: where it is in the textures, and its index in the picture (row 0 on top).
bool locate(uint index, out ivec2 texel, out uint pixel) {
  texel = ivec2(index % size.x, index / size.x);
  if (uint(texel.y) >= band_rows) return false;
  uint row = size.y - 1u - (band_row + uint(texel.y));
  texel.y += int(margin);
  pixel = row * size.x + uint(texel.x);
  return true;
}
