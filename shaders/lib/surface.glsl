// lib/surface.glsl -- what a style and a light see of the world. Nothing here knows a light type or a style.

// A visible point. World space, linear colour.
struct Surface {
  vec3 position;
  vec3 normal;      // unit, faces the eye
  vec3 view;        // unit, towards the eye
  vec2 screen;      // place on the picture, from the upper left corner, in picture heights; y down
  vec3 albedo;      // diffuse reflectance
  vec3 specular;    // reflectance at normal incidence
  vec3 emissive;    // radiance; part of what is left without lights
  float roughness;  // GGX alpha = roughness^2
  uint object;      // 1 + index of the scene's object
  uint material;    // 1 + index of the scene's material
  vec4 stroke;      // xy place on the unwrapped mesh in scene radii, u along the strokes; zw how much u and v change over
                    // a picture height; zero unless the manifest says strokes = true
  uint line;        // LINE_SILHOUETTE, ... on a line of the style's, or LINE_NONE
};

const uint LINE_NONE = 0u;
const uint LINE_SILHOUETTE = 1u;
const uint LINE_CREASE = 2u;
const uint LINE_INTERSECTION = 3u;
const uint LINE_BORDER = 4u;

// What one light sends to one surface.
struct LightSample {
  vec3 direction;    // unit, towards the light
  vec3 color;        // radiance of a white diffuser there that faces the light, without shadows
  float shape;       // share of the light that its own limits (barn, cutoffs) let through; color contains it
  float lit;         // share of the light that nothing blocks: 1 lit, 0 in full shadow; filled in by the host
  float visibility;  // the same after the light's shadow density: 1 - density * (1 - lit); filled in by the host
  bool key;          // whether the light is the key of the surface's object (rig/light_links.h); filled in by the host
};

// What a light's author returns.
LightSample unshadowed(vec3 direction, vec3 color, float shape) {
  return LightSample(direction, color, shape, 1.0, 1.0, false);
}
