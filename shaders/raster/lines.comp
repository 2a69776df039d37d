// Marks the samples that lie on a line: within half of its width of the intersection of two objects or of the border of
// two materials, on either side. Lines that are geometry are left as they are.
layout(r8ui, binding = 0) writeonly uniform uimage2DArray kinds;

uniform vec3 eye;
uniform float pixel_angle;  // width of a pixel at distance 1
uniform float width;        // world, at the depth of reference
uniform float reference_depth;
uniform float growth;  // exponent of the width with depth: 1 keeps it on the picture, 0 in the world
uniform bool intersections;
uniform bool borders;
uniform vec2 offsets[4];  // of layers 1 to 4, pixels from the centre; y down

const uint kIntersection = 3u;
const uint kBorder = 4u;
const uint kLineBits = 0xF0000000u;
const float kTouching = 1.5;  // pixels that surfaces may be apart where they meet
const float kGap = 3.0;       // line widths that they may be apart, and no hull fits between them
const int kFarthest = 24;     // pixels

struct Point {
  uvec2 id;
  vec3 position;
  vec3 normal;
  float depth;
};

Point fetch(ivec3 texel) {
  vec4 position = texelFetch(position_layers, texel, 0);
  return Point(texelFetch(id_layers, texel, 0).xy, position.xyz, texelFetch(normal_layers, texel, 0).xyz,
               1.0 / max(position.w, 1e-12));
}

bool may_meet(uvec2 p, uvec2 q) {
  return p.x != 0u && q.x != 0u && ((borders && p.y != q.y) || (intersections && p.x != q.x));
}

// Where the plane of a point is met from the eye.
float distance_along(vec3 way, Point p) {
  float slope = dot(way, p.normal);
  return abs(slope) > 1e-4 ? dot(p.position - eye, p.normal) / slope : length(p.position - eye);
}

// Which line lies between two samples `apart` pixels from each other; 0: none.
uint line_between(Point p, Point q, float apart, float radius) {
  if (!may_meet(p.id, q.id) || ((p.id.y | q.id.y) & kLineBits) != 0u) return 0u;
  vec3 way = normalize(0.5 * (p.position + q.position) - eye);
  float pixel = pixel_angle * min(p.depth, q.depth);
  float gap = pixel * max(kTouching * max(apart, 1.0), kGap * 2.0 * radius);
  // Shading normals bend planes: surfaces that are near each other meet all the same.
  bool meeting = abs(distance_along(way, p) - distance_along(way, q)) <= gap || distance(p.position, q.position) <= gap;
  if (!meeting) return 0u;
  return borders && p.id.y != q.id.y ? kBorder : kIntersection;
}

bool is_inside(ivec2 texel) {
  return texel.x >= 0 && texel.y >= 0 && uint(texel.x) < size.x && uint(texel.y) < band_rows + 2u * margin;
}

// Pixels from the centre; textures have their rows from the bottom.
vec2 place(int layer) { return layer == 0 ? vec2(0.0) : vec2(offsets[layer - 1].x, -offsets[layer - 1].y); }

uint line_at(ivec2 texel, int layer, float radius) {
  Point p = fetch(ivec3(texel, layer));
  int reach = int(ceil(radius + 0.5));
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      if (!is_inside(texel + ivec2(x, y))) continue;
      for (int k = 0; k <= 4; ++k) {
        float apart = length(vec2(x, y) + place(k) - place(layer));
        if (apart > radius || apart == 0.0) continue;
        ivec3 there = ivec3(texel + ivec2(x, y), k);
        if (!may_meet(p.id, texelFetch(id_layers, there, 0).xy)) continue;
        uint kind = line_between(p, fetch(there), apart, radius);
        if (kind != 0u) return kind;
      }
    }
  }
  return 0u;
}

// Whether a line may be near, by a look at the pixels' centres: most pixels are far from any.
bool is_near(ivec2 texel, float radius) {
  uvec2 id = texelFetch(id_layers, ivec3(texel, 0), 0).xy;
  int reach = int(ceil(radius)) + 1;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      ivec2 there = texel + ivec2(x, y);
      if (is_inside(there) && texelFetch(id_layers, ivec3(there, 0), 0).xy != id) return true;
    }
  }
  return false;
}

void main() {
  ivec2 texel;
  uint pixel;
  if (!locate(linear_index(), texel, pixel)) return;
  float depth = 1.0 / max(texelFetch(position_layers, ivec3(texel, 0), 0).w, 1e-12);
  if (texelFetch(id_layers, ivec3(texel, 0), 0).x == 0u) depth = reference_depth;
  float half_width = 0.5 * width * pow(depth / reference_depth, growth);
  float radius = clamp(half_width / (pixel_angle * depth), 0.0, float(kFarthest));
  if (radius <= 0.0 || !is_near(texel, radius)) return;
  for (int layer = 0; layer <= 4; ++layer) {
    uint kind = line_at(texel, layer, radius);
    if (kind != 0u) imageStore(kinds, ivec3(texel, layer), uvec4(kind));
  }
}
