// raster/resolve.comp -- samples to pixels: a pixel on an edge is the mean of its own four samples.
layout(std430, binding = 0) readonly buffer Colors { vec4 colors[]; };  // first the pixels' centres, then four per edge
layout(std430, binding = 1) readonly buffer Edges { uint edge_of_pixel[]; };  // NONE: not on an edge
layout(std430, binding = 2) writeonly buffer Picture { vec4 picture[]; };
layout(std430, binding = 3) buffer Bad { uint bad_pixels; };

uniform uint pixels;
const uint NONE = 0xFFFFFFFFu;

void main() {
  uint pixel = linear_index();
  if (pixel >= pixels) return;
  uint edge = edge_of_pixel[pixel];
  vec3 color = colors[pixel].rgb;
  if (edge != NONE) {
    uint first = pixels + 4u * edge;
    color = 0.25 * (colors[first].rgb + colors[first + 1u].rgb + colors[first + 2u].rgb + colors[first + 3u].rgb);
  }
  // Comparing bits: an optimizer may assume that floats are never NaN.
  uvec3 exponent = floatBitsToUint(color) & 0x7F800000u;
  if (any(equal(exponent, uvec3(0x7F800000u)))) {
    color = vec3(0.0);
    atomicAdd(bad_pixels, 1u);
  }
  picture[pixel] = vec4(color, 1.0);
}
