#include "make_scene/furniture.h"

#include <cmath>
#include <map>
#include <tuple>

#include "base/check.h"
#include "make_scene/curve.h"
#include "make_scene/slab.h"
#include "prep/subdivide.h"

namespace luminist {
namespace {

constexpr float kWoodTexture = 0.9F;  // metres that the wood's texture spans
constexpr float kBoard = 0.024F;      // thickness of a bookcase's boards
constexpr float kBookcaseHeight = 1.9F;

/// The grain runs along a swept or turned part.
Mesh along_grain(Mesh mesh, float length) {
  for (Vec2& uv : mesh.uvs) uv = {uv.y * length / kWoodTexture, uv.x * 0.25F};
  return mesh;
}

Mesh stick(const std::vector<Point4>& knots, const Point3& up = {0.0, 0.0, 1.0}) {
  const Curve path(knots);
  return along_grain(tessellate(sweep(path, up), 14, 26), static_cast<float>(path.length()));
}

}  // namespace

Mesh table_mesh(float radius) {
  const double r = radius;
  const Curve top = Curve::profile({{0.0, 0.712},
                                    {0.5 * r, 0.712},
                                    {r - 0.030, 0.712},
                                    {r - 0.020, 0.716},
                                    {r - 0.012, 0.724},
                                    {r - 0.002, 0.727},
                                    {r, 0.733},
                                    {r - 0.004, 0.739},
                                    {r - 0.012, 0.7405},
                                    {0.5 * r, 0.741},
                                    {0.0, 0.741}});
  Mesh table = tessellate(revolve(top), 72, 44);
  for (std::size_t i = 0; i < table.uvs.size(); ++i) {  // boards across, not rings
    table.uvs[i] = Vec2(table.positions[i].x, table.positions[i].z) / kWoodTexture;
  }
  const Curve column = Curve::profile({{0.030, 0.712},
                                       {0.085, 0.705},
                                       {0.075, 0.690},
                                       {0.040, 0.672},
                                       {0.034, 0.640},
                                       {0.052, 0.600},
                                       {0.060, 0.560},
                                       {0.042, 0.500},
                                       {0.032, 0.440},
                                       {0.036, 0.400},
                                       {0.055, 0.380},
                                       {0.040, 0.360},
                                       {0.045, 0.320},
                                       {0.060, 0.260},
                                       {0.055, 0.200},
                                       {0.062, 0.170},
                                       {0.040, 0.140},
                                       {0.000, 0.135}});
  Mesh turned = tessellate([round = revolve(column)](double u, double v) { return round(u, 1.0 - v); }, 30, 80);
  append(table, along_grain(turned, 0.7F));
  for (int i = 0; i < 3; ++i) {
    const double turn = 2.0 * kPi * i / 3.0 + 0.4;
    const double x = std::sin(turn);
    const double z = std::cos(turn);
    append(table, stick({{0.03 * x, 0.250, 0.03 * z, 0.034},
                         {0.12 * x, 0.235, 0.12 * z, 0.030},
                         {0.24 * x, 0.130, 0.24 * z, 0.025},
                         {0.33 * x, 0.040, 0.33 * z, 0.024},
                         {0.37 * x, 0.022, 0.37 * z, 0.022},
                         {0.40 * x, 0.026, 0.40 * z, 0.016},
                         {0.41 * x, 0.030, 0.41 * z, 0.003}},
                        {0.0, 1.0, 0.0}));
  }
  return table;
}

Mesh chair_frame() {
  Mesh chair;
  for (const double side : {-1.0, 1.0}) {
    append(chair, stick({{0.205 * side, 0.0, 0.19, 0.015},
                         {0.195 * side, 0.22, 0.185, 0.019},
                         {0.185 * side, 0.44, 0.18, 0.021}}));
    append(chair, stick({{0.205 * side, 0.0, -0.24, 0.015},
                         {0.190 * side, 0.22, -0.205, 0.019},
                         {0.180 * side, 0.45, -0.185, 0.020},
                         {0.190 * side, 0.70, -0.215, 0.018},
                         {0.205 * side, 0.90, -0.265, 0.016},
                         {0.207 * side, 0.925, -0.273, 0.004}}));
    append(chair, stick({{0.195 * side, 0.20, 0.185, 0.010},
                         {0.190 * side, 0.20, 0.0, 0.012},
                         {0.190 * side, 0.20, -0.205, 0.010}}));
  }
  append(chair, stick({{-0.19, 0.24, 0.0, 0.010}, {0.0, 0.24, 0.0, 0.012}, {0.19, 0.24, 0.0, 0.010}}));
  const Section slat = [](double angle, double) { return Point2(0.42 * std::cos(angle), 1.9 * std::sin(angle)); };
  for (const double height : {0.60, 0.72, 0.84}) {
    const double back = -0.195 - 0.15 * (height - 0.55);
    const Curve path(
        {{-0.20, height, back, 0.016}, {0.0, height + 0.012, back - 0.045, 0.019}, {0.20, height, back, 0.016}});
    append(chair, along_grain(tessellate(sweep(path, {0.0, 0.0, 1.0}, slat), 18, 30), 0.4F));
  }
  return chair;
}

Mesh chair_seat() {
  Mesh seat = cushion({0.215F, 0.030F, 0.205F}, 0.010F, 0.35F);
  for (Vec3& p : seat.positions) p.y += 0.455F;
  return seat;
}

float board_height(int board, int boards) {
  return 0.08F + static_cast<float>(board) * (kBookcaseHeight - 0.08F - kBoard) / static_cast<float>(boards - 1) +
         kBoard * 0.5F;
}

Mesh bookcase_mesh(float width, int boards) {
  const float half = 0.5F * width;
  Mesh shelf;
  for (const float side : {-1.0F, 1.0F}) {
    append(shelf, slab_at({side * half, 0.5F * kBookcaseHeight, 0.0F}, {0.014F, 0.5F * kBookcaseHeight, 0.15F}, 0.003F,
                          kWoodTexture, {0.1F, side}));
  }
  for (int i = 0; i < boards; ++i) {
    const float y = board_height(i, boards) - 0.5F * kBoard;
    append(shelf, slab_at({0.0F, y, 0.0F}, {half - 0.012F, 0.5F * kBoard, 0.147F}, 0.003F, kWoodTexture,
                          {0.3F * static_cast<float>(i), 0.2F * static_cast<float>(i)}));
  }
  append(shelf, slab_at({0.0F, kBookcaseHeight + 0.015F, 0.005F}, {half + 0.045F, 0.020F, 0.175F}, 0.008F, kWoodTexture,
                        {0.6F, 0.4F}));
  append(shelf, slab_at({0.0F, 0.04F, 0.0F}, {half - 0.012F, 0.04F, 0.135F}, 0.003F, kWoodTexture, {0.2F, 0.7F}));
  append(shelf, slab_at({0.0F, 0.5F * kBookcaseHeight, -0.145F},
                        {half - 0.012F, 0.5F * kBookcaseHeight - 0.01F, 0.005F}, 0.002F, kWoodTexture, {0.8F, 0.1F}));
  return shelf;
}

Mesh cushion(const Vec3& half, float crown, float softness) {
  const float inner = 1.0F - softness;
  const float places[4] = {-1.0F, -inner, inner, 1.0F};
  Cage cage;
  std::map<std::tuple<int, int, int>, std::uint32_t> index;
  const auto corner = [&](int i, int j, int k) {
    const auto [entry, is_new] = index.try_emplace({i, j, k}, static_cast<std::uint32_t>(cage.positions.size()));
    if (is_new) {
      const Vec3 p(places[i], places[j], places[k]);
      const Vec3 bulge =
          p * (Vec3(1.0F) - Vec3(p.y * p.y + p.z * p.z, p.x * p.x + p.z * p.z, p.x * p.x + p.y * p.y) * 0.5F);
      cage.positions.push_back(p * half + crown * 2.0F * bulge);
    }
    return entry->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const int end : {0, 3}) {
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
          const auto at = [&](int da, int db) {
            int c[3] = {0, 0, 0};
            c[axis] = end, c[(axis + 1) % 3] = a + da, c[(axis + 2) % 3] = b + db;
            return corner(c[0], c[1], c[2]);
          };
          if (end == 3)
            cage.faces.push_back({at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
          else
            cage.faces.push_back({at(0, 0), at(0, 1), at(1, 1), at(1, 0)});
        }
      }
    }
  }
  auto mesh = subdivide(cage, 2);
  LUM_CHECK(mesh.has_value(), "the cage is a closed box");
  return std::move(mesh).value();
}

