// lib/host.glsl -- what the engine hands to shade(): samples, candidates, softness. Names that begin with lum_ are the
// host's; a style uses Surface, LightSample, light_count(), light(), ambient(), pixel_size(), style and
// lib/helpers.glsl.

layout(std140, binding = LUM_FRAME) uniform LumFrame {
  mat4 screen_from_world;
  vec4 eye;            // xyz world, w = 1 / height of the picture in pixels
  float light_edge;    // least edge of a light's own limits, tangent
  float threshold;     // least half width of a style's thresholds
  uint samples;        // samples of one candidate
  uint padded;         // the same, rounded up to whole work groups
  uint candidates;
  uint run;            // candidates of one invocation
  uint indexed;        // 1: sample i is entry lum_entries[i] of the surface; 0: entry i
  uint layered;        // 1: lum_layer is added
  float pattern_fade;  // 1: patterns give way to their mean tone
  uint strokes;        // 1: lum_strokes holds something
  uint link_words;     // of one row of bits in lum_links
  uint first;          // sample of the first invocation
} lum_frame;

// The deep framebuffer. position.w and normal.w hold object and material as bits.
layout(std430, binding = LUM_POSITION) readonly buffer LumPositions { vec4 lum_positions[]; };
layout(std430, binding = LUM_NORMAL) readonly buffer LumNormals { vec4 lum_normals[]; };
layout(std430, binding = LUM_ALBEDO) readonly buffer LumAlbedos { vec4 lum_albedos[]; };
layout(std430, binding = LUM_SPECULAR) readonly buffer LumSpeculars { vec4 lum_speculars[]; };
layout(std430, binding = LUM_EMISSIVE) readonly buffer LumEmissives { vec4 lum_emissives[]; };

layout(std430, binding = LUM_STROKES) readonly buffer LumStrokes { vec4 lum_strokes[]; };

layout(std430, binding = LUM_ENTRIES) readonly buffer LumEntries { uint lum_entries[]; };
// [column * samples + sample]
layout(std430, binding = LUM_VISIBILITY) readonly buffer LumVisibility { float lum_visibility[]; };
// [2 candidate] first light, number of lights, ambient block (LUM_NONE: nothing but lights), style block
// [2 candidate + 1] first material, number of materials; those of the scene that are not among them are as they are
layout(std430, binding = LUM_CANDIDATES) readonly buffer LumCandidates { uvec4 lum_candidates[]; };
// [light] type, block of that type, visibility column (LUM_NONE: no shadows), which objects it lights: LUM_NONE or
// LUM_KEY_OF_ALL, or its first word in lum_links
layout(std430, binding = LUM_LIGHTS) readonly buffer LumLights { uvec4 lum_lights[]; };
// Two rows of bits a light, one bit an object: what it lights, whose key it is.
layout(std430, binding = LUM_LINKS) readonly buffer LumLinks { uint lum_links[]; };
// What is turned of a material: MaterialTurn of scene/material_params.h.
struct LumMaterial {
  vec4 tint;   // rgb factor of the base colour; w factor of the roughness
  vec4 shine;  // x added to the roughness; y factor of the colourless reflectance, z added to it; w 0: nothing is turned
};
layout(std430, binding = LUM_MATERIALS) readonly buffer LumMaterials { LumMaterial lum_materials[]; };
// [sample] colours that every candidate is added to
layout(std430, binding = LUM_LAYER) readonly buffer LumLayer { vec4 lum_layer[]; };
// [candidate * samples + sample]
layout(std430, binding = LUM_COLORS) writeonly buffer LumColors { vec4 lum_colors[]; };

const uint LUM_NONE = 0xFFFFFFFFu;
const uint LUM_KEY_OF_ALL = 0xFFFFFFFEu;

uvec4 lum_candidate = uvec4(0u);
uvec2 lum_candidate_materials = uvec2(0u);
float lum_dielectric = 0.0;  // the share of the sample's reflectance that has no colour
uint lum_sample = 0u;

float lum_light_edge_softness() { return lum_frame.light_edge; }
float lum_threshold_softness() { return lum_frame.threshold; }
float lum_pattern_fade() { return lum_frame.pattern_fade; }

// The side of a pixel, in picture heights as Surface.screen.
float pixel_size() { return lum_frame.eye.w; }

bool lum_link(uint row, uint object) { return (lum_links[row + (object >> 5u)] >> (object & 31u) & 1u) != 0u; }

int light_count() { return int(lum_candidate.y); }

// The surface as the candidate's materials have it: turned() of scene/material_params.h.
Surface lum_turn(Surface s) {
  if (s.material == 0u || s.material > lum_candidate_materials.y) return s;
  LumMaterial turn = lum_materials[lum_candidate_materials.x + s.material - 1u];
  if (turn.shine.w == 0.0) return s;
  vec3 metal = s.specular - lum_dielectric;
  vec3 base = s.albedo + metal;
  vec3 tint = clamp(turn.tint.rgb, vec3(0.0), 1.0 / clamp(base, vec3(1e-6), vec3(1.0)));
  s.albedo *= tint;
  s.specular = metal * tint + clamp(lum_dielectric * turn.shine.y + turn.shine.z, 0.0, 1.0);
  s.roughness = clamp(s.roughness * turn.tint.w + turn.shine.x, 0.0, 1.0);
  return s;
}

Surface lum_surface(uint entry) {
  vec4 position = lum_positions[entry];
  vec4 normal = lum_normals[entry];
  vec4 albedo = lum_albedos[entry];
  vec3 to_eye = lum_frame.eye.xyz - position.xyz;
  vec3 view = to_eye * inversesqrt(max(dot(to_eye, to_eye), 1e-24));
  vec4 screen = lum_frame.screen_from_world * vec4(position.xyz, 1.0);
  vec4 specular = lum_speculars[entry];
  lum_dielectric = specular.a;
  uint material = floatBitsToUint(normal.w);
  return Surface(position.xyz, normal.xyz, view, screen.xy / max(screen.w, 1e-12), albedo.rgb,
                 specular.rgb, lum_emissives[entry].rgb, albedo.a, floatBitsToUint(position.w),
                 material & 0x0FFFFFFFu, lum_frame.strokes != 0u ? lum_strokes[entry] : vec4(0.0), material >> 28u);
}
