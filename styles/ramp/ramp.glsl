// The lookup is a sum of steps, one between any two texels, so that the solver can widen them as it does thresholds.
const int kSteps = 5;  // between six texels

vec3 ramp(float x) {
  float half_width = 0.5 * (1.0 - style.steepness) / float(kSteps + 1);
  vec3 steps[kSteps] = vec3[](style.texel_2 - style.texel_1, style.texel_3 - style.texel_2,
                              style.texel_4 - style.texel_3, style.texel_5 - style.texel_4,
                              style.texel_6 - style.texel_5);
  vec3 color = style.texel_1;
  for (int k = 0; k < kSteps; ++k) {
    color += steps[k] * soft_threshold(float(k + 1) / float(kSteps + 1), max(half_width, 0.004), x);
  }
  return color;
}

vec3 shade(Surface s) {
  vec3 sum = s.emissive + ambient() * s.albedo;
  for (int i = 0; i < light_count(); ++i) {
    LightSample l = light(i, s);
    float facing = 0.5 + 0.5 * dot(s.normal, l.direction);
    // Two lookups and no way between them: a shadow's soft edge must not run through all texels.
    vec3 color = mix(ramp(facing * (1.0 - style.shadow)), ramp(facing), l.visibility);
    sum += s.albedo * l.color * color;
  }
  return sum;
}
