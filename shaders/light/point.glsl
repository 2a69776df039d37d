// A point light: the cinematic light's distance controls, no axis.
LightSample sample_point(Point light, Surface s) {
  vec3 to_light = light.position - s.position;
  float r = length(to_light);
  float shape = 1.0 - ramp_up(light.far_cutoff.x, light.far_cutoff.y, r);
  float strength = shape * distance_falloff(r, light.falloff_distance, light.falloff_exponent);
  return unshadowed(safe_normalize(to_light, s.normal), light.color * strength, shape);
}
