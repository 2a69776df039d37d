// Parameterized hatching (Praun et al. 2001) by thresholds (Webb et al. 2002): all lights together make a tone, and a place
// is inked where the map's threshold is below the tone's darkness. The level of detail is chosen so that strokes are as
// wide and as far apart on the picture wherever the surface is.

const float kLevels = 1.0;      // of light that leaves the paper white
const float kTexels = 512.0;    // of the map's finest level
const float kCoarsest = 4.0;    // level of the map
const float kToneRows = 33.0;   // of the tone table: eight for each level, and the last
const float kEdge = 0.04;       // thresholds within which a stroke's edge is smoothed; it is cut four times in a pixel

// The threshold up to which a darkness inks, so that mean ink is the darkness.
float inked_to(float darkness, float lod) {
  vec2 place = vec2((darkness * 255.0 + 0.5) / 256.0, (lod * 8.0 + 0.5) / kToneRows);
  if (style.strokes == 0) return textureLod(pencil_tone, place, 0.0).r;
  if (style.strokes == 1) return textureLod(pen_tone, place, 0.0).r;
  return textureLod(stipple_tone, place, 0.0).r;
}

float threshold_at(vec2 place, float lod) {
  if (style.strokes == 0) return textureLod(pencil, place, lod).r;
  if (style.strokes == 1) return textureLod(pen, place, lod).r;
  return textureLod(stipple, place, lod).r;
}

// Share of a pixel that is inked: four places in it, on a rotated grid.
float hatched(Surface s, float darkness) {
  float fade = pattern_fade();
  if (fade >= 1.0 || darkness <= 0.0) return darkness;
  float angle = radians(style.angle);
  mat2 turn = mat2(cos(angle), -sin(angle), sin(angle), cos(angle));
  float tile = max(style.tile, 1e-4);
  vec2 place = turn * s.stroke.xy / tile;
  vec2 change = s.stroke.zw / tile;  // in tiles over a picture height
  float across = max(change.y, 0.5 * change.x);
  float lod = clamp(log2(max(across * kTexels * max(style.size, 1e-5), 1e-6)), 0.0, kCoarsest);
  float limit = inked_to(darkness, lod);
  float edge = max(min(kEdge, min(limit, 1.0 - limit)), 1e-5);
  vec2 pixel = change * pixel_size();
  float ink = 0.0;
  for (int k = 0; k < 4; ++k) {
    vec2 offset = vec2(float(k % 2) * 0.5 - 0.375 + 0.25 * float(k / 2), float(k / 2) * 0.5 - 0.125 - 0.25 * float(k % 2));
    float t = threshold_at(place + turn * (offset * pixel), lod);
    ink += 0.25 * saturate(0.5 + 0.5 * (limit - t) / edge);
  }
  return mix(ink, darkness, fade);
}

vec3 shade(Surface s) {
  vec3 tone = s.emissive + diffuse_light(s) * mix(vec3(1.0), s.albedo, style.albedo);
  float white = pow(clamp(luminance(tone) / kLevels, 0.0, 1.0), max(style.contrast, 0.05));
  float ink = hatched(s, saturate(style.darkest) * (1.0 - white));
  vec3 color = mix(style.ink, 0.7 * s.albedo, style.tint);
  return mix(style.paper, color, ink);
}
