// Cel shading: every light cuts the surface into a bright and a dark region. Where a light does not reach at all (outside
// its barn or cutoffs) it adds nothing, with an edge as crisp as the others.

// Feathers of edges that a light draws itself, in shares of its light: narrower would alias.
const float kFootprintFeather = 0.08;  // a barn's edge is wide on the picture
const float kShadowFeather = 0.2;      // a shadow's edge is a few pixels

vec3 shade(Surface s) {
  vec3 sum = s.emissive + ambient() * s.albedo;
  for (int i = 0; i < light_count(); ++i) {
    LightSample l = light(i, s);
    if (l.shape <= 0.0) continue;
    vec3 source = l.color / l.shape;
    float footprint = soft_threshold(0.5, kFootprintFeather, l.shape);
    float facing = soft_threshold(style.threshold, style.feather, dot(s.normal, l.direction));
    // The shadow's edge is cut where half of the light is blocked; its density stays.
    float density = l.lit < 1.0 ? (1.0 - l.visibility) / (1.0 - l.lit) : 0.0;
    float seen = 1.0 - density * (1.0 - soft_threshold(0.5, kShadowFeather, l.lit));
    sum += s.albedo * source * (footprint * mix(style.dark, style.bright, facing * seen));
  }
  return sum;
}
