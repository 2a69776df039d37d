// The cinematic light: a spot after Barzel, "Lighting Controls for Computer Cinematography" (1997). Its distance
// falloff is finite at the light and 1 at falloff_distance whatever the exponent.
LightSample sample_cinematic(Cinematic light, Surface s) {
  vec3 to_light = light.position - s.position;
  float r = length(to_light);
  vec3 direction = safe_normalize(to_light, s.normal);

  vec3 axis = safe_normalize(light.direction, vec3(0.0, 0.0, -1.0));
  vec3 right;
  vec3 up;
  light_frame(axis, right, up);
  float ahead = -dot(direction, axis);
  float shape = 0.0;
  if (ahead > 1e-4) {
    vec2 tangent = -vec2(dot(direction, right), dot(direction, up)) / ahead;
    shape = superellipse(tangent, light.barn.xy, light.barn.z);
    shape *= ramp_up(light.near_cutoff.x, light.near_cutoff.y, r);
    shape *= 1.0 - ramp_up(light.far_cutoff.x, light.far_cutoff.y, r);
  }
  float strength = shape * distance_falloff(r, light.falloff_distance, light.falloff_exponent);
  return unshadowed(direction, light.color * strength, shape);
}