Mesh armchair_mesh() {
  struct Piece {
    Vec3 half;
    float crown;
    float softness;
    Placement place;
  };
  const Piece pieces[] = {
      {{0.40F, 0.11F, 0.38F}, 0.004F, 0.18F, {{0.0F, 0.23F, 0.0F}}},                            // base
      {{0.275F, 0.085F, 0.33F}, 0.030F, 0.45F, {{0.0F, 0.40F, 0.055F}}},                        // seat
      {{0.36F, 0.34F, 0.085F}, 0.016F, 0.40F, {{0.0F, 0.60F, -0.33F}, {-0.16F, 0.0F, 0.0F}}},   // back
      {{0.265F, 0.22F, 0.075F}, 0.040F, 0.55F, {{0.0F, 0.66F, -0.22F}, {-0.20F, 0.0F, 0.0F}}},  // its cushion
      {{0.085F, 0.20F, 0.37F}, 0.012F, 0.42F, {{-0.36F, 0.42F, 0.01F}}},                        // arms
      {{0.085F, 0.20F, 0.37F}, 0.012F, 0.42F, {{0.36F, 0.42F, 0.01F}}},
  };
  Mesh chair;
  for (const Piece& piece : pieces) {
    Mesh part = cushion(piece.half, piece.crown, piece.softness);
    transform(part, piece.place.matrix());
    append(chair, part);
  }
  return chair;
}

Mesh armchair_feet() {
  Mesh feet;
  for (const double x : {-0.33, 0.33}) {
    for (const double z : {-0.30, 0.31}) {
      append(feet, stick({{x * 1.06, 0.0, z * 1.06, 0.014}, {x, 0.08, z, 0.024}, {x * 0.97, 0.15, z * 0.97, 0.028}}));
    }
  }
  return feet;
}

}  // namespace luminist
