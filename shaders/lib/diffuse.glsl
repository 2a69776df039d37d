// lib/diffuse.glsl -- what a white diffuser would show, for styles that turn all light into one tone.

// The sum over all lights and the ambient.
vec3 diffuse_light(Surface s) {
  vec3 sum = ambient();
  for (int i = 0; i < light_count(); ++i) {
    LightSample l = light(i, s);
    sum += l.color * l.visibility * max(dot(s.normal, l.direction), 0.0);
  }
  return sum;
}
