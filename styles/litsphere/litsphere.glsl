// What a light adds is looked up by the normal: in a few texels over how far it faces the light and the eye (Barla et al.
// 2006), in a picture of a sphere that turns with the light (Sloan et al. 2001), or between the two.
const int kAcross = 4;  // texels from facing away to facing the light
const int kRows = 3;    // from the rim to facing the eye

// Sums of steps, one between any two texels, so that the solver can widen them as it does thresholds.
void weigh(int count, float x, out float weights[4]) {
  float half_width = max(0.5 * (1.0 - style.steepness) / float(count), 0.004);
  float passed = 1.0;
  for (int k = 0; k < 4; ++k) {
    float next = k + 1 < count ? soft_threshold(float(k + 1) / float(count), half_width, x) : 0.0;
    weights[k] = passed - next;
    passed = next;
  }
}

// facing: 0 away from the light, 1 towards it. front: 0 at the rim, 1 towards the eye.
vec3 texel(float facing, float front) {
  float across[4];
  float rows[4];
  weigh(kAcross, facing, across);
  weigh(kRows, front, rows);
  vec3 rim = across[0] * style.rim_1 + across[1] * style.rim_2 + across[2] * style.rim_3 + across[3] * style.rim_4;
  vec3 side = across[0] * style.side_1 + across[1] * style.side_2 + across[2] * style.side_3 + across[3] * style.side_4;
  vec3 front_row =
      across[0] * style.front_1 + across[1] * style.front_2 + across[2] * style.front_3 + across[3] * style.front_4;
  return rows[0] * rim + rows[1] * side + rows[2] * front_row;
}

// v turned by the shortest way that takes `from` to `to`, both unit; any way where they are opposite.
vec3 turned(vec3 v, vec3 from, vec3 to) {
  vec3 axis = cross(from, to);
  vec3 across = cross(axis, v);
  return v + across + cross(axis, across) / max(1.0 + dot(from, to), 1e-3);
}

// The sphere's picture at a place of its disc, half a texel inside its rim.
vec3 sphere_at(vec2 place) {
  float radius = 0.5 - 1.0 / float(textureSize(sphere, 0).y);
  return textureLod(sphere, 0.5 + radius * vec2(place.x, -place.y), 0.0).rgb;
}

// The point of the picture's rim that lies farthest from the light that it was painted in.
vec3 sphere_away(vec3 painted_from) {
  return sphere_at(-safe_normalize(vec3(painted_from.xy, 0.0), vec3(0.0, 1.0, 0.0)).xy);
}

// The sphere as if it had been painted in this light: seen along the eye's ray, turned with the light. What was turned
// to the back of the picture, which nobody painted, goes from the rim's colour to that of the side away from the light.
vec3 painted(Surface s, vec3 to_light, vec3 painted_from) {
  vec3 right;
  vec3 up;
  light_frame(-s.view, right, up);
  mat3 eye = mat3(right, up, s.view);
  vec3 place = turned(s.normal * eye, to_light * eye, painted_from);
  if (place.z >= 0.0) return sphere_at(place.xy);
  vec2 rim = safe_normalize(vec3(place.xy, 0.0), vec3(0.0, -1.0, 0.0)).xy;
  float sine = sqrt(max(1.0 - painted_from.z * painted_from.z, 0.0));
  return mix(sphere_at(rim), sphere_away(painted_from), ramp_up(0.0, max(sine, 0.1), -place.z));
}

vec3 shade(Surface s) {
  vec3 painted_from = safe_normalize(style.painted_from, vec3(0.0, 0.0, 1.0));
  // A metal's own colour is what it mirrors with.
  vec3 surface = mix(vec3(1.0), max(s.albedo, s.specular), style.albedo);
  vec3 sum = s.emissive + ambient() * s.albedo;
  float front = max(dot(s.normal, s.view), 0.0);
  vec3 away = mix(texel(0.0, front), sphere_away(painted_from), style.painting);
  for (int i = 0; i < light_count(); ++i) {
    LightSample l = light(i, s);
    if (l.color == vec3(0.0)) continue;
    vec3 lit = mix(texel(0.5 + 0.5 * dot(s.normal, l.direction), front), painted(s, l.direction, painted_from),
                   style.painting);
    vec3 blocked = mix(lit, away, style.shadow);
    sum += surface * l.color * mix(blocked, lit, l.visibility);
  }
  return sum;
}
