// The share of a light's filter that reaches each sample: percentage-closer filtering of one light's depth map. The
// geometry is that of src/raster/shadow_light.cpp, which rays follow too.
layout(std430, binding = 0) readonly buffer Position { uvec4 position[]; };
layout(std430, binding = 1) readonly buffer Normal { vec4 normal[]; };
layout(std430, binding = 2) writeonly buffer Visibility { float visibility[]; };
layout(std430, binding = 3) readonly buffer Slack { float slack[]; };  // [objects] of shadow meshes, or 0

layout(binding = 0) uniform sampler2DArrayShadow depth_map;  // near / distance along the view's axis

const float kLeastCosine = 0.1;
const float kPull = 3.0;
const float kMostPull = 0.15;
const float kOwnShadowEdge = 0.05;
const int kMostTaps = 64;

uniform uint sample_count;
uniform uint first;  // index of the light's first visibility
uniform vec3 light_position;
uniform mat3 views[6];  // right, up and axis of each view as rows
uniform bool cube;
uniform bool sun;          // parallel rays: lengths are world units, not tangents
uniform float near_plane;  // of a sun half the range of depth
uniform float extent;      // tangent that a view covers to each side
uniform float softness;    // tangent of the filter's radius
uniform float texel;       // width of a texel at distance 1
uniform vec2 disc[kMostTaps];
uniform int taps;

int view_towards(vec3 way) {
  if (!cube) return 0;
  vec3 a = abs(way);
  if (a.x >= a.y && a.x >= a.z) return way.x > 0.0 ? 0 : 1;
  if (a.y >= a.z) return way.y > 0.0 ? 2 : 3;
  return way.z > 0.0 ? 4 : 5;
}

// The same for parallel rays.
float lit_by_sun(vec3 p, vec3 n, float shadow_slack) {
  mat3 view = views[0];
  vec3 facing = view * n;
  float sine = sqrt(max(0.0, 1.0 - facing.z * facing.z));
  vec3 seen = view * (p + n * (texel * (0.75 + 0.75 * sine) + shadow_slack) - light_position);
  if (max(abs(seen.x), abs(seen.y)) > extent) return 1.0;
  vec2 slope = softness / max(-facing.z, kLeastCosine) * facing.xy;
  float lit = 0.0;
  for (int i = 0; i < taps; ++i) {
    float lift = kPull * softness * length(disc[i]) + max(-dot(slope, disc[i]), 0.0);
    vec2 uv = 0.5 + 0.5 * (seen.xy + softness * disc[i]) / extent;
    lit += texture(depth_map, vec4(uv, 0.0, max(0.5 - 0.5 * (seen.z - lift) / near_plane, 0.0)));
  }
  return lit / float(taps);
}

float lit_share(vec3 p, vec3 n, float shadow_slack) {
  vec3 to_light = light_position - p;
  float distance_there = length(to_light);
  float cosine = dot(to_light, n) / max(distance_there, 1e-20);
  float sine = sqrt(max(0.0, 1.0 - cosine * cosine));
  vec3 way = p + n * (distance_there * texel * (0.75 + 0.75 * sine) + shadow_slack) - light_position;

  int layer = view_towards(way);
  mat3 view = views[layer];
  vec3 seen = view * way;
  if (!(seen.z > 0.0) || max(abs(seen.x), abs(seen.y)) > seen.z * extent) return 1.0;

  // The filter's disc lies across the way from the light; its taps are moved along their rays towards the light, out
  // of the receiver's plane and of the corners that it makes with others.
  float reach = length(seen);
  vec3 axis = seen / reach;
  vec3 right = normalize(vec3(1.0, 0.0, 0.0) - axis * axis.x);
  vec3 up = cross(axis, right);
  vec3 facing = view * n;
  float steepness = softness / max(-dot(axis, facing), kLeastCosine);
  vec2 slope = steepness * vec2(dot(right, facing), dot(up, facing));

  float lit = 0.0;
  for (int i = 0; i < taps; ++i) {
    vec3 tap = axis + softness * (disc[i].x * right + disc[i].y * up);
    float pull = min(kPull * softness * length(disc[i]), kMostPull);
    float nearer = (1.0 - pull) / (1.0 + max(-dot(slope, disc[i]), 0.0));
    float depth = near_plane / (reach * nearer * tap.z);
    vec2 uv = 0.5 + 0.5 * tap.xy / (tap.z * extent);
    lit += texture(depth_map, vec4(uv, float(layer), depth));
  }
  return lit / float(taps);
}

// What faces away from a light is in its object's own shadow, whatever mesh blocks light in the object's stead.
float share_before_own_shadow(vec3 p, vec3 n) {
  vec3 to_light = light_position - p;
  float cosine = sun ? -(views[0] * n).z : dot(to_light, n) / max(length(to_light), 1e-20);
  return clamp(1.0 + cosine / kOwnShadowEdge, 0.0, 1.0);
}

void main() {
  uint index = linear_index();
  if (index >= sample_count) return;
  uvec4 p = position[index];
  float lit = 1.0;
  if (p.w != 0u) {
    vec3 place = uintBitsToFloat(p.xyz);
    float shadow_slack = slack[p.w - 1u];
    vec3 facing = normal[index].xyz;
    lit = sun ? lit_by_sun(place, facing, shadow_slack) : lit_share(place, facing, shadow_slack);
    if (shadow_slack > 0.0) lit *= share_before_own_shadow(place, normal[index].xyz);
  }
  visibility[first + index] = lit;
}
