// The passes of a deep framebuffer as textures: layer 0 holds pixel centres, layers 1 to 4 the shifted samples.
layout(binding = 0) uniform sampler2DArray position_layers;  // w: 1 / depth
layout(binding = 1) uniform sampler2DArray normal_layers;
layout(binding = 2) uniform sampler2DArray albedo_layers;
layout(binding = 3) uniform sampler2DArray specular_layers;
layout(binding = 4) uniform sampler2DArray emissive_layers;
layout(binding = 5) uniform usampler2DArray id_layers;

layout(std430, binding = 5) buffer EdgeOfPixel { uint edge_of_pixel[]; };

uniform uvec2 size;     // of the picture
uniform uint band_row;  // first row of the band that the textures hold, counted from the bottom
uniform uint band_rows;

// The band's pixel of an invocation: where it is in the textures, and its index in the picture (row 0 on top).
bool locate(uint index, out ivec2 texel, out uint pixel) {
  texel = ivec2(index % size.x, index / size.x);
  if (uint(texel.y) >= band_rows) return false;
  uint row = size.y - 1u - (band_row + uint(texel.y));
  pixel = row * size.x + uint(texel.x);
  return true;
}
