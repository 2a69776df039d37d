// Cel shading: every light cuts the surface into a dark region and bands that get brighter towards it. Where a light
// does not reach at all (outside its barn or cutoffs) it adds nothing, with an edge as crisp as the others.

// Feathers of edges that a light draws itself, in shares of its light: narrower would alias.
const float kFootprintFeather = 0.08;  // a barn's edge is wide on the picture
const float kShadowFeather = 0.2;      // a shadow's edge is a few pixels
const float kLeadFeather = 0.03;       // of two lights' sum, where the stronger one takes over

// Words of style.combine.
const int kStrongest = 1;
const int kKey = 2;

// 0 in the dark region, 1 in the brightest band.
float tone(float cosine) {
  float sum = soft_threshold(style.threshold, style.feather, cosine);
  if (style.bands > 1) sum += soft_threshold(style.threshold_2, style.feather_2, cosine);
  if (style.bands > 2) sum += soft_threshold(style.threshold_3, style.feather_3, cosine);
  if (style.bands > 3) sum += soft_threshold(style.threshold_4, style.feather_4, cosine);
  return sum / float(clamp(style.bands, 1, 4));
}

float highlight(Surface s, vec3 to_light) {
  vec3 halfway = safe_normalize(to_light + s.view, s.normal);
  float sine = length(cross(s.normal, halfway));
  return dot(s.normal, to_light) > 0.0
             ? 1.0 - soft_threshold(style.highlight_size, style.highlight_feather, sine)
             : 0.0;
}

// Along silhouettes, and fading over the side that faces away, so that every light draws the rim on its own side.
float rim(Surface s, float cosine) {
  float edge = soft_threshold(1.0 - style.rim_width, style.rim_feather, 1.0 - max(dot(s.normal, s.view), 0.0));
  return edge * soft_threshold(0.0, style.rim_feather, cosine);
}

// What one light draws.
vec3 drawn_by(LightSample l, Surface s) {
  if (l.shape <= 0.0) return vec3(0.0);
  vec3 source = l.color / l.shape;
  float footprint = soft_threshold(0.5, kFootprintFeather, l.shape);
  float cosine = dot(s.normal, l.direction);
  // The shadow's edge is cut where half of the light is blocked; its density stays.
  float density = l.lit < 1.0 ? (1.0 - l.visibility) / (1.0 - l.lit) : 0.0;
  float seen = 1.0 - density * (1.0 - soft_threshold(0.5, kShadowFeather, l.lit));
  // A cast shadow shows on what would be bright; what faces away is dark anyway.
  float facing = soft_threshold(style.threshold, style.feather, cosine);
  vec3 blocked = mix(style.dark, style.shadow, facing);
  vec3 lit = mix(style.dark, style.bright, tone(cosine));
  vec3 glints = style.highlight * highlight(s, l.direction) + style.rim * rim(s, cosine);
  return source * footprint * (s.albedo * mix(blocked, lit, seen) + seen * glints);
}

vec3 shade(Surface s) {
  vec3 below = s.emissive + ambient() * s.albedo;
  vec3 sum = vec3(0.0);
  vec3 first = vec3(0.0);
  vec3 second = vec3(0.0);
  for (int i = 0; i < light_count(); ++i) {
    LightSample l = light(i, s);
    if (style.combine == kKey && !l.key) continue;
    vec3 drawn = drawn_by(l, s);
    sum += drawn;
    bool leads = luminance(drawn) > luminance(first);
    if (leads || luminance(drawn) > luminance(second)) second = leads ? first : drawn;
    if (leads) first = drawn;
  }
  if (style.combine != kStrongest) return below + sum;
  // The lead changes hands over a short way, so that its edge is as smooth as the others.
  float lead = luminance(first - second) / max(luminance(first + second), 1e-6);
  return below + mix(second, first, soft_threshold(0.0, kLeadFeather, lead));
}
