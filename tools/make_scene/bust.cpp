// A plaster head in the antique manner on a turned socle: organic, without texture coordinates.
#include <cmath>

#include "make_scene/curve.h"
#include "make_scene/head.h"
#include "make_scene/painting.h"
#include "make_scene/recipes.h"
#include "make_scene/slab.h"
#include "make_scene/stage.h"
#include "make_scene/surface_nets.h"
#include "prep/decimate.h"

namespace luminist {
namespace {

constexpr double kTurn = 0.22;  // of the head against the shoulders, radians
constexpr double kTilt = 0.05;
constexpr std::size_t kTriangles = 80000;

/// Neck, collarbones and the top of the chest; shoulders' frame, centimetres.
double torso_distance(const Point3& p) {
  const Point3 s{std::sqrt(p.x * p.x + 0.05), p.y, p.z};
  double d = round_cone_distance(p, {0.0, -6.0, -2.2}, {0.0, -19.0, -4.0}, 4.9, 5.3);
  d = smooth_union(d, round_cone_distance(s, {0.0, -9.0, -5.5}, {13.0, -22.0, -5.5}, 3.0, 3.6), 4.0);
  d = smooth_union(d, ellipsoid_distance(s, {0.0, -28.5, -3.2}, {17.5, 8.6, 8.2}), 4.0);
  d = smooth_union(d, round_cone_distance(s, {1.7, -20.6, 3.3}, {13.5, -19.6, -1.8}, 0.45, 0.7), 2.6);
  return smooth_difference(d, ellipsoid_distance(s, {6.2, -18.4, 2.6}, {3.2, 0.7, 1.6}), 2.2);  // above the collarbones
}

/// The muscles from behind the ears to the pit of the neck follow the head's turn.
double neck_muscles(const Point3& p) {
  double d = 1e9;
  for (const double side : {-1.0, 1.0}) {
    const Point3 ear = rotated_y({5.6 * side, -5.0, -3.2}, kTurn);
    d = std::min(d, round_cone_distance(p, ear, {1.5 * side, -20.9, 1.7}, 1.1, 0.30));
  }
  return d;
}

/// The bust is cut away in a curve below the collarbones, as plasters are.
double cut_distance(const Point3& p) {
  const double sides = std::hypot(p.x / 12.6, (p.z + 2.0) / 11.0) - 1.0;
  const double below = -28.5 + 0.030 * p.x * p.x - p.y;
  return smooth_intersection(sides * 11.0, below, 1.2);
}

double bust_distance(const Point3& point) {
  const Point3 p = rotated_x(rotated_y(point, -kTurn), kTilt);
  double d = smooth_union(torso_distance(point), neck_muscles(point), 2.6);
  d = smooth_intersection(d, cut_distance(point), 0.5);
  d = smooth_union(d, round_cone_distance(p, {0.0, -13.6, 1.9}, {0.0, -15.0, 1.6}, 0.55, 0.55), 2.6);
  d = smooth_union(d, head_distance(p), 1.6);
  return smooth_union(d, hair_distance(p), 0.25);
}

Mesh plaster_head() {
  constexpr double kCell = 0.14;
  const Field field = bust_distance;
  Mesh mesh = decimate(surface_nets(field, {{-14.0, -31.0, -16.5}, {14.0, 14.0, 13.0}}, kCell), kTriangles);
  snap_to_field(mesh, field, kCell);
  return mesh;
}

/// A turned foot of 0.12 height, square below.
Mesh socle() {
  const Curve profile = Curve::profile({{0.0950, 0.0240},
                                        {0.0945, 0.0262},
                                        {0.0900, 0.0300},
                                        {0.0870, 0.0360},
                                        {0.0845, 0.0400},
                                        {0.0740, 0.0440},
                                        {0.0600, 0.0540},
                                        {0.0520, 0.0680},
                                        {0.0505, 0.0820},
                                        {0.0560, 0.0930},
                                        {0.0640, 0.0985},
                                        {0.0655, 0.1020},
                                        {0.0640, 0.1060},
                                        {0.0560, 0.1090},
                                        {0.0500, 0.1200},
                                        {0.0480, 0.1300}});
  Mesh mesh = tessellate(revolve(profile), 96, 90);
  append(mesh, slab_at({0.0F, 0.0125F, 0.0F}, {0.1F, 0.0125F, 0.1F}, 0.003F));
  return mesh;
}

Mesh without_uvs(Mesh mesh) {
  mesh.uvs.clear();
  return mesh;
}

int plain_material(Stage& stage, const std::string& name, const Vec3& color, float roughness) {
  Material material;
  material.name = name;
  material.base_color = color;
  material.roughness = roughness;
  return stage.add_material(material);
}

}  // namespace

Scene build_bust() {
  Stage stage;
  Placement head;
  head.position = {0.0F, 0.385F, 0.025F};
  head.scale = Vec3(0.01F);  // centimetres
  const int plaster = plain_material(stage, "plaster", swatch(0xE4DED2), 0.62F);
  stage.add_object("bust", plaster_head(), plaster, head.matrix());
  const int marble = plain_material(stage, "dark_marble", swatch(0x4A4440), 0.28F);
  stage.add_object("socle", without_uvs(socle()), marble);
  const int stone = plain_material(stage, "stone", swatch(0x8E867A), 0.8F);
  stage.add_object("ledge", without_uvs(slab_at({0.0F, -0.03F, 0.0F}, {0.9F, 0.03F, 0.32F}, 0.006F)), stone);
  stage.mark_backdrop();
  const int wall = plain_material(stage, "wall", swatch(0x7C7670), 0.9F);
  stage.add_object("wall", without_uvs(slab_at({0.0F, 0.5F, -0.52F}, {1.6F, 1.0F, 0.02F}, 0.002F)), wall);
  stage.mark_backdrop();
  stage.add_camera("three_quarter", {-0.47F, 0.41F, 1.03F}, {0.0F, 0.280F, 0.0F}, 0.47F);
  return stage.take();
}

}  // namespace luminist
