// A closed room: a table with a chair, an armchair, books, a plant, a mirror on the wall, a lamp on the ceiling.
#include <string>

#include "make_scene/decor.h"
#include "make_scene/fruit.h"
#include "make_scene/furniture.h"
#include "make_scene/grain.h"
#include "make_scene/noise.h"
#include "make_scene/painting.h"
#include "make_scene/recipes.h"
#include "make_scene/slab.h"
#include "make_scene/stage.h"
#include "make_scene/vessel.h"

namespace luminist {
namespace {

// The room's inside: x in [-kHalfX, kHalfX], z in [-kHalfZ, kHalfZ], y in [0, kHeight].
constexpr float kHalfX = 2.1F;
constexpr float kHalfZ = 1.8F;
constexpr float kHeight = 2.6F;
constexpr float kLampZ = -0.35F;

/// A rectangle from a corner along two edges; faces cross(along, up).
Mesh panel(const Vec3& corner, const Vec3& along, const Vec3& up, float texture_size) {
  Mesh mesh = tessellate([=](double u, double v) { return Point3(corner) + u * Point3(along) + v * Point3(up); }, 2, 2);
  scale_uvs(mesh, {glm::length(along) / texture_size, glm::length(up) / texture_size});
  return mesh;
}

/// A panelled door in the wall behind the camera; the mirror shows it.
void add_door(Stage& stage, int paint) {
  const Vec3 foot{-1.20F, 0.0F, kHalfZ};
  Mesh door = slab_at(foot + Vec3(0.0F, 1.0F, -0.020F), {0.42F, 1.0F, 0.018F}, 0.004F);
  for (const float x : {-0.19F, 0.19F}) {
    append(door, slab_at(foot + Vec3(x, 1.42F, -0.038F), {0.14F, 0.44F, 0.010F}, 0.008F));
    append(door, slab_at(foot + Vec3(x, 0.50F, -0.038F), {0.14F, 0.36F, 0.010F}, 0.008F));
    append(door, slab_at(foot + Vec3(2.5F * x, 1.04F, -0.024F), {0.055F, 1.04F, 0.026F}, 0.008F));
  }
  append(door, slab_at(foot + Vec3(0.0F, 2.06F, -0.024F), {0.53F, 0.055F, 0.026F}, 0.008F));
  stage.add_object("door", door, paint);
}

void add_shell(Stage& stage, int oak) {
  const int relief = stage.add_texture("plaster_relief", plaster_relief(384, 1.2));
  const int plaster = stage.add_textured("plaster", plaster_painting(256, swatch(0xA9B0A2), 0.16), 0.9F, relief);
  Mesh walls;
  append(walls, panel({-kHalfX, 0.0F, -kHalfZ}, {2.0F * kHalfX, 0.0F, 0.0F}, {0.0F, kHeight, 0.0F}, 1.2F));
  append(walls, panel({kHalfX, 0.0F, kHalfZ}, {-2.0F * kHalfX, 0.0F, 0.0F}, {0.0F, kHeight, 0.0F}, 1.2F));
  append(walls, panel({-kHalfX, 0.0F, kHalfZ}, {0.0F, 0.0F, -2.0F * kHalfZ}, {0.0F, kHeight, 0.0F}, 1.2F));
  append(walls, panel({kHalfX, 0.0F, -kHalfZ}, {0.0F, 0.0F, 2.0F * kHalfZ}, {0.0F, kHeight, 0.0F}, 1.2F));
  stage.add_object("walls", walls, plaster);
  const int white = stage.add_plain("white_paint", swatch(0xE6E2D8), 0.5F);
  Mesh ceiling = panel({-kHalfX, kHeight, -kHalfZ}, {2.0F * kHalfX, 0.0F, 0.0F}, {0.0F, 0.0F, 2.0F * kHalfZ}, 1.0F);
  stage.add_object("ceiling", ceiling, stage.add_plain("ceiling_paint", swatch(0xE2DED4), 0.9F));
  Mesh skirting;
  for (const float side : {-1.0F, 1.0F}) {
    append(skirting, slab_at({0.0F, 0.055F, side * (kHalfZ - 0.008F)}, {kHalfX, 0.055F, 0.009F}, 0.005F));
    append(skirting, slab_at({side * (kHalfX - 0.008F), 0.055F, 0.0F}, {0.009F, 0.055F, kHalfZ}, 0.005F));
    append(skirting, slab_at({0.0F, kHeight - 0.03F, side * (kHalfZ - 0.02F)}, {kHalfX, 0.035F, 0.025F}, 0.012F));
    append(skirting, slab_at({side * (kHalfX - 0.02F), kHeight - 0.03F, 0.0F}, {0.025F, 0.035F, kHalfZ}, 0.012F));
  }
  stage.add_object("skirting", skirting, white);
  add_door(stage, white);
  Mesh floor;
  constexpr int kPlanks = 18;
  const float width = 2.0F * kHalfZ / kPlanks;
  for (int i = 0; i < kPlanks; ++i) {
    const float z = -kHalfZ + width * (static_cast<float>(i) + 0.5F);
    const auto joint = static_cast<float>(-1.2 + 2.4 * hash01(i, 3));
    const auto shift = static_cast<float>(hash01(i, 1));
    const Vec3 half{0.5F * (kHalfX + joint) - 0.001F, 0.012F, 0.5F * width - 0.0012F};
    append(floor, slab_at({-kHalfX + half.x, -0.012F, z}, half, 0.002F, 1.1F, {shift, 3.0F * shift}, 1));
    const Vec3 rest{0.5F * (kHalfX - joint) - 0.001F, 0.012F, half.z};
    append(floor, slab_at({kHalfX - rest.x, -0.012F, z}, rest, 0.002F, 1.1F, {2.0F * shift, shift + 0.4F}, 1));
  }
  stage.add_object("floor", floor, oak);
}

void add_lamp(Stage& stage) {
  const int brass = stage.add_plain("brass", {0.78F, 0.57F, 0.28F}, 0.28F, 1.0F);
  Material glow;
  glow.name = "lamp_glow";
  glow.base_color = Vec3(0.8F);
  glow.emissive = {6.0F, 5.1F, 3.9F};
  glow.roughness = 0.6F;
  stage.add_object("lamp_panel", slab_at({0.0F, kHeight - 0.062F, kLampZ}, {0.36F, 0.008F, 0.26F}, 0.006F),
                   stage.add_material(glow));
  Mesh frame;
  for (const float side : {-1.0F, 1.0F}) {
    append(frame, slab_at({0.0F, kHeight - 0.04F, kLampZ + side * 0.275F}, {0.385F, 0.040F, 0.016F}, 0.006F));
    append(frame, slab_at({side * 0.372F, kHeight - 0.04F, kLampZ}, {0.016F, 0.040F, 0.275F}, 0.006F));
  }
  stage.add_object("lamp_frame", frame, brass);
}

void add_seats(Stage& stage, int walnut) {
  const Mat4 chair = Placement{{-0.48F, 0.0F, 0.62F}, {0.0F, 2.55F, 0.0F}}.matrix();
  stage.add_object("chair", chair_frame(), walnut, chair);
  stage.add_object("chair_seat", chair_seat(), stage.add_plain("leather", swatch(0x6A2E22), 0.42F), chair);
  const Mat4 armchair = Placement{{1.10F, 0.0F, -0.98F}, {0.0F, -0.50F, 0.0F}}.matrix();
  stage.add_object("armchair", armchair_mesh(), stage.add_plain("velvet", swatch(0x2F5660), 0.72F), armchair);
  stage.add_object("armchair_feet", armchair_feet(), walnut, armchair);
  Mesh pillow = cushion({0.20F, 0.19F, 0.045F}, 0.028F, 0.60F);
  stage.add_object("pillow", pillow, stage.add_plain("ochre_cloth", swatch(0xC48A36), 0.85F),
                   armchair * Placement{{0.08F, 0.63F, -0.12F}, {-0.30F, 0.25F, 0.20F}}.matrix());
}

void add_table(Stage& stage, int walnut) {
  const Vec3 place{-0.62F, 0.0F, -0.10F};
  stage.add_object("table", table_mesh(0.50F), walnut, Placement{place}.matrix());
  const Vec3 top = place + Vec3(-0.06F, 0.7415F, -0.05F);
  stage.add_object("bowl", bowl_mesh(), stage.add_textured("celadon", bowl_painting(256, 128), 0.22F),
                   Placement{top, {0.0F, 0.0F, 0.0F}, Vec3(1.25F)}.matrix());
  const int peel = stage.add_textured("orange", orange_painting(256, 128), 0.42F,
                                      stage.add_texture("orange_pores", orange_pores(256, 128)));
  const int orange = stage.add_mesh(orange_mesh());
  stage.add_object("orange_1", orange, peel,
                   Placement{top + Vec3(-0.035F, 0.026F, 0.020F), {0.4F, 0.0F, 0.2F}}.matrix());
  stage.add_object("orange_2", orange, peel,
                   Placement{top + Vec3(0.042F, 0.026F, 0.012F), {0.1F, 2.0F, 0.5F}}.matrix());
  stage.add_object("orange_3", orange, peel,
                   Placement{top + Vec3(0.000F, 0.026F, -0.050F), {0.9F, 1.0F, 0.1F}}.matrix());
  Mesh books = slab_at({0.0F, 0.016F, 0.0F}, {0.075F, 0.016F, 0.105F}, 0.004F, 0.2F);
  stage.add_object("book_on_table", books, stage.add_plain("green_binding", swatch(0x2E4A38), 0.6F),
                   Placement{place + Vec3(0.22F, 0.7415F, 0.12F), {0.0F, 0.5F, 0.0F}}.matrix());
}

void add_shelf(Stage& stage, int walnut) {
  constexpr int kBoards = 6;
  constexpr float kWidth = 1.15F;
  const Mat4 place = Placement{{-kHalfX + 0.165F, 0.0F, -0.55F}, {0.0F, static_cast<float>(0.5 * kPi), 0.0F}}.matrix();
  stage.add_object("bookcase", bookcase_mesh(kWidth, kBoards), walnut, place);
  const Vec3 bindings[] = {swatch(0x7A2A24), swatch(0x2C3F5C), swatch(0x3F5236),
                           swatch(0xB09A6A), swatch(0x4A3226), swatch(0xA8682E)};
  const float gap = board_height(1, kBoards) - board_height(0, kBoards) - 0.024F;
  for (int color = 0; color < 6; ++color) {
    Mesh books;
    for (int board = 0; board + 1 < kBoards; ++board) {
      const float end = board == 2 ? 0.18F : 0.0F;  // one board is only half full
      Mesh row = books_on_board(0.5F * kWidth - 0.02F - end, gap, color, 6, static_cast<std::uint64_t>(40 + board));
      for (Vec3& p : row.positions) p += Vec3(-end, board_height(board, kBoards), 0.11F);
      append(books, row);
    }
    const std::string name = "books_" + std::to_string(color + 1);
    stage.add_object(name, books, stage.add_plain(name, bindings[color], 0.55F), place);
  }
}

void add_walls_decor(Stage& stage, int walnut) {
  const int gilt = stage.add_plain("gilt", {0.83F, 0.62F, 0.30F}, 0.32F, 1.0F);
  const Mat4 mirror = Placement{{0.10F, 1.52F, -kHalfZ + 0.014F}}.matrix();
  stage.add_object("mirror", mirror_glass(0.36, 0.52),
                   stage.add_plain("silver", Vec3(0.95F, 0.95F, 0.94F), 0.02F, 1.0F), mirror);
  stage.add_object("mirror_frame", mirror_frame(0.36, 0.52), gilt, mirror);
  const Vec3 center{-1.18F, 1.62F, -kHalfZ + 0.012F};
  Mesh canvas = panel(center + Vec3(-0.27F, -0.20F, 0.004F), {0.54F, 0.0F, 0.0F}, {0.0F, 0.40F, 0.0F}, 1.0F);
  for (Vec2& uv : canvas.uvs) uv = {uv.x / 0.54F, 1.0F - uv.y / 0.40F};
  stage.add_object("painting", canvas, stage.add_textured("landscape", landscape_painting(384, 288), 0.5F));
  Mesh frame;
  for (const float side : {-1.0F, 1.0F}) {
    append(frame, slab_at(center + Vec3(0.0F, side * 0.215F, 0.0F), {0.305F, 0.022F, 0.018F}, 0.007F, 0.9F));
    append(frame, slab_at(center + Vec3(side * 0.285F, 0.0F, 0.0F), {0.022F, 0.215F, 0.017F}, 0.007F, 0.9F));
  }
  stage.add_object("painting_frame", frame, walnut);
}

void add_plant(Stage& stage) {
  const Mat4 place = Placement{{0.22F, 0.0F, -1.44F}}.matrix();
  stage.add_object("pot", pot_mesh(), stage.add_plain("terracotta", swatch(0xA85C3A), 0.75F), place);
  stage.add_object("plant_leaves", leaves_mesh(22, 9), stage.add_textured("leaf", leaf_painting(128, 256), 0.38F),
                   place);
  stage.add_object("plant_stems", plant_stems(22, 9), stage.add_plain("plant_stem", swatch(0x5E6A3A), 0.7F), place);
}

}  // namespace

Scene build_room() {
  Stage stage;
  const int relief = stage.add_texture("wood_relief", wood_relief(384, 192, {0.9, 0.45}));
  const int oak = stage.add_textured("oak", wood_painting(768, 384, swatch(0xA67C50), swatch(0x6E4A2A)), 0.42F, relief);
  const int walnut =
      stage.add_textured("walnut", wood_painting(512, 256, swatch(0x6E4426), swatch(0x351D10)), 0.36F, relief);
  add_shell(stage, oak);
  add_lamp(stage);
  stage.add_object("rug", rug_mesh(1.15F, 0.77F), stage.add_textured("rug", rug_painting(512, 340), 0.95F),
                   Placement{{-0.25F, 0.0F, 0.15F}}.matrix());
  add_table(stage, walnut);
  add_seats(stage, walnut);
  add_shelf(stage, walnut);
  add_walls_decor(stage, walnut);
  add_plant(stage);
  stage.add_camera("corner", {1.93F, 1.42F, 1.66F}, {-0.45F, 1.13F, -1.0F}, 0.98F);
  return stage.take();
}

}  // namespace luminist
