// lib/helpers.glsl -- arithmetic that stays finite for any parameter, since a solver may leave the ranges.

const float kTiny = 1e-6;

float saturate(float x) { return clamp(x, 0.0, 1.0); }

float luminance(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); }

// v / |v|, or the fallback where v has no direction.
vec3 safe_normalize(vec3 v, vec3 fallback) {
  float length_squared = dot(v, v);
  return length_squared > 1e-24 && length_squared < 1e24 ? v * inversesqrt(length_squared) : fallback;
}

// 0 up to start, 1 from start + width, smooth between; a width <= 0 is a step.
float ramp_up(float start, float width, float x) {
  float t = saturate((x - start) / max(width, kTiny));
  return t * t * (3.0 - 2.0 * t);
}

// A threshold of a style: 0 below, 1 above, smooth within feather on either side. The solver widens it on its coarse
// levels (Softness::threshold), so that a step has a slope.
float soft_threshold(float threshold, float feather, float x) {
  float half_width = max(max(feather, lum_threshold_softness()), 1e-4);
  return ramp_up(threshold - half_width, 2.0 * half_width, x);
}

// How far dots and strokes have to give way to their mean tone, 0 to 1: the solver compares blurred pictures, and on few
// samples a pattern would be noise.
float pattern_fade() { return lum_pattern_fade(); }

// Share of a light that passes a barn door: a superellipse |x/w|^4 + |y/h|^4 = 1 in the plane at distance 1, full
// inside size, none outside size + edge, smooth along the ray from the centre (Barzel 1997, section 3.2).
float superellipse(vec2 point, vec2 size, float edge) {
  vec2 inner_size = max(size, vec2(1e-4));
  vec2 outer_size = max(size + max(max(edge, lum_light_edge_softness()), 1e-4), inner_size * 1.0001);
  vec2 inner = point / inner_size;
  vec2 outer = point / outer_size;
  inner *= inner;
  outer *= outer;
  float n_inner = min(sqrt(length(inner)), 1e6);  // 1 on the inner curve
  float n_outer = sqrt(length(outer));            // 1 on the outer curve
  if (n_inner <= 1.0) return 1.0;
  if (!(n_outer < 1.0)) return 0.0;
  return 1.0 - ramp_up(0.0, 1.0, n_outer * (n_inner - 1.0) / max(n_inner - n_outer, kTiny));
}

// The frame of a light that shines along axis (unit): right and up, up as near to the world's Y as can be. A frame
// cannot be continuous over all directions; straight down and straight up are kept regular, because lights often point
// there, and the singular direction lies about six degrees beside them, towards +Z.
void light_frame(vec3 axis, out vec3 right, out vec3 up) {
  float steepness = 1.0 - dot(axis.xz, axis.xz);
  float bias = 0.1 * smoothstep(0.96, 1.0, steepness);
  vec3 across = vec3(-axis.z, 0.0, axis.x) + bias * (vec3(1.0, 0.0, 0.0) - axis.x * axis);
  right = safe_normalize(across, vec3(1.0, 0.0, 0.0));
  up = cross(right, axis);
}

// Fading with distance: 2^(e/2) at the light, 1 at the reference distance, as distance^-e far away.
float distance_falloff(float r, float reference, float exponent) {
  float ratio = min(r / max(abs(reference), kTiny), 1e6);
  return exp2(clamp(0.5 * exponent * log2(2.0 / (1.0 + ratio * ratio)), -40.0, 40.0));
}
