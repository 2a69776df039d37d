// A corner of a ribbon along an edge of a mesh: half a width aside on the picture and beyond the edge's end, and as much
// nearer to the eye, so that it lies on the surfaces that meet there.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 other;  // end of the edge
layout(location = 2) in float share;
layout(location = 3) in float side;  // -1 or 1
layout(location = 4) in float angle;

uniform mat4 clip_from_world;  // with the shift of the pass
uniform mat4 world_from_object;
uniform vec3 eye;
uniform float width;  // world, at the depth of reference
uniform float reference_depth;
uniform float growth;  // exponent of the width with depth: 1 keeps it on the picture, 0 in the world
uniform float pull;
uniform float least_angle;

out vec3 world_position;
out vec3 world_direction;

void main() {
  vec3 here = (world_from_object * vec4(position, 1.0)).xyz;
  vec3 along = (world_from_object * vec4(other, 1.0)).xyz - here;
  float depth = max((clip_from_world * vec4(here, 1.0)).w, 1e-4 * reference_depth);
  float wide = 0.5 * share * width * pow(depth / reference_depth, growth);
  vec3 to_eye = normalize(eye - here);
  vec3 across = cross(to_eye, along);
  float long_ = length(across);
  world_direction = to_eye;
  if (angle < least_angle || !(long_ > 0.0)) {  // nothing is drawn
    world_position = here;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  across /= long_;
  vec3 onward = cross(across, to_eye);
  here += wide * (side * across - 0.5 * onward + 2.0 * pull * to_eye);
  world_position = here;
  gl_Position = clip_from_world * vec4(here, 1.0);
}
