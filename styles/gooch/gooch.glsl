// Tones between cool and warm (Gooch et al. 1998, section 4.1): all ways that a surface can turn get a tone of their
// own, also those that face away from the light.
vec3 shade(Surface s) {
  vec3 cool = style.cool + style.cool_albedo * s.albedo;
  vec3 warm = style.warm + style.warm_albedo * s.albedo;
  vec3 sum = s.emissive + ambient() * s.albedo;
  for (int i = 0; i < light_count(); ++i) {
    LightSample l = light(i, s);
    float cosine = dot(s.normal, l.direction);
    float blocked = 1.0 - l.visibility;
    float warmth = (0.5 + 0.5 * cosine) * (1.0 - style.shadow * blocked);
    vec3 mirrored = reflect(-l.direction, s.normal);
    float glint = pow(max(dot(mirrored, s.view), 0.0), max(style.shininess, 1.0)) * step(0.0, cosine);
    sum += l.color * (mix(cool, warm, warmth) + vec3(style.highlight * glint * l.visibility));
  }
  return sum;
}
