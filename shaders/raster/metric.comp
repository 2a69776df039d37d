// raster/metric.comp -- partial sums of I |T - R|. Every invocation adds its own pixels in a fixed order; the host adds
// the partial sums in order, so that the same picture gives the same bits.

layout(std430, binding = 0) readonly buffer Picture { vec4 picture[]; };
layout(std430, binding = 1) readonly buffer Wanted { vec4 wanted[]; };  // target, importance
layout(std430, binding = 2) writeonly buffer Sums { double sums[]; };   // [lanes]

uniform uint pixels;
uniform uint lanes;

void main() {
  uint lane = linear_index();
  if (lane >= lanes) return;
  double sum = 0.0lf;
  for (uint pixel = lane; pixel < pixels; pixel += lanes) {
    vec4 goal = wanted[pixel];
    if (goal.a == 0.0) continue;  // what does not count may be anything, not finite too
    sum += double(goal.a * length(goal.rgb - picture[pixel].rgb));
  }
  sums[lane] = sum;
}
