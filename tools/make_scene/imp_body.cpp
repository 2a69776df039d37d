#include <algorithm>
#include <cmath>
#include <map>

#include "make_scene/chain.h"
#include "make_scene/imp.h"
#include "make_scene/noise.h"
#include "make_scene/painting.h"
#include "make_scene/surface_nets.h"
#include "prep/decimate.h"

namespace luminist {
namespace {

constexpr double kHeadTilt = 0.10;
constexpr double kHeadTurn = -0.12;
const char* const kNames[] = {"head", "torso", "arm_right", "arm_left", "leg_right", "leg_left"};
constexpr std::size_t kBodyParts = 6;
const Point3 kNeck{0.0, 2.55, 0.02};

/// The head's own frame: upright, looking along +Z.
Point3 in_head(const Point3& p) {
  return rotated_y(rotated_z(p - kNeck, -kHeadTilt), -kHeadTurn) + kNeck;
}
Point3 from_head(const Point3& p) {
  return rotated_z(rotated_y(p - kNeck, kHeadTurn), kHeadTilt) + kNeck;
}

double imp_ear_distance(const Point3& s) {
  const Point3 q = rotated_z(s - Point3(0.66, 3.18, -0.05), -0.42);
  const Point3 flat = rotated_y(q, 0.55);
  const double along = std::clamp(flat.x / 1.25, 0.0, 1.0);
  const double width = 0.30 * std::sin(kPi * std::pow(along, 0.62) * 0.93 + 0.22);
  const Point3 scaled{flat.x - 0.62, flat.y / std::max(width / 0.30, 0.15),
                      flat.z * 2.6 - 0.12 * std::sin(along * 3.0)};
  const double blade = (ellipsoid_distance(scaled, Point3(0.0), {0.76, 0.30, 0.22})) * 0.38;
  const double bowl = ellipsoid_distance(flat, {0.50, 0.0, 0.13}, {0.52, 0.15, 0.09});
  return smooth_difference(blade, bowl, 0.08);
}

double face_distance(double d, const Point3& s) {
  d = smooth_union(d, ellipsoid_distance(s, {0.0, 2.90, 0.52}, {0.46, 0.30, 0.36}), 0.28);
  d = smooth_union(d, ellipsoid_distance(s, {0.0, 3.02, 0.84}, {0.13, 0.09, 0.10}), 0.12);  // nose
  const Point3 eye = eye_center(1) - Point3(0.0);
  const Point3 upright = in_head(eye);
  double lids = sphere_distance(s, upright, kEyeRadius + 0.065);
  const Point3 toward = s - upright;
  const double opening = std::max(toward.y * 0.9 - 0.155 - 0.10 * toward.x, -0.215 - toward.y);  // a lazy upper lid
  lids = smooth_difference(lids, std::max(opening, 0.02 - toward.z), 0.035);
  d = smooth_difference(d, sphere_distance(s, upright, kEyeRadius - 0.01), 0.03);
  d = smooth_union(d, std::max(lids, -sphere_distance(s, upright, kEyeRadius - 0.004)), 0.05);
  const Knot brow[] = {{{0.13, 3.62, 0.62}, 0.045}, {{0.36, 3.66, 0.57}, 0.070}, {{0.62, 3.52, 0.42}, 0.04}};
  d = smooth_union(d, chain_distance(s, brow, 0.05), 0.10);
  const double smile = std::abs(s.y - 2.745 - 0.62 * s.x * s.x) - 0.012;  // a line of depth 0.05, turned up at its ends
  d = smooth_difference(d, std::max({smile, s.x - 0.50, 0.2 - s.z, -0.05 - d}), 0.035);
  d = smooth_difference(d, sphere_distance(s, {0.54, 2.93, 0.46}, 0.045), 0.08);
  return smooth_difference(d, sphere_distance(s, {0.062, 3.00, 0.925}, 0.026), 0.03);
}

double imp_skull_distance(const Point3& p) {
  const Point3 q = in_head(p);
  const Point3 s{std::sqrt(q.x * q.x + 0.0006), q.y, q.z};
  double d = ellipsoid_distance(s, {0.0, 3.22, 0.02}, {0.74, 0.62, 0.66});
  d = smooth_union(d, ellipsoid_distance(s, {0.34, 2.97, 0.22}, {0.44, 0.34, 0.42}), 0.25);
  d = face_distance(d, s);
  return smooth_union(d, imp_ear_distance(s), 0.12);
}

double imp_torso_distance(const Point3& p) {
  double d = ellipsoid_distance(p, {0.0, 1.52, 0.06}, {0.60, 0.66, 0.56});
  d = smooth_union(d, ellipsoid_distance(p, {0.0, 2.12, -0.03}, {0.44, 0.42, 0.35}), 0.35);
  const Knot neck[] = {{{0.0, 2.25, -0.03}, 0.26}, {{0.0, 2.72, 0.03}, 0.22}};
  d = smooth_union(d, chain_distance(p, neck, 0.1), 0.18);
  const Knot rump[] = {{{0.0, 1.25, -0.30}, 0.34}, {{0.05, 0.95, -0.62}, 0.19}};
  d = smooth_union(d, chain_distance(p, rump, 0.1), 0.25);
  return smooth_difference(d, sphere_distance(p, {0.0, 1.50, 0.645}, 0.03), 0.06);
}

/// A hand of four fingers with round tips.
double hand_distance(const Point3& p, const Point3& palm, const std::array<std::array<Point3, 2>, 4>& fingers) {
  double d = sphere_distance(p, palm, 0.125);
  for (const auto& [middle, tip] : fingers) {
    const Knot finger[] = {{palm, 0.075}, {middle, 0.050}, {tip, 0.048}};
    d = smooth_union(d, smooth_union(chain_distance(p, finger, 0.03), sphere_distance(p, tip, 0.066), 0.04), 0.06);
  }
  return d;
}

double arm_right_distance(const Point3& p) {  // raised, waving
  const Knot arm[] = {{{-0.36, 2.28, -0.03}, 0.185},
                      {{-0.62, 2.20, 0.02}, 0.155},
                      {{-1.12, 2.20, 0.14}, 0.125},
                      {{-1.24, 2.36, 0.18}, 0.125},
                      {{-1.56, 2.90, 0.34}, 0.090}};
  const Point3 palm{-1.64, 3.06, 0.37};
  const double hand = hand_distance(p, palm,
                                    {{{Point3(-1.90, 3.08, 0.46), Point3(-2.11, 3.12, 0.54)},
                                      {Point3(-1.85, 3.30, 0.40), Point3(-2.00, 3.50, 0.44)},
                                      {Point3(-1.69, 3.38, 0.38), Point3(-1.74, 3.66, 0.40)},
                                      {Point3(-1.51, 3.33, 0.40), Point3(-1.44, 3.56, 0.44)}}});
  return smooth_union(chain_distance(p, arm, 0.08), hand, 0.08);
}

double arm_left_distance(const Point3& p) {  // holds the staff
  const Knot arm[] = {{{0.36, 2.28, -0.03}, 0.185},
                      {{0.60, 2.10, 0.00}, 0.155},
                      {{0.86, 1.72, 0.08}, 0.125},
                      {{0.92, 1.72, 0.20}, 0.125},
                      {{1.12, 1.94, 0.58}, 0.090}};
  const Point3 palm{1.15, 1.99, 0.70};
  const double hand = hand_distance(p, palm,
                                    {{{Point3(1.32, 2.12, 0.80), Point3(1.24, 2.12, 0.96)},
                                      {Point3(1.34, 2.00, 0.82), Point3(1.25, 1.99, 0.98)},
                                      {Point3(1.32, 1.88, 0.82), Point3(1.23, 1.86, 0.96)},
                                      {Point3(1.06, 2.08, 0.84), Point3(1.14, 2.06, 0.97)}}});
  return smooth_union(chain_distance(p, arm, 0.08), hand, 0.08);
}

double leg_distance(const Point3& p, double side) {
  const Point3 s{p.x * side, p.y, p.z - (side > 0.0 ? 0.10 : -0.04)};
  const Knot leg[] = {{{0.30, 1.18, 0.0}, 0.30},
                      {{0.50, 0.74, 0.18}, 0.18},
                      {{0.50, 0.62, 0.14}, 0.15},
                      {{0.47, 0.22, -0.10}, 0.105},
                      {{0.48, 0.12, 0.05}, 0.115}};
  double d = chain_distance(s, leg, 0.1);
  for (const double spread : {-0.20, 0.0, 0.20}) {
    const Knot toe[] = {{{0.48, 0.11, 0.02}, 0.09},
                        {{0.48 + 0.7 * spread, 0.09, 0.26}, 0.080},
                        {{0.50 + 1.1 * spread, 0.075, 0.42 - std::abs(spread) * 0.4}, 0.085}};
    d = smooth_union(d, chain_distance(s, toe, 0.04), 0.06);
  }
  return d;
}

std::array<double, kBodyParts> part_distances(const Point3& p) {
  return {imp_skull_distance(p), imp_torso_distance(p), arm_right_distance(p),
          arm_left_distance(p),  leg_distance(p, -1.0), leg_distance(p, 1.0)};
}

double skin_distance(const Point3& p) {
  const auto d = part_distances(p);
  double body = smooth_union(d[1], std::min(d[2], d[3]), 0.20);
  body = smooth_union(body, std::min(d[4], d[5]), 0.20);
  body = smooth_union(body, d[0], 0.08);
  return body - 0.006 * std::max(0.0, fbm(p * 5.5, 2)) * 2.0;  // a leathery skin
}

/// Where on the skin's ramp a point lies: u from the back to the belly, v from plain to spot.
Vec2 ramp_place(const Point3& p, const Point3& normal, std::size_t part) {
  double belly = 0.32 + 0.10 * noise(p * 1.4);
  if (part == 1)
    belly = 0.30 + 0.62 * smoothstep(0.15, 0.85, normal.z) * smoothstep(0.62, 0.25, std::abs(p.x)) -
            0.2 * smoothstep(0.0, -0.8, normal.z);
  if (part == 0)
    belly = 0.34 + 0.50 * smoothstep(3.05, 2.75, in_head(p).y) * smoothstep(0.1, 0.8, normal.z) -
            0.22 * smoothstep(0.3, 1.0, normal.y);
  if (part >= 2) belly -= 0.22 * smoothstep(0.35, -0.05, std::min(p.y, part < 4 ? 9.0 : p.y));
  if (part == 2 || part == 3) belly -= 0.20 * smoothstep(1.0, 1.5, std::abs(p.x));
  const double back = smoothstep(0.25, -0.6, normal.z - 0.5 * normal.y);
  const CellSample spot = cells(p * 3.4);
  const double size = 0.24 + 0.16 * static_cast<double>(spot.id % 97U) / 97.0;
  const double spotted = smoothstep(size + 0.06, size - 0.06, spot.nearest) * back;
  return {static_cast<float>(std::clamp(belly, 0.02, 0.98)), static_cast<float>(std::clamp(spotted, 0.02, 0.98))};
}

/// Cuts a mesh into the parts that its triangles are nearest to.
std::vector<BodyPart> split(const Mesh& skin) {
  const Point3 joints[kBodyParts] = {
      kNeck, {0.0, 1.3, 0.0}, {-0.36, 2.28, 0.0}, {0.36, 2.28, 0.0}, {-0.3, 1.2, 0.0}, {0.3, 1.2, 0.0}};
  std::vector<BodyPart> parts;
  for (std::size_t i = 0; i < kBodyParts; ++i) parts.push_back({kNames[i], joints[i], {}});
  std::vector<std::map<std::uint32_t, std::uint32_t>> index(kBodyParts);
  for (const auto& triangle : skin.triangles) {
    const Vec3 middle =
        (skin.positions[triangle[0]] + skin.positions[triangle[1]] + skin.positions[triangle[2]]) / 3.0F;
    const auto distances = part_distances(Point3(middle));
    const auto part =
        static_cast<std::size_t>(std::min_element(distances.begin(), distances.end()) - distances.begin());
    Mesh& mesh = parts[part].mesh;
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [entry, is_new] =
          index[part].try_emplace(triangle[c], static_cast<std::uint32_t>(mesh.positions.size()));
      if (is_new) {
        const Vec3 p = skin.positions[triangle[c]];
        mesh.positions.push_back(p - Vec3(joints[part]));
        mesh.normals.push_back(skin.normals[triangle[c]]);
        mesh.uvs.push_back(skin.uvs[triangle[c]]);
      }
      corners[c] = entry->second;
    }
    mesh.triangles.push_back(corners);
  }
  return parts;
}

}  // namespace

