// A square panel that shines from one side, seen from afar: all light comes from its centre with the cosine of a flat
// emitter, and near it is limited as that of a disc of the same area is on its axis (form factor R^2 / (R^2 + r^2)).
LightSample sample_area(Area light, Surface s) {
  vec3 axis = safe_normalize(light.direction, vec3(0.0, -1.0, 0.0));
  vec3 to_light = light.position - s.position;
  float r2 = dot(to_light, to_light);
  vec3 direction = safe_normalize(to_light, s.normal);
  float ahead = max(-dot(direction, axis), 0.0);
  float disc2 = light.size * light.size / 3.14159265;
  float falloff = light.falloff_distance * light.falloff_distance / max(r2 + disc2, kTiny);
  return unshadowed(direction, light.color * (light.intensity * ahead * falloff), ahead > 0.0 ? 1.0 : 0.0);
}
