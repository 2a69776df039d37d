// The sun: parallel rays, as strong everywhere.
LightSample sample_sun(Sun light, Surface s) {
  vec3 axis = safe_normalize(light.direction, vec3(0.0, -1.0, 0.0));
  return unshadowed(-axis, light.color, 1.0);
}