Point3 eye_center(int side) {
  return from_head({0.335 * side, 3.235, 0.515});
}

std::vector<BodyPart> imp_body() {
  constexpr double kCell = 0.028;
  const Field field = skin_distance;
  Mesh skin = decimate(surface_nets(field, {{-2.4, -0.1, -1.2}, {2.4, 4.2, 1.4}}, kCell, 1.5), 40000);
  snap_to_field(skin, field, kCell);
  for (std::size_t i = 0; i < skin.positions.size(); ++i) {
    const Point3 p(skin.positions[i]);
    const auto d = part_distances(p);
    // The ramps of neighbouring parts are blended, so that no seam shows.
    Vec2 sum(0.0F);
    float weights = 0.0F;
    for (std::size_t part = 0; part < kBodyParts; ++part) {
      const auto weight = static_cast<float>(std::exp(-std::max(d[part], 0.0) / 0.05));
      sum += weight * ramp_place(p, Point3(skin.normals[i]), part);
      weights += weight;
    }
    skin.uvs.push_back(sum / weights);
  }
  return split(skin);
}

Image imp_skin(int width, int height) {
  const Vec3 back = swatch(0x1F5148);
  const Vec3 flank = swatch(0x3F8A6A);
  const Vec3 belly = swatch(0xE2CF94);
  return paint_color(width, height, [=](double u, double v) {
    Vec3 color = mix(mix(swatch(0x173E42), back, smoothstep(0.0, 0.15, u)), flank, smoothstep(0.12, 0.40, u));
    color = mix(color, belly, smoothstep(0.45, 0.80, u));
    return mix(color, mix(swatch(0x123438), swatch(0xB98A44), smoothstep(0.4, 0.9, u)), 0.75 * v);
  });
}

}  // namespace luminist
